// SPDX-License-Identifier: GPL-2.0-or-later
// What plain and exact forms, doublings and the manifest must not accept, at edges from both sides.
#include "catch.hpp"
#include "codegen/emit.hpp"
#include "kernel/names.hpp"

namespace {
using namespace kernel;
using codegen::Case;
using codegen::Doubling;
using codegen::Interval;
using codegen::PlainForm;

const Expr alpha = real("alpha"), m = integer("m");
Theorem definition(Expr term, const Exprs& params = {alpha}) {
  static int count = 0;
  return define("plain" + std::to_string(++count) + "_", params, term);
}
PlainForm form(const Theorem& output, Interval range, const std::string& name = "closed") {
  return {{"test", "none", {{alpha, range, range}}, {Case{"only", {}, {}, {output}, {}, {}}}},
          name};
}
void refuses(const PlainForm& f, const std::string& why) {
  CHECK_THROWS_WITH(codegen::emit_plain({f}, {}), ContainsSubstring(why));
}
void accepts(const PlainForm& f) { CHECK_NOTHROW(codegen::emit_plain({f}, {})); }

/// f_0 = 1, f_1 = alpha, f_(2m) = 2 f_m^2 - 1, f_(2m+1) = 2 f_m f_(m+1) - f_1: assumed, as only
/// their shape matters here.
Expr f(Expr index) {
  if (!is_known("doubled")) declare("doubled", {{Sort::Real, Sort::Int}, Sort::Real});
  return fun("doubled", {alpha, index});
}
}  // namespace

TEST_CASE("a plain form that may over- or underflow is refused") {
  const Theorem square = definition(alpha * alpha);
  accepts(form(square, {0x1.0000000000001p-500, 0x1.fffffffffffffp499}));
  refuses(form(square, {1, 0x1p500}), "test, only: a value of operation ");
  refuses(form(square, {0x1p-500, 1}), "may over- or underflow");
  accepts(form(square, {0, 1}));
  const Theorem less = definition(alpha + -1 * alpha * alpha * alpha);
  refuses(form(less, {1, 0x1p334}), "may over- or underflow");
}
TEST_CASE("a divisor that may be 0 and a root of what may be negative are refused") {
  const Theorem inverse = definition(1 / (alpha - 1));
  accepts(form(inverse, {1.5, 2}));
  CHECK_THROWS(codegen::emit_plain({form(inverse, {0.5, 2})}, {}));
  const Theorem root = definition(sqrt(alpha - 1));
  accepts(form(root, {1.5, 2}));
  refuses(form(root, {0.5, 2}), "negative");
  const Theorem cosine = definition(1 / cos(alpha));
  accepts(form(cosine, {0, 1.57}));
  CHECK_THROWS(codegen::emit_plain({form(cosine, {0, 1.58})}, {}));
}
TEST_CASE("an exact form has the operations of a field") {
  accepts(form(definition(1 / (1 + alpha)), {0x1p-1000, 0x1p1000}, "exact"));
  refuses(form(definition(sqrt(alpha)), {0, 1}, "exact"), "no operation of a field");
  refuses(form(definition(pi() * alpha), {0, 1}, "exact"), "no operation of a field");
  const Theorem one = definition(1 + alpha);
  CHECK_THROWS_WITH(codegen::emit_plain({form(one, {0, 1})}, {}, {"speed"}),
                    ContainsSubstring("no output is called speed"));
}
TEST_CASE("a doubling needs its four theorems in their shape, and what they need to hold") {
  const Theorem at_0 = assume(eq(f(0), 1)), at_1 = assume(eq(f(1), alpha));
  const Theorem even = assume(eq(f(2 * m), 2 * power(f(m), 2) - 1));
  const Theorem odd = assume(eq(f(2 * m + 1), 2 * f(m) * f(m + 1) - f(1)));
  const PlainForm any = form(definition(1 + alpha), {0, 1}, "exact");
  // The hypotheses of these are their conclusions: only a domain that knows of them takes them.
  const codegen::Domain knowing{any.quantity, any.quantity.cases[0], false, [](Expr) {
                                  return Interval{0, 0};
                                }};
  const codegen::Domain plain{any.quantity, any.quantity.cases[0], false,
                              [](Expr) -> Interval { throw codegen::Refused("not known"); }};
  const Doubling right{at_0, at_1, even, odd};
  CHECK_THAT(codegen::emit_doubling(right, knowing), ContainsSubstring("high = Number(2) * (high"));
  CHECK_THROWS_WITH(codegen::emit_doubling(right, plain), ContainsSubstring("do not give"));
  for (const Doubling& wrong : {Doubling{at_1, at_1, even, odd}, Doubling{at_0, at_0, even, odd},
                                Doubling{at_0, at_1, odd, odd}, Doubling{at_0, at_1, even, even},
                                Doubling{at_0, at_1, assume(eq(f(m * 2), f(m))), odd}}) {
    CHECK_THROWS_WITH(codegen::emit_doubling(wrong, knowing), ContainsSubstring("not f at 0"));
  }
  const Doubling ahead{at_0, at_1, assume(eq(f(2 * m), f(m + 1))), odd};
  CHECK_THROWS_WITH(codegen::emit_doubling(ahead, knowing), ContainsSubstring("no definition of"));
  codegen::Builder terms(codegen::Numbers::field);
  CHECK_THROWS_WITH(codegen::call_doubling(right, f(3 * m), terms), ContainsSubstring("2*x + 1"));
  CHECK(codegen::call_doubling(right, f(2 * m) + f(2 * m + 1), terms).find("doubled_at_m") !=
        std::string::npos);
}
