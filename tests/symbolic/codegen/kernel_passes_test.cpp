// SPDX-License-Identifier: GPL-2.0-or-later
// The passes that are for kernels: what each promises, and that no value changes, on programs by hand and at random.
#include <algorithm>
#include <cstdint>
#include <map>
#include <random>

#include <catch2/catch.hpp>
#include <cln/rational.h>

#include "codegen/ir.hpp"
#include "codegen/passes/common_subexpressions.hpp"
#include "codegen/passes/flat_products.hpp"
#include "codegen/passes/half_arcsecants.hpp"
#include "codegen/passes/reciprocal_square_roots.hpp"
#include "codegen/passes/secants_of_parts.hpp"
#include "codegen/passes/shared_products.hpp"
#include "codegen/passes/turned_differences.hpp"

using namespace magicmass::codegen;
using cln::cl_RA;

namespace {

struct Builder {
  Program program = {};
  int input(const char* name) { return append(program, {.op = Op::input, .name = name}); }
  int constant(std::int64_t above, std::int64_t below = 1) {
    return append(program, {.op = Op::constant, .numerator = above, .denominator = below});
  }
  int make(Op op, std::vector<int> args) {
    return append(program, {.op = op, .args = std::move(args)});
  }
  Builder& output(const char* name, int node) {
    program.outputs.push_back({name, node, "theorem"});
    return *this;
  }
};

/// Roots stand for themselves plus 1000, so that they are rational and no two of them are mixed up.
cl_RA value(const Program& program, int number, const std::map<std::string, cl_RA>& inputs) {
  const Node& node = program.nodes[static_cast<std::size_t>(number)];
  std::vector<cl_RA> args;
  for (const int argument : node.args) args.push_back(value(program, argument, inputs));
  cl_RA result = 0;
  switch (node.op) {
    case Op::input:
      return inputs.at(node.name);
    case Op::constant:
      return cl_RA(static_cast<long>(node.numerator)) / static_cast<long>(node.denominator);
    case Op::add:
      for (const cl_RA& x : args) result = result + x;
      return result;
    case Op::multiply:
      result = 1;
      for (const cl_RA& x : args) result = result * x;
      return result;
    case Op::negate:
      return -args[0];
    case Op::reciprocal:
      return 1 / args[0];
    case Op::square_root:
      return args[0] + 1000;
    case Op::reciprocal_square_root:
      return 1 / (args[0] + 1000);
    default:
      FAIL("no value of this operation here");
      return result;
  }
}

std::vector<cl_RA> values(const Program& program) {
  const std::map<std::string, cl_RA> inputs{
      {"x", cl_RA(3) / 7}, {"y", cl_RA(11)}, {"z", cl_RA(-5) / 13}};
  std::vector<cl_RA> all;
  for (const Output& output : program.outputs) all.push_back(value(program, output.node, inputs));
  return all;
}

int count(const Program& program, Op op) {
  return static_cast<int>(std::count_if(program.nodes.begin(), program.nodes.end(),
                                        [op](const Node& node) { return node.op == op; }));
}

std::string shown(const Program& program, std::size_t output = 0) {
  return formula(program, program.outputs[output].node);
}

/// Sums, products, reciprocals, roots of what came before, with constants in between.
Program random_program(std::mt19937_64& generator) {
  Builder build;
  std::vector<int> known{build.input("x"), build.input("y"), build.input("z")};
  const auto pick = [&] { return known[generator() % known.size()]; };
  for (int i = 0; i < 14; ++i) {
    const auto kind = generator() % 9;
    if (kind == 0)
      known.push_back(build.constant(static_cast<std::int64_t>(generator() % 9) - 4,
                                     static_cast<std::int64_t>(generator() % 3) + 1));
    else if (kind == 1)
      known.push_back(build.make(Op::add, {pick(), pick()}));
    else if (kind == 2)
      known.push_back(build.make(Op::reciprocal, {build.make(Op::square_root, {pick()})}));
    else if (kind == 3)
      known.push_back(build.make(Op::multiply, {pick(), pick(), pick(), build.constant(2)}));
    else if (kind == 4)
      known.push_back(build.make(Op::negate, {pick()}));
    else
      known.push_back(build.make(Op::multiply, {pick(), pick()}));
  }
  build.output("f", known.back()).output("g", pick()).output("h", pick());
  return build.program;
}

bool has_nested_product(const Program& program) {
  const std::vector<int> uses = use_counts(program);
  for (const Node& node : program.nodes) {
    if (node.op != Op::multiply) continue;
    for (const int argument : node.args)
      if (program.nodes[static_cast<std::size_t>(argument)].op == Op::multiply &&
          uses[static_cast<std::size_t>(argument)] == 1)
        return true;
  }
  return false;
}

/// Products have one constant at most, in front, which is not 1 and in lowest terms.
bool has_loose_constants(const Program& program) {
  for (const Node& node : program.nodes) {
    if (node.op != Op::multiply) continue;
    for (std::size_t i = 0; i < node.args.size(); ++i) {
      const Node& factor = program.nodes[static_cast<std::size_t>(node.args[i])];
      if (factor.op != Op::constant) continue;
      if (i > 0 || (factor.numerator == 1 && factor.denominator == 1)) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("the reciprocal of a square root becomes one operation", "[exam]") {
  Builder build;
  const int x = build.input("x"), root = build.make(Op::square_root, {x});
  build.output("f", build.make(Op::reciprocal, {root}));
  const Program alone = reciprocal_square_roots(build.program);
  CHECK(shown(alone) == "1/sqrt(x)");
  CHECK((count(alone, Op::reciprocal_square_root) == 1 && count(alone, Op::square_root) == 0));
  CHECK(operation_counts(alone).square_roots == 1);
  CHECK(operation_counts(alone).divisions == 0);
  build.output("g", root);
  const Program both = reciprocal_square_roots(build.program);
  CHECK((count(both, Op::reciprocal_square_root) == 1 && count(both, Op::square_root) == 1));
  CHECK(values(both) == values(build.program));
}

TEST_CASE("a product used once, in a product, becomes part of it, and constants become one",
          "[exam]") {
  Builder build;
  const int x = build.input("x"), y = build.input("y");
  const int inner = build.make(Op::multiply, {build.constant(4), x});
  build.output("f", build.make(Op::multiply, {build.constant(1, 2), y, inner}));
  const Program flat = flat_products(build.program);
  CHECK(shown(flat) == "2*y*x");
  CHECK(operation_counts(flat).multiplications == 2);
  CHECK(values(flat) == values(build.program));
  build.output("g", inner);  // used twice: stays
  CHECK(shown(flat_products(build.program)) == "(1/2)*y*4*x");
  CHECK(has_nested_product(build.program) == false);
}

TEST_CASE("constants that cancel leave no trace, and those alone stay", "[exam]") {
  Builder build;
  const int x = build.input("x");
  build.output("f", build.make(Op::multiply, {build.constant(2), x, build.constant(1, 2)}))
      .output("g", build.make(Op::multiply, {build.constant(2), build.constant(3, 4)}))
      .output("h", build.make(Op::multiply, {build.constant(-1), x, build.constant(2, -6)}));
  const Program flat = flat_products(build.program);
  CHECK(shown(flat) == "x");
  CHECK(shown(flat, 1) == "3/2");
  CHECK(values(flat) == values(build.program));
}

TEST_CASE("a product of some of another's factors is computed once", "[exam]") {
  Builder build;
  const int x = build.input("x"), y = build.input("y"), z = build.input("z");
  build.output("f", build.make(Op::multiply, {x, y}))
      .output("g", build.make(Op::multiply, {build.constant(2), x, z, y}));
  const Program shared = shared_products(build.program);
  CHECK(operation_counts(build.program).multiplications == 4);
  CHECK(operation_counts(shared).multiplications == 3);
  CHECK(values(shared) == values(build.program));
  // x y is no part of x x z
  Builder other;
  const int a = other.input("x"), b = other.input("y"), c = other.input("z");
  other.output("f", other.make(Op::multiply, {a, b}))
      .output("g", other.make(Op::multiply, {a, a, c}));
  CHECK(operation_counts(shared_products(other.program)).multiplications == 3);
}

TEST_CASE("kernel passes keep every value of random programs and what they promise", "[check]") {
  std::mt19937_64 generator(131);
  int nested = 0, loose = 0, fewer = 0, turned_round = 0;
  for (int i = 0; i < 2000; ++i) {
    const Program program = random_program(generator);
    std::vector<cl_RA> before;
    try {
      before = values(program);
    } catch (const cln::runtime_exception&) {
      continue;  // a reciprocal of 0
    }
    const Program rooted = reciprocal_square_roots(program);
    REQUIRE(values(rooted) == before);
    for (const Node& node : rooted.nodes)
      if (node.op == Op::reciprocal)
        REQUIRE(rooted.nodes[static_cast<std::size_t>(node.args[0])].op != Op::square_root);
    const Program flat = flat_products(flat_products(rooted));
    REQUIRE(values(flat) == before);
    REQUIRE_FALSE(has_nested_product(flat));
    REQUIRE_FALSE(has_loose_constants(flat));
    nested += has_nested_product(rooted) ? 1 : 0;
    loose += has_loose_constants(rooted) ? 1 : 0;
    const Program unshared = common_subexpressions(flat);
    const Program shared = shared_products(unshared);
    REQUIRE(values(shared) == before);
    REQUIRE(operation_counts(shared).multiplications <= operation_counts(unshared).multiplications);
    fewer += operation_counts(shared).multiplications < operation_counts(unshared).multiplications;
    const Program turned = turned_differences(shared);
    REQUIRE(values(turned) == before);
    REQUIRE(operation_counts(turned).additions == operation_counts(shared).additions);
    turned_round += count(turned, Op::negate) < count(shared, Op::negate) ? 1 : 0;
  }
  CHECK(nested > 300);
  CHECK(loose > 300);
  CHECK(fewer > 20);
  CHECK(turned_round > 20);
}

TEST_CASE("a difference that is only wanted with a minus is turned round", "[exam]") {
  const auto after = [](bool is_product, bool has_other_use, bool is_twice_negative) {
    Builder b;
    const int difference = b.make(Op::add, {b.input("x"), b.make(Op::negate, {b.input("y")})});
    int minus = b.make(
        Op::negate, {is_product ? b.make(Op::multiply, {b.input("z"), difference}) : difference});
    b.program.nodes[static_cast<std::size_t>(difference)].name = "difference";
    b.program.nodes[static_cast<std::size_t>(minus)].name = "minus";
    if (is_twice_negative) minus = b.make(Op::negate, {minus});
    b.output("f", minus);
    if (has_other_use) b.output("g", difference);
    const Program program = turned_differences(b.program);
    const Node& made = program.nodes[static_cast<std::size_t>(program.outputs[0].node)];
    return shown(program) + (made.name.empty() ? "" : ", " + made.name);
  };
  CHECK(after(false, false, false) == "y - x, minus");  // "difference" was another number
  CHECK(after(true, false, false) == "z*(y - x), minus");
  CHECK(after(false, true, false) == "-difference, minus");
  CHECK(after(false, false, true) == "-minus");  // by its name
  CHECK(after(false, true, true) == "x - y, difference");
}

TEST_CASE("1/cos(pi/m) - 1 is one operation, and nothing like it is", "[exam]") {
  const auto after = [](int sign, int of_cosine, bool has_pi, std::int64_t above) {
    Builder b;
    const int m = b.input("m"), inverse = b.make(Op::reciprocal, {m});
    std::vector<int> factors{b.constant(above, 2), inverse};
    if (has_pi) factors.insert(factors.begin() + 1, b.make(Op::pi, {}));
    const int angle = b.make(Op::multiply, factors);
    const int turned = b.make(of_cosine != 0 ? Op::cosine : Op::sine, {angle});
    int one = b.constant(1);
    if (sign < 0) one = b.make(Op::negate, {one});
    b.output("y", b.make(Op::add, {b.make(Op::reciprocal, {turned}), one}));
    const Program program = secants_of_parts(b.program);
    return program.nodes[static_cast<std::size_t>(program.outputs[0].node)].op ==
                   Op::secant_less_one
               ? formula(program, program.outputs[0].node)
               : "as it was";
  };
  CHECK(after(-1, 1, true, 1) == "1/cos(pi/(2*m)) - 1");
  CHECK(after(1, 1, true, 1) == "as it was");
  CHECK(after(-1, 0, true, 1) == "as it was");
  CHECK(after(-1, 1, false, 1) == "as it was");
  CHECK(after(-1, 1, true, 3) == "as it was");
}

TEST_CASE("the one arctangent becomes half an arcsecant of alpha, its tangent kept", "[exam]") {
  Builder b;
  const int tangent = b.make(Op::multiply, {b.input("alpha"), b.input("cotangent")});
  const int angle = b.make(Op::arctangent, {tangent});
  b.output("psi", b.make(Op::multiply, {b.constant(4), angle}));
  CHECK_THROWS_WITH(half_arcsecants(b.program), "an arctangent of something else than tan_quarter");
  b.program.nodes[static_cast<std::size_t>(tangent)].name = "tan_quarter";
  const Program program = half_arcsecants(b.program);
  CHECK(formula(program, program.outputs[0].node) == "4*(asec(1 + alpha)/2)");
  const auto made = std::find_if(program.nodes.begin(), program.nodes.end(),
                                 [](const Node& node) { return node.op == Op::half_arcsecant; });
  REQUIRE(made != program.nodes.end());
  CHECK(formula(program, made->args[1]) == "alpha*cotangent");

  b.output("other", b.make(Op::arctangent, {tangent}));
  CHECK_THROWS_WITH(half_arcsecants(b.program), "a program has 2 arctangents");
}
