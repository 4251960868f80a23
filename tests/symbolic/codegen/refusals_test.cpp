// SPDX-License-Identifier: GPL-2.0-or-later
// What the generator must not accept: each finding of the audit of its forerunner, and each guard
// of the reader, of plain and exact forms and doublings, too; at edges from both sides.

#include "catch.hpp"
#include "codegen/emit.hpp"
#include "codegen/errors.hpp"
#include "kernel/names.hpp"

namespace {
using namespace kernel;
using codegen::Case;
using codegen::Doubling;
using codegen::Interval;
using codegen::PlainForm;
using codegen::Quantity;

const Expr alpha = real("alpha"), m = integer("m");
constexpr double below_1 = 0x1.fffffffffffffp-1;

/// |- fresh(params) = term
Theorem definition(Expr term, const Exprs& params = {alpha}) {
  static int count = 0;
  return define("q" + std::to_string(++count) + "_", params, term);
}
Quantity quantity(const Theorem& output, Interval range = {0x1p-20, below_1}) {
  return {"test", "none", {{alpha, range, range}}, {Case{"only", {}, {}, {output}, {}, {}}}};
}
codegen::Analysis analysis(const Quantity& q) {
  codegen::Plan plan;
  return codegen::analyse(codegen::lower(q, q.cases[0], codegen::Numbers::doubles),
                          {0x1p-53, &codegen::tiers()[1]}, plan);
}
double bound(const Quantity& q) {
  const codegen::Program p = codegen::lower(q, q.cases[0], codegen::Numbers::doubles);
  codegen::Plan plan;
  return codegen::Absorber(p, plan).bounded(analysis(q).outputs.at(0));
}
void refuses(const Quantity& q, const std::string& why) {
  CHECK_THROWS_WITH(analysis(q), ContainsSubstring(why));
}
PlainForm form(const Theorem& output, Interval range, const std::string& name = "closed") {
  return {quantity(output, range), name};
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

TEST_CASE("H1: an arctangent of what has no relative bound is refused, not called exact") {
  const Theorem x = definition(1 / (2 + alpha) - Expr(1) / Expr(4));
  const Theorem square = definition(power(x.conclusion().arg(0), 2));
  Quantity q = quantity(definition(atan(x.conclusion().arg(0))), {1, 3});
  q.cases[0].definitions = {x, square};
  const Expr equation = eq(power(x.conclusion().arg(0), 2), square.conclusion().arg(0));
  q.cases[0].facts = {{equation, "its definition"}};
  refuses(q, "no relative error bound");
  q.inputs[0].range = {1, 1.5};  // the difference is at least 1/28 there
  CHECK(analysis(q).outputs.size() == 1);
}
TEST_CASE("what has no relative bound divides only where it is tested") {
  const Theorem y = definition(1 / (2 + alpha) - Expr(1) / Expr(4));
  const Expr of_y = y.conclusion().arg(0);
  const auto over = [&](Expr above, double least = 0x1p-90) {
    Quantity q = quantity(definition(above / of_y), {1, 2});
    q.cases[0].definitions = {y};
    q.cases[0].facts = {{le(Expr(codegen::exact(least)), of_y), "a test"}};
    return q;
  };
  Quantity q = over(1);
  refuses(q, "no relative error bound");
  q.cases[0].divisors = {of_y.name()};
  CHECK(analysis(q).outputs.at(1).begin()->second > 0x1p23 * 0x1p-110);
  q.cases[0].facts.clear();  // MPFR's errors are far smaller than this least value
  CHECK_THAT(codegen::emit_evaluator(q).header,
             ContainsSubstring("doubt_of_sign(" + of_y.name() + ", "));
  q.cases[0].divisors.push_back("nobody");
  refuses(q, "a divisor nobody, which has no definition");
  Quantity other = over(alpha);
  other.cases[0].divisors = {of_y.name()};
  refuses(other, "a quotient of no constant");
  other = over(1, 0x1p-60);
  other.cases[0].divisors = {of_y.name()};
  refuses(other, "may be below its range and pass the test");
}
TEST_CASE("H2: a rational that is no double has its error") {
  CHECK(bound(quantity(definition(alpha / 4))) == 0);
  CHECK(bound(quantity(definition(alpha / 3))) > 0x1p-108);
  CHECK(bound(quantity(definition(alpha + Expr(1) / Expr(10)))) > 0x1p-112);
  CHECK(bound(quantity(definition(alpha + Expr(1) / Expr(8)))) == 0);
  CHECK(bound(quantity(definition(3 * alpha))) > 0);  // its low part's rounding
}
TEST_CASE("H3: ranges are data, and emitted as guards") {
  Quantity q = quantity(definition(1 + alpha), {0.5, 3});
  q.has_arrays = true;
  const std::string header = codegen::emit_evaluator(q).header;
  CHECK_THAT(header, ContainsSubstring("in.alpha >= 0x1p-1 && in.alpha <= 0x1.8p+1"));
  CHECK_THAT(header, ContainsSubstring("(alpha >= 0x1p-1) & (alpha <= 0x1.8p+1)"));
}
TEST_CASE("H4: a theorem's hypotheses must follow from the intervals") {
  const Theorem one = definition(1 + alpha);
  const auto with = [&](Expr hypothesis, Interval range) {
    return quantity(tautology(one.conclusion(), {one, assume(hypothesis)}), range);
  };
  CHECK_NOTHROW(analysis(with(lt(0, alpha), {0x1p-20, 1})));
  refuses(with(lt(0, alpha), {0, 1}), "do not give 0 < alpha");
  CHECK_NOTHROW(analysis(with(lt(alpha, 1), {0, below_1})));
  refuses(with(lt(alpha, 1), {0, 1}), "do not give alpha < 1");
  CHECK_NOTHROW(analysis(with(le(alpha, 1), {0, 1})));
  CHECK_NOTHROW(analysis(with(logic_and({le(0, alpha), le(alpha, 2)}), {0, 1})));
  refuses(with(logic_and({le(0, alpha), le(2, alpha)}), {0, 1}), "do not give");
  CHECK_NOTHROW(analysis(with(eq(alpha, 1), {1, 1})));
  refuses(with(eq(alpha, 1), {1, 2}), "do not give alpha = 1");
  refuses(with(le(alpha, real("beta")), {0, 1}), "do not give");
  refuses(with(logic_not(lt(alpha, 0)), {0, 1}), "do not give");
}
TEST_CASE("an input may stand as a number where its interval is that point") {
  Quantity q = quantity(instantiate(definition(alpha * m, {alpha, m}), {{m, 1}}));
  q.inputs.push_back({m, {0, 5}, {0, 5}});
  q.cases[0].where = {{"m", {1, 1}}};
  CHECK_NOTHROW(analysis(q));
  q.cases[0].where = {{"m", {1, 2}}};
  refuses(q, "1 is no input here");
}
TEST_CASE("M3: a fact about exact values is not used of computed ones that are too far off") {
  const Theorem x = definition(1 - alpha);
  const Theorem y = definition(Expr(1) / Expr(3) - alpha * alpha);
  Quantity q = quantity(definition(x.conclusion().arg(0) * y.conclusion().arg(0)));
  q.cases[0].definitions = {y, x};
  q.inputs[0].range = {0.25, 0.58};
  const Expr fact = le(y.conclusion().arg(0), x.conclusion().arg(0));
  q.cases[0].facts = {{fact, "a test"}, {le(0, y.conclusion().arg(0)), "alpha^2 < 1/3"}};
  refuses(q, "a fact is not known of computed values");
  q.cases[0].facts[0].of_computed = "a test";
  CHECK_NOTHROW(analysis(q));
}
TEST_CASE("what is no definition, input or operation is refused with its name") {
  const auto term = [](Expr t) { return quantity(definition(t)); };
  const Expr beta = real("beta");
  refuses(quantity(definition(beta + alpha, {alpha, beta})), "beta is no input");
  refuses(term(definition(alpha).conclusion().arg(0) + alpha), "no definition of");
  refuses(quantity(assume(lt(alpha, 1))), "not of the form name(params) = term");
  refuses(term(sqrt(alpha - 2)), "reciprocal root of what may be negative");
  refuses(term(1 / (alpha - Expr(1) / Expr(2))), "a divisor that may be 0");
  refuses(term(sin(4 * alpha)), "from 0 to 3 pi/4");
  refuses(term(atan(alpha)), "an arctangent needs a fact about the square");
  refuses(term(ceil(alpha + Expr(1) / Expr(3))), "ceil(p/q + c)");
  refuses(term(ceil(1 / (alpha * alpha * alpha))), "2^51 or more");
  Quantity unused = term(1 + alpha);
  unused.cases[0].guards = {{"nobody", {0, 1}}};
  refuses(unused, "a guard on nobody");
  unused.cases[0].guards.clear();
  unused.cases[0].where = {{"nobody", {0, 1}}};
  refuses(unused, "a condition on nobody");
  unused.cases[0].where = {{"alpha", {2, 3}}};
  refuses(unused, "nothing in common");
  unused.cases[0].where.clear();
  unused.cases[0].facts = {{le(alpha, 1), "a test"}};
  refuses(unused, "a fact that no definition is about");
}
TEST_CASE("what may over- or underflow is refused, at the edge from both sides") {
  const Theorem square = definition(alpha * alpha);
  CHECK_NOTHROW(analysis(quantity(square, {0x1p-440, 0x1p440})));
  refuses(quantity(square, {0x1p-460, 1}), "over- or underflow");
  refuses(quantity(square, {1, 0x1p460}), "over- or underflow");
  Quantity zero = quantity(definition(1 + alpha * alpha), {0x1p-440, 1});
  zero.inputs[0].may_be_zero = true;
  CHECK_THAT(codegen::emit_evaluator(zero).header,
             ContainsSubstring("(in.alpha == 0 || in.alpha >= 0x1p-440) && in.alpha <= 0x1p+0"));
  refuses(PlainForm{zero, "closed"}, "may be 0 in evaluators of single numbers alone");
  zero.inputs[0].range.low = 0x1p-460;
  refuses(zero, "over- or underflow");
  Quantity whole = quantity(definition(m + m, {m}));
  whole.inputs = {{m, {0, 0x1p50 - 1}, {0, 0x1p63}}};
  CHECK_NOTHROW(codegen::lower(whole, whole.cases[0], codegen::Numbers::doubles));
  whole.inputs[0].range = {0, 0x1p50 + 1};
  refuses(whole, "may be above 2^51");
  whole.inputs[0].range = {0, 0x1.0000000000001p51};
  refuses(whole, "m may be above 2^51");
}
TEST_CASE("names do not collide, and cases agree on outputs") {
  const Theorem doubt = define("doubt", {alpha}, 1 + alpha);
  Quantity q = quantity(definition(doubt.conclusion().arg(0) * alpha));
  q.cases[0].definitions = {doubt};
  refuses(q, "two values are called doubt");
  Quantity two = quantity(definition(1 + alpha));
  two.cases.push_back(quantity(definition(2 + alpha)).cases[0]);
  CHECK_THROWS_WITH(codegen::emit_evaluator(two), ContainsSubstring("not have the same outputs"));
}
TEST_CASE("a form that is negative or not a number is refused") {
  codegen::Form f;
  CHECK_THROWS_WITH(codegen::add(f, {{{}, -1.0}}), ContainsSubstring("negative or not a number"));
  CHECK_THROWS_WITH(codegen::add(f, {{{}, NAN}}), ContainsSubstring("negative or not a number"));
  codegen::add(f, {{{}, 0.0}});
  CHECK(f.empty());
}
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
  CHECK_THROWS_WITH(codegen::emit_plain({form(definition(1 + alpha), {0, 1})}, {}, {"speed"}),
                    ContainsSubstring("no output is called speed"));
}
TEST_CASE("a doubling needs its four theorems in their shape, and what they need to hold") {
  const Theorem at_0 = assume(eq(f(0), 1)), at_1 = assume(eq(f(1), alpha));
  const Theorem even = assume(eq(f(2 * m), 2 * power(f(m), 2) - 1));
  const Theorem odd = assume(eq(f(2 * m + 1), 2 * f(m) * f(m + 1) - f(1)));
  const PlainForm any = form(definition(1 + alpha), {0, 1}, "exact");
  // The hypotheses of these are their conclusions: only a domain that knows of them takes them.
  const auto known = [](Expr) { return Interval{0, 0}; };
  const codegen::Domain knowing{any.quantity, any.quantity.cases[0], false, known};
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
