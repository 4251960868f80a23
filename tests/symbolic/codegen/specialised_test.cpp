// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "codegen/specialised_kernel.hpp"
#include "magicmass/errors.hpp"
#include "whole_derivation.hpp"

using namespace magicmass::codegen;

namespace {

const std::vector<magicmass::proof::Theorem>& theorems() { return whole_derivation().theorems; }

Specialised made(const std::vector<std::string>& names) {
  const std::vector<QuantityGroup> groups = grouped(names);
  REQUIRE(groups.size() == 1);
  return specialised(groups[0], theorems());
}

int operations(const Program& program) {
  const OperationCounts counts = operation_counts(program);
  return counts.additions + counts.multiplications + counts.divisions + counts.square_roots +
         counts.sine_cosine_pairs + counts.sines_or_cosines + counts.arctangents;
}

// Nodes that no output needs.
int superfluous(const Program& program) {
  std::set<int> needed;
  for (const Output& output : program.outputs) needed.insert(output.node);
  for (auto i = static_cast<int>(program.nodes.size()); i-- > 0;)
    if (needed.contains(i))
      for (const int argument : program.nodes[static_cast<std::size_t>(i)].args)
        needed.insert(argument);
  return static_cast<int>(program.nodes.size() - needed.size());
}

const Program& program_of(const Specialised& one) { return one.kernel.at(0).program; }

const std::vector<std::vector<std::string>> sets{{"a", "b", "c", "c_prime"},
                                                 {"a_t", "b_t", "c_t", "rho"},
                                                 {"t", "s"},
                                                 {"alpha_k", "beta_k"},
                                                 {"psi"}};

}  // namespace

TEST_CASE("a quantity that the paper does not have is refused by its name", "[exam]") {
  CHECK_THROWS_AS(grouped({"none"}), magicmass::InvalidInput);
  CHECK_THROWS_WITH(grouped({"rho", "none"}), "no quantity is called none");
}

TEST_CASE("a part of the outputs costs less than all, and nothing that is no part of them",
          "[exam][shared]") {
  CHECK(operations(program_of(made({"a_t", "rho"}))) <
        operations(program_of(made({"a_t", "b_t", "c_t", "rho"}))));
  for (const std::vector<std::string>& set : sets) {
    const int all = operations(program_of(made(set)));
    CHECK(superfluous(program_of(made(set))) == 0);
    // every subset but the empty one
    for (unsigned bits = 1; bits < (1U << set.size()); ++bits) {
      std::vector<std::string> names;
      for (unsigned i = 0; i < set.size(); ++i)
        if ((bits >> i & 1U) != 0) names.push_back(set[i]);
      const Specialised part = made(names);
      INFO(part.name());
      CHECK(program_of(part).outputs.size() == names.size());
      CHECK(superfluous(program_of(part)) == 0);
      CHECK(operations(program_of(part)) <= all);
    }
  }
}

TEST_CASE("shared values are computed once", "[exam][shared]") {
  const OperationCounts counts = operation_counts(program_of(made({"a", "b", "c", "c_prime"})));
  CHECK(counts.square_roots == 1);
  CHECK(counts.arctangents == 1);
  CHECK(counts.sine_cosine_pairs == 1);
  const auto apart = [](const char* name) { return operations(program_of(made({name}))); };
  CHECK(operations(program_of(made({"a", "b"}))) < apart("a") + apart("b") - 5);
  // psi comes with the others for the price of a multiplication at most
  CHECK(operations(program_of(made({"a_t", "psi"}))) <= apart("a_t") + 1);
}

TEST_CASE("an operation that no output needs is seen", "[exam][shared]") {
  Program program = program_of(made({"a_t", "rho"}));
  const int before = operations(program);
  append(program, {.op = Op::add, .args = {0, 0}});
  CHECK(superfluous(program) == 1);
  CHECK(operations(program) == before + 1);
}

TEST_CASE("the header says its own count, and does not depend on the order of the names",
          "[exam][shared]") {
  const auto header = [](const std::vector<std::string>& names) {
    return specialised_header(grouped(names), "", "a command", {}, theorems());
  };
  const GeneratedFile file = header({"a_t", "rho"});
  CHECK(file.path == "magicmass/a_t_rho.hpp");
  CHECK(file.content == header({"rho", "a_t", "rho"}).content);
  CHECK_THAT(
      file.content,
      Catch::Contains("Cost: " + to_text(operation_counts(program_of(made({"rho", "a_t"}))))));
  for (const char* words : {"offset.rho", "offset.a_after_Q", "tangent.first_a",
                            "Domain:", "Error:", "// Compile with: ", "`a command`"})
    CHECK_THAT(file.content, Catch::Contains(words));
  CHECK_THAT(file.content, !Catch::Contains("c_t"));
}

TEST_CASE("quantities are grouped by their inputs", "[exam][shared]") {
  CHECK(grouped({"t", "a"}).size() == 2);
  CHECK(grouped({"a", "psi", "t"}).size() == 2);
  CHECK(grouped({"psi", "alpha_k"}).size() == 2);
  CHECK(grouped({"psi", "N_A"}).size() == 1);
  CHECK(made({"N_A"}).kernel.empty());
  CHECK_THROWS_WITH(grouped({"a_n"}), Catch::Contains("a_n"));
  const GeneratedFile both = specialised_header(grouped({"t", "a"}), "both", "", {}, theorems());
  CHECK_THAT(both.content, Catch::Contains("namespace a {") && Catch::Contains("namespace t {"));
}
