// From theorems to C++: the velocities of the blocks through the generator.
#include <cstdio>
#include <numeric>
#include <sstream>

#include "codegen/emit.hpp"
#include "generate/quantities.hpp"

using codegen::Program;

// Velocities as a program of single operations, for mass ratios from `least` on.
Program lowered(generate::Source& source, const std::string& theorems, double least) {
  const codegen::Interval masses{least, 0x1p300}, cycles{0, 0x1p50};
  const std::vector<codegen::Input> inputs{{kernel::real("alpha"), masses, masses},
                                           {kernel::integer("n"), cycles, cycles}};
  const codegen::Case all =
      source.of("all", {}, "rotation.psi power.V_CM -> " + theorems, source.units);
  return codegen::lower({"velocities", "", inputs, {all}, source.units}, all,
                        codegen::Numbers::plain);
}
// How many nodes there would be if each were written down as often as it is used.
int typed_out(const Program& p) {
  std::vector<int> times(p.nodes.size(), 0);
  for (const codegen::Result& r : p.results) ++times[std::size_t(r.node)];
  for (int k = p.size(); k-- > 0;)
    for (const int operand : p[k].of) times[std::size_t(operand)] += times[std::size_t(k)];
  return std::accumulate(times.begin(), times.end(), 0);
}
void print_block(const char* name, const std::string& text) {
  std::printf("%s:\n", name);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) std::printf("  %s\n", line.c_str());
}

int main() {
  generate::Source source;
  // Change the outputs here: to power.a power.b, the paper's own forms, or to power.c_product.
  const Program both = lowered(source, "power.a_product power.b_product", 0x1p-300);
  std::printf("typed_out: %d\nnodes: %d\n", typed_out(both), both.size());
  print_block("both", codegen::broken(codegen::PlainText(both).lines()));
  std::printf("nodes_of_b: %d\n", lowered(source, "power.b_product", 0x1p-300).size());
  try {
    lowered(source, "power.b_product", -1);
  } catch (const codegen::Refused& refused) {
    std::printf("refused: %s\n", refused.what());
  }
  // What each value of the library's own evaluator may be off by, in its tier accurate.
  const std::string errors = codegen::emit_evaluator(generate::evaluators()[0]).errors;
  print_block("bounds", errors.substr(1, errors.find("\n\n") - 1));
}
