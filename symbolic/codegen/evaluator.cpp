// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/evaluator.hpp"

#include <algorithm>
#include <stdexcept>

#include <ginac/ginac.h>

#include "codegen/lower.hpp"
#include "codegen/passes/canonical_order.hpp"
#include "codegen/passes/common_subexpressions.hpp"
#include "codegen/passes/dead_code.hpp"
#include "codegen/passes/paired_sine_cosine.hpp"
#include "codegen/passes/shared_reciprocals.hpp"
#include "codegen/passes/strength_reduction.hpp"

namespace magicmass::codegen {
namespace {

// All outputs through the passes that do not depend on which are wanted ...
Program prepared(const Program& lowered) {
  return common_subexpressions(strength_reduction(common_subexpressions(canonical_order(lowered))));
}

// ... and these through those that do.
Program finished(const Program& program, const std::vector<std::string>& wanted) {
  return paired_sine_cosine(shared_reciprocals(dead_code(program, wanted)));
}

const proof::Theorem& named(const std::vector<proof::Theorem>& theorems, const std::string& id) {
  const auto found =
      std::find_if(theorems.begin(), theorems.end(),
                   [&id](const proof::Theorem& theorem) { return theorem.id() == id; });
  if (found == theorems.end()) throw std::out_of_range("no theorem is called " + id);
  return *found;
}

void require_one_right_side(const proof::Theorem& one, const proof::Theorem& other) {
  if (!one.rhs().is_equal(other.rhs()))
    throw std::logic_error(one.id() + " and " + other.id() +
                           " are to be cases of one formula, but their right sides differ");
}

}  // namespace

Evaluator make_evaluator(const Form& form, const std::vector<proof::Theorem>& theorems) {
  Evaluator evaluator{form, {}, {}, {}, {}};
  Source source{{}, {}, form.real_inputs, form.indices, {"V", "L"}};
  std::vector<std::string> names;
  for (const FormOutput& output : form.outputs) {
    std::vector<proof::Theorem> cases{named(theorems, output.theorem)};
    for (const std::string& id : output.other_cases) {
      cases.push_back(named(theorems, id));
      require_one_right_side(cases.front(), cases.back());
    }
    source.outputs.emplace_back(output.name, cases.front());
    evaluator.outputs.push_back(std::move(cases));
    names.push_back(output.name);
  }
  for (const std::string& id : form.bindings) {
    const proof::Theorem& binding = named(theorems, id);
    for (const proof::Theorem& earlier : evaluator.bindings)
      if (earlier.lhs().is_equal(binding.lhs())) require_one_right_side(earlier, binding);
    evaluator.bindings.push_back(binding);
    source.bindings.push_back(binding);
  }
  const Program program = prepared(lower(source));
  evaluator.program = finished(program, names);
  for (const std::string& name : names) evaluator.single.push_back(finished(program, {name}));
  return evaluator;
}

}  // namespace magicmass::codegen
