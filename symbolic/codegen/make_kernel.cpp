// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/make_kernel.hpp"

#include <algorithm>
#include <stdexcept>

#include <ginac/ginac.h>

#include "codegen/lower.hpp"
#include "codegen/pipelines.hpp"
#include "magicmass/errors.hpp"
#include "proof/names.hpp"

namespace magicmass::codegen {

using GiNaC::ex;
using proof::Theorem;

const Theorem& theorem_named(const std::vector<Theorem>& theorems, const std::string& id) {
  const auto found = std::find_if(theorems.begin(), theorems.end(),
                                  [&id](const Theorem& theorem) { return theorem.id() == id; });
  if (found == theorems.end()) throw InvalidInput("no theorem is called " + id);
  return *found;
}

namespace {

constexpr const char* kept_names[] = {"cot_half", "tan_quarter", "psi", "r_t"};

// One formula is emitted for all cases of an output.
void require_same_right_side(const Source& source, const std::string& member,
                             const Theorem& other) {
  for (const auto& [name, theorem] : source.outputs) {
    if (name != member) continue;
    if (theorem.rhs().is_equal(other.rhs())) return;
    throw std::logic_error(theorem.id() + " and " + other.id() + " have different right sides");
  }
  throw std::logic_error("no output is called " + member + ", of which " + other.id() +
                         " is to be a case");
}

// All sines and cosines replaced: a kernel has one of each.
ex turned(const ex& form, const ex& sine, const ex& cosine) {
  return form.subs(GiNaC::lst{sin(GiNaC::wild()) == sine, cos(GiNaC::wild()) == cosine});
}

// With names for products written out. The angle keeps its name, and so do the root and the tangent, which are others
// from alpha = 1 on.
ex written_out(const std::vector<Theorem>& bindings, ex right) {
  const auto stays = [](const ex& name) {
    return std::any_of(std::begin(kept_names), std::end(kept_names),
                       [&](const char* kept) { return name.is_equal(proof::symbol(kept)); });
  };
  for (std::size_t round = 0; round <= bindings.size(); ++round) {  // a name may stand for others
    const ex before = right;
    for (const Theorem& named : bindings)
      if (!stays(named.lhs())) right = right.subs(named.lhs() == named.rhs());
    if (right.is_equal(before)) return right;
  }
  throw std::logic_error("the names that a kernel binds stand for each other");
}

// The outputs' right sides with what the kernel puts in from alpha = 1 on.
void require_first(const KernelForm& form, const std::vector<Theorem>& bindings,
                   const Theorem& theorem, const Theorem& first) {
  const ex alpha = proof::symbol("alpha"), share = 1 / (1 + alpha);
  const ex cot_half = proof::symbol("cot_half"), tan_quarter = proof::symbol("tan_quarter");
  const auto beyond = [&](const ex& from) {
    return from.subs(GiNaC::lst{cot_half == share, tan_quarter == alpha * share});
  };
  const bool has_index = !form.first_index.empty();
  const ex right = written_out(bindings, theorem.rhs());
  if (!(beyond(turned(right, has_index ? ex(1) : share, has_index ? share : ex(1))) - first.rhs())
           .normal()
           .is_zero())
    throw std::logic_error(theorem.id() + " does not become " + first.id() + " from alpha = 1 on");
  const ex before = turned(right, 0, 1);
  if (has_index && !(beyond(before) - before).normal().is_zero())
    throw std::logic_error(theorem.id() + " is another number before the first collisions");
}

// What has to hold in every case of an output has a theorem for each.
void require_one_a_case(const KernelForm& form, const std::vector<std::string>& ids,
                        const std::string& of_what) {
  std::size_t cases = 1;
  for (const auto& [member, others] : form.other_cases) cases = std::max(cases, 1 + others.size());
  if (!ids.empty() && ids.size() != cases)
    throw std::logic_error(form.name + " has not one theorem a case " + of_what);
}

// r_t is turn times something and not negative.
void require_not_negative(const KernelForm& form, const std::vector<Theorem>& theorems) {
  require_one_a_case(form, form.not_negative, "of an r_t that is not negative");
  for (const std::string& id : form.not_negative) {
    const Theorem& least = theorem_named(theorems, id);
    const bool is_bound = least.statement().relation() == proof::Relation::less_equal &&
                          least.lhs().is_zero() && least.rhs().is_equal(proof::symbol("r_t"));
    if (!is_bound) throw std::logic_error(id + " does not say that r_t is not negative");
  }
}

// The sine and the cosine may be those of a small angle, and the root that of alpha (2 + alpha).
void require_small(const KernelForm& form, const std::vector<Theorem>& theorems) {
  require_one_a_case(form, form.small_angle, "of a small r_t");
  const ex quarter = proof::symbol("psi") / 4;
  for (const std::string& id : form.small_angle) {
    const Theorem& most = theorem_named(theorems, id);
    const bool is_bound = most.statement().relation() == proof::Relation::less_equal &&
                          most.lhs().is_equal(proof::symbol("r_t")) && most.rhs().is_equal(quarter);
    if (!is_bound) throw std::logic_error(id + " does not say that r_t is psi/4 at most");
  }
}
void require_root(const std::vector<Theorem>& bindings) {
  const ex alpha = proof::symbol("alpha");
  for (const Theorem& named : bindings)
    if (named.lhs().is_equal(proof::symbol("cot_half")) &&
        !named.rhs().is_equal(1 / sqrt(alpha * (2 + alpha))))
      throw std::logic_error(named.id() + " has another root than alpha (2 + alpha)");
}

// psi/4 is atan t by one theorem and asec(1 + alpha)/2 by the other.
void require_arcsecant(const Source& source, const Theorem& cosine) {
  const ex psi = proof::symbol("psi");
  if (!cosine.lhs().is_equal(cos(psi / 2)) ||
      !(cosine.rhs() * (1 + proof::symbol("alpha"))).normal().is_equal(1))
    throw std::logic_error(cosine.id() + " does not say that cos(psi/2) is 1/(1 + alpha)");
  const ex angle = 4 * atan(proof::symbol("tan_quarter"));
  const auto says = [&](const Theorem& theorem) {
    return theorem.lhs().is_equal(psi) && theorem.rhs().is_equal(angle);
  };
  if (!std::any_of(source.bindings.begin(), source.bindings.end(), says) &&
      !std::any_of(source.outputs.begin(), source.outputs.end(),
                   [&](const auto& output) { return says(output.second); }))
    throw std::logic_error("nothing says that psi is 4 atan(tan_quarter)");
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
    for (const std::string& id : ids)
      require_same_right_side(source, member, theorem_named(theorems, id));
  for (std::size_t i = 0; i < form.first.size(); ++i)
    require_first(form, source.bindings, source.outputs.at(i).second,
                  theorem_named(theorems, form.first[i]));
  require_small(form, theorems);
  require_not_negative(form, theorems);
  if (!form.not_negative.empty()) source.sign = "turn";
  if (form.rounds_results) require_root(source.bindings);
  if (form.arcsecant.empty()) return {form, for_kernel(lower(source))};
  require_arcsecant(source, theorem_named(theorems, form.arcsecant));
  return {form, for_kernel_with_arcsecant(lower(source))};
}

}  // namespace magicmass::codegen
