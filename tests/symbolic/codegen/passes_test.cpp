// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "codegen/ir.hpp"
#include "codegen/passes/canonical_order.hpp"
#include "codegen/passes/common_subexpressions.hpp"
#include "codegen/passes/dead_code.hpp"
#include "codegen/passes/paired_sine_cosine.hpp"
#include "codegen/passes/shared_products.hpp"
#include "codegen/passes/shared_reciprocals.hpp"
#include "codegen/passes/strength_reduction.hpp"

using namespace magicmass::codegen;

namespace {

// Builds programs by hand: x, y are inputs, numbers are constants.
struct Builder {
  Program program = {};
  int input(const char* name) { return append(program, {.op = Op::input, .name = name}); }
  int constant(int value) { return append(program, {.op = Op::constant, .numerator = value}); }
  int make(Op op, std::vector<int> args) {
    return append(program, {.op = op, .args = std::move(args)});
  }
  int power(int base, int numerator, int denominator = 1) {
    return append(
        program,
        {.op = Op::power, .args = {base}, .numerator = numerator, .denominator = denominator});
  }
  Builder& output(const char* name, int node) {
    program.outputs.push_back({name, node, "theorem"});
    return *this;
  }
};

int count(const Program& program, Op op) {
  return static_cast<int>(std::count_if(program.nodes.begin(), program.nodes.end(),
                                        [op](const Node& node) { return node.op == op; }));
}

std::string shown(const Program& program) { return formula(program, program.outputs[0].node); }

}  // namespace

TEST_CASE("canonical order forgets the order it was given", "[exam]") {
  std::vector<std::string> results;
  std::vector<std::vector<std::string>> nodes;
  for (const bool swapped : {false, true}) {
    Builder build;
    const int x = build.input("x"), y = build.input("y"), two = build.constant(2);
    const int sum = build.make(Op::add, swapped ? std::vector{y, two, x} : std::vector{x, y, two});
    const int sine = build.make(Op::sine, {x});
    build.output("f", build.make(Op::multiply, swapped ? std::vector{sine, sum, two}
                                                       : std::vector{two, sum, sine}));
    const Program ordered = canonical_order(build.program);
    results.push_back(shown(ordered));
    auto& listed = nodes.emplace_back();
    for (int i = 0; i < static_cast<int>(ordered.nodes.size()); ++i)
      listed.push_back(formula(ordered, i));
  }
  CHECK(results[0] == "2*(2 + x + y)*sin(x)");
  CHECK(results[0] == results[1]);
  CHECK(nodes[0] == nodes[1]);
}

TEST_CASE("equal expressions become one, also up to a constant factor", "[exam]") {
  Builder build;
  const int x = build.input("x"), again = build.input("x"), y = build.input("y"),
            two = build.constant(2);
  const int one = build.make(Op::multiply, {x, y}),
            scaled = build.make(Op::multiply, {two, again, y});
  build.output("f", build.make(Op::sine, {one})).output("g", build.make(Op::sine, {scaled}));
  const Program result = common_subexpressions(canonical_order(build.program));
  CHECK(count(result, Op::input) == 2);
  CHECK(count(result, Op::multiply) == 2);  // x y, and 2 (x y)
  CHECK(operation_counts(result).multiplications == 2);
  CHECK(operation_counts(canonical_order(build.program)).multiplications == 3);
}

TEST_CASE("what is known by its name is one only where the name is one", "[exam]") {
  for (const Op op : {Op::ladder_low, Op::ladder_high}) {
    Builder build;
    const int cosine = build.input("c");
    std::vector<int> terms;
    for (const char* index : {"m", "n", "m"})
      terms.push_back(append(build.program, {.op = op, .args = {cosine}, .name = index}));
    build.output("f", build.make(Op::add, terms));
    CHECK(count(common_subexpressions(build.program), op) == 2);
  }
  for (const Op op : {Op::input, Op::index}) {
    Builder build;
    std::vector<int> terms;
    for (const char* name : {"m", "n", "m"})
      terms.push_back(append(build.program, {.op = op, .name = name}));
    build.output("f", build.make(Op::add, terms));
    CHECK(count(common_subexpressions(build.program), op) == 2);
  }
}

TEST_CASE("powers become products and square roots", "[exam]") {
  Builder build;
  const int x = build.input("x");
  build.output("cube", build.power(x, 3))
      .output("root", build.power(x, 1, 2))
      .output("eighth", build.power(x, 8))
      .output("three_halves", build.power(x, 3, 2));
  const Program result = common_subexpressions(strength_reduction(build.program));
  CHECK(count(result, Op::power) == 0);
  CHECK(count(result, Op::square_root) == 1);
  CHECK(operation_counts(result).multiplications ==
        2 + 2 + 1);  // x^2 x; (x^4)^2 on top of x^2; x sqrt x
}

TEST_CASE("one division serves several quotients, and a single one stays a division", "[exam]") {
  Builder build;
  const int x = build.input("x"), y = build.input("y");
  const int inverse = build.make(Op::reciprocal, {y});
  build.output("f", build.make(Op::multiply, {x, inverse}))
      .output("g", build.make(Op::multiply, {inverse, x, x}));
  const Program shared = shared_reciprocals(build.program);
  CHECK(count(shared, Op::reciprocal) == 1);
  CHECK(count(shared, Op::divide) == 0);
  const Program single = shared_reciprocals(dead_code(build.program, {"f"}));
  CHECK(count(single, Op::reciprocal) == 0);
  CHECK(count(single, Op::divide) == 1);
}

TEST_CASE("sine and cosine of one angle stand next to each other", "[exam]") {
  Builder build;
  const int x = build.input("x");
  const int sine = build.make(Op::sine, {x}), between = build.make(Op::square_root, {sine}),
            cosine = build.make(Op::cosine, {x});
  build.output("f", build.make(Op::add, {between, cosine}));
  CHECK(operation_counts(build.program).sine_cosine_pairs == 1);
  const Program result = paired_sine_cosine(build.program);
  const auto at = [&](Op op) {
    return std::find_if(result.nodes.begin(), result.nodes.end(),
                        [op](const Node& node) { return node.op == op; }) -
           result.nodes.begin();
  };
  CHECK(std::abs(at(Op::sine) - at(Op::cosine)) == 1);
  CHECK(shown(result) == shown(build.program));
}

TEST_CASE("only what is wanted is paid for", "[exam]") {
  Builder build;
  const int x = build.input("x");
  build.output("cheap", x).output("dear", build.make(Op::arctangent, {x}));
  CHECK(dead_code(build.program, {"cheap"}).nodes.size() == 1);
  CHECK(dead_code(build.program, {"cheap", "dear"}).nodes.size() == 2);
}

TEST_CASE("a product's part is shared wherever the other product stands", "[exam]") {
  for (const bool part_first : {false, true}) {
    Builder build;
    const int x = build.input("x"), y = build.input("y"), z = build.input("z");
    const auto part = [&] {
      build.output("part", build.make(Op::sine, {build.make(Op::multiply, {x, y})}));
    };
    if (part_first) part();
    build.output("whole", build.make(Op::multiply, {x, z, y}));
    if (!part_first) part();
    CHECK(operation_counts(shared_products(build.program)).multiplications == 2);
    CHECK(operation_counts(build.program).multiplications == 3);
  }
}

TEST_CASE("a power whose exponent is an index is shown and counted, and stays one", "[exam]") {
  Builder build;
  const int k = append(build.program, {.op = Op::index, .name = "k"});
  const int exponent = build.make(Op::add, {k, build.constant(1)});
  build.output("f", build.make(Op::indexed_power, {build.input("e"), exponent}));
  const Program reduced = strength_reduction(common_subexpressions(canonical_order(build.program)));
  CHECK(shown(reduced) == "e^(1 + k)");
  CHECK(count(reduced, Op::indexed_power) == 1);
  CHECK(to_text(operation_counts(reduced)) == "1 addition, 1 power");
}

TEST_CASE("only numbers with a sign or a bar stand in parentheses in a product", "[exam]") {
  const auto product_with = [](int numerator, int denominator) {
    Builder build;
    const int number = append(
        build.program, {.op = Op::constant, .numerator = numerator, .denominator = denominator});
    build.output("f", build.make(Op::multiply, {number, build.input("x")}));
    return shown(build.program);
  };
  CHECK(product_with(3, 1) == "3*x");
  CHECK(product_with(0, 1) == "0*x");
  CHECK(product_with(-3, 1) == "(-3)*x");
  CHECK(product_with(1, 2) == "(1/2)*x");
}
