// SPDX-License-Identifier: GPL-2.0-or-later
// From a theorem to C++: one formula through the generator, pass by pass.
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "codegen/expression.hpp"
#include "codegen/lower.hpp"
#include "codegen/passes/canonical_order.hpp"
#include "codegen/passes/common_subexpressions.hpp"
#include "codegen/passes/dead_code.hpp"
#include "codegen/passes/paired_sine_cosine.hpp"
#include "codegen/passes/shared_reciprocals.hpp"
#include "codegen/passes/strength_reduction.hpp"
#include "derivation/chapters.hpp"

namespace codegen = magicmass::codegen;
namespace derivation = magicmass::derivation;
namespace proof = magicmass::proof;

std::string table_of_stages = "stages:\n  stage | nodes\n";

// What a program in the intermediate form costs at this stage.
void print_stage(const std::string& name, const codegen::Program& program) {
  const std::string nodes = std::to_string(program.nodes.size());
  table_of_stages += "  " + std::string(name == "only_b" ? "b alone" : name) +
                     " | " + nodes + "\n";
  std::printf("%s_nodes: %s\n", name.c_str(), nodes.c_str());
  std::printf("%s_cost: %s\n", name.c_str(),
              codegen::to_text(codegen::operation_counts(program)).c_str());
}

void print_code(const char* name, const codegen::Program& program) {
  const codegen::Emitted code = codegen::emit_expressions(program, "Real");
  std::printf("%s:\n", name);
  const auto print_line = [](const std::string& line) {
    std::istringstream parts(codegen::wrapped(line, 80));
    for (std::string part; std::getline(parts, part);)
      std::printf("  %s\n", part.c_str());
  };
  for (const std::string& line : code.lines) print_line(line);
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    print_line(program.outputs[i].name + " = " + code.outputs[i] + ";");
}

int main() {
  // Only a proved theorem can be turned into code: there is no other way to make
  // a Theorem than to prove it.
  proof::Kernel kernel(
      {.positive = {"M", "M_1", "M_2", "V", "alpha"}, .integer = {}});
  const derivation::Paper paper = derivation::paper();
  const derivation::Laws laws = derivation::conservation_laws();
  derivation::orthogonal(kernel, paper);
  derivation::frame(kernel, paper);
  const auto contact = derivation::contact(kernel, laws, paper);
  const auto cycle = derivation::cycle(kernel, contact, paper);
  const auto rotation = derivation::rotation(kernel, cycle, paper);
  const auto power =
      derivation::power(kernel, laws, contact, cycle, rotation, paper);

  // Change the outputs here: other velocities, or the paper's forms power.a and
  // power.b.
  const codegen::Program lowered =
      codegen::lower({.outputs = {{"a", power.a_product}, {"b", power.b_product}},
                      .bindings = {power.V_CM, rotation.psi_half_angle},
                      .real_inputs = {"alpha"},
                      .index = "n",
                      .units = {"V"}});
  print_stage("lowered", lowered);
  const auto ordered = codegen::canonical_order(lowered);
  std::printf("a_in_order: %s\n",
              codegen::formula(ordered, ordered.outputs[0].node).c_str());
  const auto shared = codegen::common_subexpressions(ordered);
  print_stage("shared", shared);
  const auto reduced =
      codegen::common_subexpressions(codegen::strength_reduction(shared));
  print_stage("reduced", reduced);
  const auto divided =
      codegen::shared_reciprocals(codegen::dead_code(reduced, {"a", "b"}));
  const auto paired = codegen::paired_sine_cosine(divided);
  print_stage("paired", paired);
  print_code("both", paired);

  // Asked for b alone, the dead code goes.
  const auto only_b = codegen::paired_sine_cosine(
      codegen::shared_reciprocals(codegen::dead_code(reduced, {"b"})));
  print_stage("only_b", only_b);
  print_code("code_of_b", only_b);
  std::printf("%s", table_of_stages.c_str());
}
