// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/derived_formulas.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <ginac/ginac.h>

#include "codegen/make_kernel.hpp"
#include "proof/names.hpp"

namespace magicmass::command {
namespace {

void require_no_other_symbol(const GiNaC::ex& formula, const GiNaC::lst& inputs) {
  for (auto part = formula.preorder_begin(); part != formula.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part) && !inputs.has(*part))
      throw std::logic_error("a symbol without a value: " +
                             GiNaC::ex_to<GiNaC::symbol>(*part).get_name());
}

GiNaC::lst symbols_of(const codegen::Form& form) {
  GiNaC::lst symbols;
  for (const std::string& name : inputs_of(form)) symbols.append(proof::symbol(name));
  return symbols;
}

/// An archive brings symbols of its own along.
GiNaC::exmap to_our_symbols(const GiNaC::ex& formulas) {
  GiNaC::exmap map;
  for (auto part = formulas.preorder_begin(); part != formulas.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part))
      map[*part] = proof::symbol(GiNaC::ex_to<GiNaC::symbol>(*part).get_name());
  return map;
}

}  // namespace

std::vector<std::string> inputs_of(const codegen::Form& form) {
  std::vector<std::string> names;
  for (const std::string& name : {form.real_input, form.restitution, form.index})
    if (!name.empty()) names.push_back(name);
  return names;
}

DerivedForm derived_form(const codegen::Form& form, const std::vector<proof::Theorem>& theorems) {
  std::vector<GiNaC::ex> outputs;
  for (const auto& [name, id] : form.outputs) {
    GiNaC::ex formula = codegen::theorem_named(theorems, id).rhs();
    for (std::size_t i = 0; i < form.bindings.size(); ++i)  // one may need another
      for (const std::string& binding : form.bindings) {
        const proof::Theorem& bound = codegen::theorem_named(theorems, binding);
        formula = formula.subs(bound.lhs() == bound.rhs());
      }
    formula = formula.subs(GiNaC::lst{proof::symbol("V") == 1, proof::symbol("L") == 1});
    require_no_other_symbol(formula, symbols_of(form));
    outputs.push_back(formula);
  }
  return {form, std::make_shared<const std::vector<GiNaC::ex>>(std::move(outputs))};
}

std::vector<std::string> outputs_in_python(const DerivedForm& derived) {
  std::vector<std::string> texts;
  for (const GiNaC::ex& formula : *derived.outputs) {
    std::ostringstream text;
    formula.print(GiNaC::print_python(text));
    texts.push_back(text.str());
  }
  return texts;
}

std::vector<DerivedForm> derived_forms(const std::vector<proof::Theorem>& theorems,
                                       const std::vector<std::string>& quantities) {
  std::vector<DerivedForm> all;
  for (const codegen::Form& form : codegen::forms())
    if (!form.exact &&
        std::find(quantities.begin(), quantities.end(), form.quantity) != quantities.end())
      all.push_back(derived_form(form, theorems));
  return all;
}

std::string in_one_line(const std::vector<DerivedForm>& forms) {
  GiNaC::archive archive;
  for (const DerivedForm& one : forms)
    archive.archive_ex(GiNaC::lst(one.outputs->begin(), one.outputs->end()),
                       one.form.function().c_str());
  std::ostringstream bytes;
  bytes << archive;
  std::string line;
  for (const char byte : bytes.str())
    line += fmt::format("{:02x}", static_cast<unsigned>(static_cast<unsigned char>(byte)));
  return line;
}

std::vector<DerivedForm> forms_from_line(const std::string& line) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < line.size(); i += 2)
    bytes += static_cast<char>(std::stoi(line.substr(i, 2), nullptr, 16));
  std::istringstream stream(bytes);
  GiNaC::archive archive;
  stream >> archive;
  std::vector<DerivedForm> all;
  for (unsigned i = 0; i < archive.num_expressions(); ++i) {
    std::string function;
    const GiNaC::ex outputs = archive.unarchive_ex({}, function, i);
    const auto form =
        std::find_if(codegen::forms().begin(), codegen::forms().end(),
                     [&](const codegen::Form& one) { return one.function() == function; });
    const GiNaC::exmap ours = to_our_symbols(outputs);
    std::vector<GiNaC::ex> formulas;
    for (const GiNaC::ex& formula : outputs) formulas.push_back(formula.subs(ours));
    all.push_back({*form, std::make_shared<const std::vector<GiNaC::ex>>(std::move(formulas))});
  }
  return all;
}

}  // namespace magicmass::command
