// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/make_kernel.hpp"

#include <algorithm>
#include <stdexcept>

#include <ginac/ginac.h>

#include "codegen/lower.hpp"
#include "codegen/pipelines.hpp"
#include "proof/names.hpp"

namespace magicmass::codegen {

using GiNaC::ex;
using proof::Theorem;

const Theorem& theorem_named(const std::vector<Theorem>& theorems, const std::string& id) {
  const auto found = std::find_if(theorems.begin(), theorems.end(),
                                  [&id](const Theorem& theorem) { return theorem.id() == id; });
  if (found == theorems.end()) throw std::out_of_range("no theorem is called " + id);
  return *found;
}

namespace {

void require_same_right_side(const Theorem& theorem, const Theorem& other) {
  if (!theorem.rhs().is_equal(other.rhs()))
    throw std::logic_error(theorem.id() + " and " + other.id() + " have different right sides");
}

// All sines and cosines replaced: a kernel has one of each.
ex turned(const ex& form, const ex& sine, const ex& cosine) {
  return form.subs(GiNaC::lst{sin(GiNaC::wild()) == sine, cos(GiNaC::wild()) == cosine});
}

// The outputs' right sides with what the kernel puts in from alpha = 1 on.
void require_first(const KernelForm& form, const Theorem& theorem, const Theorem& first) {
  const ex alpha = proof::symbol("alpha"), share = 1 / (1 + alpha);
  const ex cot_half = proof::symbol("cot_half"), tan_quarter = proof::symbol("tan_quarter");
  const auto beyond = [&](const ex& from) {
    return from.subs(GiNaC::lst{cot_half == share, tan_quarter == alpha * share});
  };
  const bool has_index = !form.first_index.empty();
  const ex& right = theorem.rhs();
  if (!(beyond(turned(right, has_index ? ex(1) : share, has_index ? share : ex(1))) - first.rhs())
           .normal()
           .is_zero())
    throw std::logic_error(theorem.id() + " does not become " + first.id() + " from alpha = 1 on");
  const ex before = turned(right, 0, 1);
  if (has_index && !(beyond(before) - before).normal().is_zero())
    throw std::logic_error(theorem.id() + " is another number before the first collisions");
}

}  // namespace

Kernel make_kernel(const KernelForm& form, const std::vector<Theorem>& theorems) {
  Source source{{}, {}, form.reals, {}, {"V", "L"}};
  for (const auto& more : {form.integers, form.numbers})
    source.real_inputs.insert(source.real_inputs.end(), more.begin(), more.end());
  for (const auto& [name, id] : form.outputs)
    source.outputs.emplace_back(name, theorem_named(theorems, id));
  for (const std::string& id : form.bindings)
    source.bindings.push_back(theorem_named(theorems, id));
  for (const auto& [member, ids] : form.other_cases)
    for (const auto& [name, theorem] : source.outputs)
      if (name == member)
        for (const std::string& id : ids)
          require_same_right_side(theorem, theorem_named(theorems, id));
  for (std::size_t i = 0; i < form.first.size(); ++i)
    require_first(form, source.outputs.at(i).second, theorem_named(theorems, form.first[i]));
  return {form, for_kernel(lower(source))};
}

}  // namespace magicmass::codegen
