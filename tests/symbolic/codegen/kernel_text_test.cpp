// SPDX-License-Identifier: GPL-2.0-or-later
// From theorems to the text of a kernel; what does not fit together is refused by name.
#include <algorithm>

#include <catch2/catch.hpp>

#include "codegen/emit.hpp"
#include "codegen/kernel_forms.hpp"
#include "codegen/make_kernel.hpp"
#include "codegen/stages.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;
using codegen::KernelForm;
using codegen::Op;

namespace {

const std::vector<proof::Theorem>& theorems() { return whole_derivation().theorems; }

KernelForm form(const std::string& name) {
  const auto& all = codegen::kernel_forms();
  return *std::find_if(all.begin(), all.end(),
                       [&](const KernelForm& one) { return one.name == name; });
}

bool turns_by_an_angle_of_alpha(const KernelForm& one) {
  return std::any_of(one.bindings.begin(), one.bindings.end(), [](const std::string& id) {
    return id == "tangent.root" || id == "tangent.tan_quarter" || id == "transmission.root_h";
  });
}

int times(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a case of an output with another right side is refused, and both are named",
          "[exam][shared]") {
  KernelForm terminal = form("terminal");
  CHECK_NOTHROW(make_kernel(terminal, theorems()));
  terminal.other_cases = {{"a_t", {"offset.a_after_P", "offset.c_after_P"}}};
  CHECK_THROWS_WITH(make_kernel(terminal, theorems()),
                    "offset.a_after_Q and offset.c_after_P have different right sides");
  terminal.other_cases = {{"a_t", {"offset.a_before"}}};
  CHECK_THROWS_WITH(make_kernel(terminal, theorems()), "no theorem is called offset.a_before");
  terminal.other_cases = {{"a", {"offset.a_after_P"}}};
  CHECK_THROWS_WITH(make_kernel(terminal, theorems()),
                    "no output is called a, of which offset.a_after_P is to be a case");
}

TEST_CASE("each kernel asks for no more than its forms need", "[exam][shared]") {
  for (const KernelForm& one : codegen::kernel_forms()) {
    const codegen::Kernel kernel = make_kernel(one, theorems());
    const auto counts = operation_counts(kernel.program);
    INFO(one.name << ": " << to_text(counts));
    const bool has_angle = turns_by_an_angle_of_alpha(one);
    CHECK(counts.square_roots == (has_angle ? 1 : 0));
    CHECK(counts.arctangents == (has_angle ? 1 : 0));
    CHECK(counts.sine_cosine_pairs <= 1);
    if (one.name == "velocities" || one.name == "terminal") CHECK(counts.divisions == 0);
    for (const codegen::Node& node : kernel.program.nodes) {
      CHECK(node.op != Op::power);
      if (node.op == Op::reciprocal)
        CHECK(kernel.program.nodes[static_cast<std::size_t>(node.args[0])].op != Op::square_root);
    }
  }
}

TEST_CASE("a kernel's text cites its theorems and has each stage once", "[exam][shared]") {
  for (const KernelForm& one : codegen::kernel_forms()) {
    const std::string text = emit_kernel(make_kernel(one, theorems()));
    INFO(text);
    for (const auto& [member, id] : one.outputs) CHECK(times(text, id) >= 1);
    for (const std::string& id : one.bindings) CHECK(times(text, id) >= 1);
    CHECK(times(text, "struct " + one.kernel + " {") == 1);
    const bool is_rational = !turns_by_an_angle_of_alpha(one) && one.name != "ratios";
    CHECK(times(text, "void stage_1()") == (is_rational ? 0 : 1));
    // where results are rounded the stages are the caller's
    const bool is_for_one = !one.rounds_results;
    CHECK(times(text, "void first()") == (one.first.empty() || !is_for_one ? 0 : 1));
    CHECK(times(text, " evaluate(") == (is_for_one ? 1 : 0));
    // scaling by a power of two is no multiplication
    CHECK(times(text, "* Real(0.25))") == 0);
    const bool is_in_blocks = !one.result.empty() && one.numbers.empty() && !one.is_single;
    CHECK(times(text, one.name + "_block(std::size_t size") == (is_in_blocks ? 1 : 0));
  }
}

TEST_CASE("a kernel that rounds its results names no number type for them", "[exam][shared]") {
  const std::string rows = emit_kernel(make_kernel(form("velocities_in_rows"), theorems()));
  INFO(rows);
  CHECK(times(rows, "typename Number::Root cot_half;") == 1);
  CHECK(times(rows, "Number::root_argument(alpha, is_beyond)") == 1);
  CHECK(times(rows, "const auto ball_mean = chord * alpha * chord;") == 1);
  CHECK(times(rows, ".a = squared(cosine) - ball_mean * alpha,") == 1);
  CHECK(times(rows, "certain") == 0);
  const std::string last = emit_kernel(make_kernel(form("terminal_in_rows"), theorems()));
  INFO(last);
  CHECK(times(last, " small_sine_cosine(r_t)") == 1);
  CHECK(times(last, "typename Number::Root tan_quarter;") == 1);
  CHECK(times(last, "tan_quarter = Number::half_arcsecant_tangent(alpha);") == 1);
  CHECK(times(last, "typename Number::SmallSine sine;") == 1);
  CHECK(times(last, "const auto product_2 = (sine + product) * sum;") == 1);
  CHECK(times(last, ".b_t = product_2 - momentum_C + Real(1.0),") == 1);
  CHECK(times(last, ".c_t = momentum_C / alpha,") == 1);
  // the sign of the last turn is known, and the counts come from the angle
  CHECK(times(last, "const auto r_t = magnitude(scaled(Number::pi(), 0.5) - angle * ") == 1);
  CHECK(times(last, "turn;") == 0);
  CHECK(times(last, "  count(angles, N_A.data());") == 1);
}

TEST_CASE("a kernel for one number names its types, and has no block", "[exam][shared]") {
  const std::string one = emit_kernel(make_kernel(form("terminal_below_one"), theorems()));
  INFO(one);
  CHECK(times(one, "typename Number::ArcTangent angle;  // asec(1 + alpha)/2") == 1);
  CHECK(times(one, "angle = half_arcsecant(alpha, tan_quarter);") == 1);
  // of B's velocity nothing is left to multiply but the difference that the others have as well
  CHECK(times(one, "const auto b_N_B = Real(1.0) - squared(sum);") == 1);
  CHECK(times(one, ".rho = rounded(Product{b_N_B, b_N_B, 1.0}),") == 1);
  CHECK(times(one, " result() const") == 0);
  CHECK(times(one, "Block") == 0);
  CHECK(times(one, "cstddef") == 0);
}

TEST_CASE("of several factors that which is known last is multiplied last", "[exam][shared]") {
  const codegen::Kernel encounters = make_kernel(form("encounters"), theorems());
  const std::string text = emit_kernel(encounters);
  INFO(text);
  // the quotient, after the sum that it is of, after its summand
  CHECK(times(text, ".t = rounded(Product{sum * product_2, value, 1.0}),") == 1);
  CHECK(times(text, "const auto product = angle * (Real(2.0) * j);") == 1);
  const auto depth = [&](std::size_t output) {
    return codegen::depth_of(encounters.program, encounters.program.outputs[output].node);
  };
  CHECK(depth(0) == depth(1) + 1);
}

TEST_CASE("the velocities after two collisions need one quotient", "[exam][shared]") {
  const std::string text = emit_kernel(make_kernel(form("terminal_from_one"), theorems()));
  INFO(text);
  CHECK(times(text, "scaled(reciprocal(Number::sum(Real(1.0), alpha)), 2.0);") == 1);
  CHECK(times(text, "const auto sum = Real(1.0) - product;") == 1);
  CHECK(times(text, "stage_1") == 0);
  CHECK(times(text, "is_beyond") == 0);
}

TEST_CASE("of square roots a kernel has one, of alpha/(2 + alpha)", "[exam]") {
  codegen::Kernel kernel;
  kernel.form = {.name = "root",
                 .kernel = "RootKernel",
                 .summary = "A root",
                 .domain = "any",
                 .reals = {"alpha"},
                 .outputs = {{"f", "theorem.f"}}};
  const auto text_of_root = [&](std::int64_t constant) {
    codegen::Program program;
    const int alpha = append(program, {.op = Op::input, .name = "alpha"});
    const int two = append(program, {.op = Op::constant, .numerator = constant});
    const int sum = append(program, {.op = Op::add, .args = {two, alpha}});
    const int inverse = append(program, {.op = Op::reciprocal, .args = {sum}});
    const int share = append(program, {.op = Op::multiply, .args = {alpha, inverse}});
    program.outputs = {{"f", append(program, {.op = Op::square_root, .args = {share}}), ""}};
    kernel.program = program;
    return emit_kernel(kernel);
  };
  CHECK(times(text_of_root(2), "Number::half_arcsecant_tangent(alpha)") == 1);
  CHECK_THROWS_WITH(text_of_root(3), "a kernel has no such operation: sqrt(alpha*(1/(3 + alpha)))");
}

TEST_CASE("outputs that are products are handed out unevaluated", "[exam]") {
  codegen::Kernel kernel;
  kernel.form = {.name = "two",
                 .kernel = "TwoKernel",
                 .result = "Two",
                 .summary = "Two outputs",
                 .domain = "any",
                 .reals = {"x"},
                 .outputs = {{"f", "theorem.f"}, {"g", "theorem.g"}}};
  codegen::Program& program = kernel.program;
  const int x = append(program, {.op = Op::input, .name = "x"});
  const int sine = append(program, {.op = Op::sine, .args = {x}});
  const int cosine = append(program, {.op = Op::cosine, .args = {x}});
  const int quarter = append(program, {.op = Op::constant, .numerator = 1, .denominator = 4});
  const int f = append(program, {.op = Op::multiply, .args = {quarter, sine, cosine}});
  const int two = append(program, {.op = Op::constant, .numerator = 2});
  const int g = append(program, {.op = Op::multiply, .args = {two, sine, sine}});
  const int minus_g = append(program, {.op = Op::negate, .args = {g}});
  program.outputs = {{"f", f, "theorem.f"}, {"g", minus_g, "theorem.g"}};
  const std::string products = emit_kernel(kernel);
  INFO(products);
  CHECK(times(products, ".f = {sine, cosine, 0.25},") == 1);
  CHECK(times(products, ".g = {sine, sine, -2.0},") == 1);
  const int h = append(program, {.op = Op::add, .args = {sine, cosine}});
  program.outputs[1] = {"g", h, "theorem.g"};
  const std::string mixed = emit_kernel(kernel);
  CHECK(times(mixed, "Product") == 0);
  CHECK(times(mixed, ".g = sine + cosine,") == 1);
}
