// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/derived_formulas.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <ginac/ginac.h>

#include "proof/names.hpp"

namespace magicmass::command {
namespace {

const proof::Theorem& theorem(const std::vector<proof::Theorem>& theorems, const std::string& id) {
  const auto found = std::find_if(theorems.begin(), theorems.end(),
                                  [&](const proof::Theorem& one) { return one.id() == id; });
  if (found == theorems.end()) throw std::out_of_range("no theorem is called " + id);
  return *found;
}

void require_no_other_symbol(const GiNaC::ex& formula, const GiNaC::lst& inputs) {
  for (auto part = formula.preorder_begin(); part != formula.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part) && !inputs.has(*part))
      throw std::logic_error("a symbol without a value: " +
                             GiNaC::ex_to<GiNaC::symbol>(*part).get_name());
}

}  // namespace

std::vector<std::string> inputs_of(const codegen::Form& form) {
  std::vector<std::string> names = form.real_inputs;
  names.insert(names.end(), form.indices.begin(), form.indices.end());
  return names;
}

std::vector<GiNaC::ex> derived_outputs(const codegen::Form& form,
                                       const std::vector<proof::Theorem>& theorems) {
  GiNaC::lst inputs;
  for (const std::string& name : inputs_of(form)) inputs.append(proof::symbol(name));
  std::vector<GiNaC::ex> outputs;
  for (const codegen::FormOutput& output : form.outputs) {
    GiNaC::ex formula = theorem(theorems, output.theorem).rhs();
    for (std::size_t i = 0; i < form.bindings.size(); ++i)  // one may need another
      for (const std::string& binding : form.bindings) {
        const proof::Theorem& bound = theorem(theorems, binding);
        formula = formula.subs(bound.lhs() == bound.rhs());
      }
    formula = formula.subs(GiNaC::lst{proof::symbol("V") == 1, proof::symbol("L") == 1});
    require_no_other_symbol(formula, inputs);
    outputs.push_back(formula);
  }
  return outputs;
}

std::vector<std::string> derived_outputs_in_python(const codegen::Form& form,
                                                   const std::vector<proof::Theorem>& theorems) {
  std::vector<std::string> texts;
  for (const GiNaC::ex& formula : derived_outputs(form, theorems)) {
    std::ostringstream text;
    formula.print(GiNaC::print_python(text));
    texts.push_back(text.str());
  }
  return texts;
}

}  // namespace magicmass::command
