// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/specialised.hpp"

#include <algorithm>

#include "codegen/expression.hpp"
#include "codegen/make_kernel.hpp"
#include "codegen/specialised_kernel.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::codegen {
namespace {

const KernelForm& form_of(const std::string& kernel) {
  const auto& all = kernel_forms();
  return *std::find_if(all.begin(), all.end(),
                       [&](const KernelForm& form) { return form.name == kernel; });
}

bool is_count(const PaperQuantity& quantity) { return quantity.member.empty(); }

const PaperQuantity& quantity_named(const std::string& name) {
  const auto& all = paper_quantities();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const PaperQuantity& quantity) { return quantity.name == name; });
  if (found == all.end()) throw InvalidInput("no quantity is called " + name);
  return *found;
}

}  // namespace

const std::vector<PaperQuantity>& paper_quantities() {
  static const std::vector<PaperQuantity> all{
      {"a", "alpha and n", "velocities", "a", "velocity of A just after P_n, in units of V"},
      {"b", "alpha and n", "velocities", "b", "velocity of B just after Q_n, in units of V"},
      {"c", "alpha and n", "velocities", "c", "velocity of C just after P_n, in units of V"},
      {"c_prime", "alpha and n", "velocities", "c_prime",
       "velocity of C just after Q_n, in units of V"},
      {"a_t", "alpha", "terminal", "a_t", "velocity of A after the last collision, in units of V"},
      {"b_t", "alpha", "terminal", "b_t", "velocity of B after the last collision, in units of V"},
      {"c_t", "alpha", "terminal", "c_t", "velocity of C after the last collision, in units of V"},
      {"rho", "alpha", "terminal", "rho", "fraction of the energy that B takes"},
      {"N_A", "alpha", "terminal", "", "number of collisions of A and C"},
      {"N_B", "alpha", "terminal", "", "number of collisions of C and B"},
      {"t", "alpha and j", "encounters", "t",
       "time of collision j = 0 (P_1), 1 (Q_1), ... from the first on, in units of L/V"},
      {"s", "alpha and j", "encounters", "s", "distance from A to B then, in units of L"},
      {"alpha_k", "k", "ratios", "magic", "the k-th magic mass ratio"},
      {"beta_k", "k", "ratios", "deficient", "the k-th deficient mass ratio"},
      {"psi", "alpha", "angle", "psi", "angle of one cycle, in rad"},
  };
  return all;
}

std::vector<QuantityGroup> grouped(const std::vector<std::string>& names) {
  for (const std::string& name : names) quantity_named(name);
  std::vector<QuantityGroup> groups;
  for (const PaperQuantity& quantity : paper_quantities()) {
    if (std::find(names.begin(), names.end(), quantity.name) == names.end()) continue;
    const auto goes_with = [&](const QuantityGroup& group) {
      return group[0].kernel == quantity.kernel ||
             (quantity.kernel == "angle" && group[0].kernel != "ratios");
    };
    const auto found = std::find_if(groups.begin(), groups.end(), goes_with);
    if (found == groups.end())
      groups.push_back({quantity});
    else
      found->push_back(quantity);
  }
  return groups;
}

std::string Specialised::name() const {
  std::string joined;
  for (const PaperQuantity& quantity : group) joined += (joined.empty() ? "" : "_") + quantity.name;
  return joined;
}

bool Specialised::has(const std::string& quantity) const {
  return std::any_of(group.begin(), group.end(),
                     [&](const PaperQuantity& each) { return each.name == quantity; });
}

Specialised specialised(const QuantityGroup& group, const std::vector<proof::Theorem>& theorems) {
  // counts alone, or with psi, need no kernel of terminal velocities
  const auto computed = std::find_if_not(group.begin(), group.end(), is_count);
  if (computed == group.end()) return {group, {}};
  KernelForm form = form_of(computed->kernel);
  const KernelForm whole = form;
  form.outputs.clear();
  form.first.clear();
  std::vector<std::string> first;
  for (const PaperQuantity& quantity : group) {
    if (is_count(quantity)) continue;
    const bool is_psi = quantity.kernel == "angle";
    const auto& outputs = (is_psi ? form_of("angle") : whole).outputs;
    const auto output = std::find_if(outputs.begin(), outputs.end(), [&](const auto& each) {
      return each.first == quantity.member;
    });
    form.outputs.emplace_back(quantity.name, output->second);
    const auto row = static_cast<std::size_t>(output - outputs.begin());
    if (!is_psi && row < whole.first.size()) first.push_back(whole.first[row]);
  }
  std::erase_if(form.other_cases, [&form](const auto& cases) {
    return std::none_of(form.outputs.begin(), form.outputs.end(),
                        [&](const auto& output) { return output.first == cases.first; });
  });
  Kernel kernel = make_kernel(form, theorems);
  // what follows from another output, as rho from b_t, has no theorem of its own for the first collisions
  kernel.form.first = first.empty() ? whole.first : first;
  return {group, {kernel}};
}

GeneratedFile specialised_header(const std::vector<QuantityGroup>& groups, const std::string& scope,
                                 const std::string& command,
                                 const std::vector<std::string>& remarks,
                                 const std::vector<proof::Theorem>& theorems) {
  std::vector<Specialised> functions;
  for (const QuantityGroup& group : groups) functions.push_back(specialised(group, theorems));
  bool needs_counts = false, needs_numbers = false, needs_arctangent = false, needs_sine = false;
  for (const Specialised& made : functions) {
    needs_counts = needs_counts || made.group[0].kernel == "terminal";
    needs_numbers = needs_numbers || !made.kernel.empty();
    for (const Kernel& kernel : made.kernel)
      for (const Node& node : kernel.program.nodes) {
        needs_arctangent =
            needs_arctangent || node.op == Op::arctangent || node.op == Op::half_arcsecant;
        needs_sine = needs_sine || node.op == Op::sine || node.op == Op::cosine;
      }
  }
  const auto comment = [](const std::string& text) { return wrapped("// " + text) + "\n"; };
  std::string text = "// SPDX-License-Identifier: MIT\n";
  text += comment("Generated by magicmass " MAGICMASS_VERSION
                  " from proved theorems; do not edit: run");
  text += "// `" + command + "`.\n";
  for (const std::string& remark : remarks) text += comment(remark);
  text += comment("Compile with: -std=c++20 -ffp-contract=off -I generated -I src");
  if (needs_counts) text += comment("Link with: the library magicmass_runtime, which counts");
  text += "#pragma once\n\n#include <cstdint>\n";
  if (needs_counts) text += "#include <optional>\n";
  text += "\n";
  if (needs_arctangent) text += "#include \"magicmass/arithmetic/arctangent.hpp\"\n";
  if (needs_sine) text += "#include \"magicmass/arithmetic/sine_cosine.hpp\"\n";
  if (needs_numbers) text += "#include \"magicmass/arithmetic/tracked.hpp\"\n";
  if (needs_counts) text += "#include \"magicmass/counts.hpp\"\n";
  const std::string name = scope.empty() ? functions[0].name() : scope;
  const std::string around = "magicmass::generated" + (scope.empty() ? "" : "::" + scope);
  text += "\nnamespace " + around + " {\n";
  for (const Specialised& made : functions) text += "\n" + emit_specialised(made);
  return {"magicmass/" + name + ".hpp", text + "\n}  // namespace " + around + "\n"};
}

}  // namespace magicmass::codegen
