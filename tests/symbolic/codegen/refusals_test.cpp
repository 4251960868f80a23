// What the generator must not accept: each finding of the audit of its forerunner, and each guard
// of the reader, of plain and exact forms and doublings, too; at edges from both sides.

#include "codegen/emit.hpp"
#include "codegen/errors.hpp"
#include "generate/quantities.hpp"
#include "kernel/names.hpp"
#include "notation/typed.hpp"
#include "rows.hpp"

namespace {
using namespace kernel;
using codegen::Case;
using codegen::Doubling;
using codegen::Interval;
using codegen::Quantity;

const Expr alpha = real("alpha"), m = integer("m");
constexpr double below_1 = 0x1.fffffffffffffp-1;

/// |- fresh(params) = term
Theorem definition(Expr term, const Exprs& params = {alpha}) {
  static int count = 0;
  return define("q" + std::to_string(++count) + "_", params, term);
}
Quantity quantity(const Theorem& output, Interval range = {0x1p-20, below_1},
                  const Theorems& definitions = {}) {
  return {"test", "none", {{alpha, range, range}}, {Case{"only", {}, definitions, {output}}}};
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
/// The same conclusion under more hypotheses.
Theorem under(Exprs hypotheses, const Theorem& t) {
  Theorems from{t};
  for (Expr h : hypotheses) from.push_back(assume(h));
  return tautology(t.conclusion(), from);
}
void refuses(const Quantity& q, const std::string& why) {
  CHECK_THROWS_WITH(analysis(q), ContainsSubstring(why));
}

Expr f(Expr index) { return fun("doubled", {alpha, index}); }
}  // namespace

TEST_CASE("H1: an arctangent of what has no relative bound is refused, not called exact") {
  const Theorem x = definition(1 / (2 + alpha) - Expr(1) / Expr(4));
  const Theorem square = definition(power(x.conclusion().arg(0), 2));
  Quantity q = quantity(definition(atan(x.conclusion().arg(0))), {1, 3}, {x, square});
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
    Quantity q = quantity(definition(above / of_y), {1, 2}, {y});
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
TEST_CASE("what is refused, in which range and as what, is as in refusals.tsv; H4 among it") {
  real("beta");
  const Theorem one = definition(1 + alpha);
  for (const auto& row : rows_of("symbolic/codegen/refusals.tsv", 5, 34)) {
    INFO(row[0] << " " << row[1] << " from " << row[2] << " to " << row[3]);
    const Expr given = notation::read(row[1]);
    const Interval range{std::stod(row[2]), std::stod(row[3])};
    const auto act = [&] {
      if (row[0] == "hypothesis")
        analysis(quantity(under({given}, one), range));
      else if (row[0] == "evaluator")
        analysis(quantity(definition(given), range));
      else
        codegen::emit_plain({{quantity(definition(given), range), row[0]}}, {});
    };
    REQUIRE_FALSE(row[4].empty());
    CHECK_THAT(refusal<std::exception>(act), ContainsSubstring(row[4]));
  }
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
  const Theorem product = definition(x.conclusion().arg(0) * y.conclusion().arg(0));
  Quantity q = quantity(product, {0.25, 0.58}, {y, x});
  const Expr fact = le(y.conclusion().arg(0), x.conclusion().arg(0));
  q.cases[0].facts = {{fact, "a test"}, {le(0, y.conclusion().arg(0)), "alpha^2 < 1/3"}};
  refuses(q, "a fact is not known of computed values");
  q.cases[0].facts[0].of_computed = "a test";
  CHECK_NOTHROW(analysis(q));
  q.cases[0].facts[0] = tautology(fact, {assume(logic_and({fact, le(alpha, 0)}))});
  refuses(q, "the intervals do not give");
}
TEST_CASE("what is no definition, input or operation is refused with its name") {
  const Expr beta = real("beta");
  refuses(quantity(definition(beta + alpha, {alpha, beta})), "beta is no input");
  refuses(quantity(definition(definition(alpha).conclusion().arg(0) + alpha)), "no definition of");
  refuses(quantity(assume(lt(alpha, 1))), "not of the form name(params) = term");
  Quantity unused = quantity(definition(1 + alpha));
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
  Quantity zero = quantity(definition(1 + alpha * alpha), {0x1p-440, 1});
  zero.inputs[0].may_be_zero = true;
  CHECK_THAT(codegen::emit_evaluator(zero).header,
             ContainsSubstring("(in.alpha == 0 || in.alpha >= 0x1p-440) && in.alpha <= 0x1p+0"));
  CHECK_THROWS_WITH(codegen::emit_plain({{zero, "closed"}}, {}),
                    ContainsSubstring("may be 0 in evaluators of single numbers alone"));
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
  refuses(quantity(definition(doubt.conclusion().arg(0) * alpha), {0.5, 1}, {doubt}),
          "two values are called doubt");
  Quantity two = quantity(definition(1 + alpha));
  CHECK_THROWS_WITH(codegen::emit_plain({{two, "closed"}}, {}, {"speed"}),
                    ContainsSubstring("no output is called speed"));
  two.cases.push_back(quantity(definition(2 + alpha)).cases[0]);
  const auto same_outputs = ContainsSubstring("not have the same outputs");
  CHECK_THROWS_WITH(codegen::emit_evaluator(two), same_outputs);
  CHECK_THROWS_WITH(codegen::emit_plain({{two, "closed"}}, {}), same_outputs);
}
TEST_CASE("a form that is negative or not a number is refused") {
  codegen::Form f;
  CHECK_THROWS_WITH(codegen::add(f, {{{}, -1.0}}), ContainsSubstring("negative or not a number"));
  CHECK_THROWS_WITH(codegen::add(f, {{{}, NAN}}), ContainsSubstring("negative or not a number"));
  codegen::add(f, {{{}, 0.0}});
  CHECK(f.empty());
}
TEST_CASE("a doubling needs its four theorems in their shape, and what they need to hold") {
  const Theorem f_is = define("doubled", {alpha, m}, alpha * m);
  using Shares = std::vector<std::pair<Expr, Expr>>;
  const auto by = [&](Expr goal, const Shares& shares) {  // of f at each index
    Certificate c;
    for (const auto& [share, i] : shares)
      c.equations.push_back({share, instantiate(f_is, {{m, i}})});
    return arithmetic(goal, c);
  };
  const Theorem at_0 = by(eq(f(0), 0), {{1, 0}}), at_1 = by(eq(f(1), alpha), {{1, 1}});
  const Theorem even = by(eq(f(2 * m), 2 * f(m)), {{1, 2 * m}, {-2, m}});
  const Theorem odd = by(eq(f(2 * m + 1), f(m) + f(m + 1)), {{1, 2 * m + 1}, {-1, m}, {-1, m + 1}});
  const codegen::PlainForm any{quantity(definition(1 + alpha), {0, 1}), "exact"};
  const codegen::Domain knowing{any.quantity, any.quantity.cases[0], false, [](Expr) {
                                  return Interval{0, 0};
                                }};
  const codegen::Domain plain{any.quantity, any.quantity.cases[0], false,
                              [](Expr) -> Interval { throw codegen::Refused("not known"); }};
  const Doubling right{at_0, at_1, even, odd};
  CHECK_THAT(codegen::emit_doubling(right, plain), ContainsSubstring("high = Number(2) * high"));
  const Theorem late = under({le(1, m)}, even);
  const Theorem ahead = by(eq(f(2 * m), 2 * f(m + 1) - 2 * alpha), {{1, 2 * m}, {-2, m + 1}});
  const auto refuses_even = [&](const Theorem& other, const codegen::Domain& d,
                                const std::string& why) {
    CHECK_THROWS_WITH(codegen::emit_doubling({at_0, at_1, other, odd}, d), ContainsSubstring(why));
  };
  refuses_even(late, plain, "do not give");
  refuses_even(late, knowing, "not for every m");
  refuses_even(ahead, plain, "no definition of");
  refuses_even(by(eq(f(m * 2), 2 * f(m)), {{1, m * 2}, {-2, m}}), plain, "not f at 0");
  for (const Doubling& wrong : {Doubling{at_1, at_1, even, odd}, Doubling{at_0, at_0, even, odd},
                                Doubling{at_0, at_1, odd, odd}, Doubling{at_0, at_1, even, even}})
    CHECK_THROWS_WITH(codegen::emit_doubling(wrong, plain), ContainsSubstring("not f at 0"));
  codegen::Builder terms(codegen::Numbers::field), negative = terms;
  CHECK_THROWS_WITH(codegen::call_doubling(right, f(3 * m), terms), ContainsSubstring("2*x + 1"));
  negative.nodes[m] = negative.input("m", true, {-1, 9});
  CHECK_THROWS_WITH(codegen::call_doubling(right, f(2 * m), negative),
                    ContainsSubstring("2*x + 1"));
  terms.nodes[m] = terms.input("m", true, {0, 9});
  CHECK(codegen::call_doubling(right, f(2 * m) + f(2 * m + 1), terms).find("doubled_at_m") !=
        std::string::npos);
}
TEST_CASE("an input stands in its own place, once") {
  const Expr beta = real("beta");
  const Theorem difference = definition(alpha - beta, {alpha, beta});
  const auto at = [&](Expr first, Expr second) {
    Quantity q = quantity(instantiate(difference, {{alpha, first}, {beta, second}}), {3, 3});
    q.inputs.push_back({beta, {1, 2}, {1, 2}});
    return q;
  };
  CHECK_NOTHROW(analysis(at(alpha, beta)));
  CHECK_NOTHROW(analysis(at(3, beta)));
  refuses(at(beta, alpha), "beta is no input here");
  refuses(at(beta, beta), "beta is no input here");
  refuses(at(alpha, alpha), "alpha is no input here");
  refuses(at(alpha, 3), "3 is no input here");
  const Expr other = real("gamma");  // no input
  refuses(quantity(instantiate(definition(alpha - other, {alpha, other}), {{other, alpha}})),
          "alpha is no input here");
}
TEST_CASE("pow and turn are what a theorem says that they are, and of powers no range is known") {
  const auto all = generate::evaluators();
  const Theorems recursions = std::ranges::find(all, "restitution", &Quantity::name)->recursions;
  Quantity q = quantity(definition(1 + fun("pow", {alpha, 5}) * fun("turn", {5})));
  refuses(q, "no definition of");
  q.recursions = recursions;
  CHECK_NOTHROW(analysis(q));
  for (const Theorem& other : {assume(recursions[0].conclusion()), definition(alpha)}) {
    q.recursions = {recursions[1], other};
    refuses(q, "no recursion of pow or turn");
  }
  q = quantity(under({le(fun("pow", {alpha, 5}), 1)}, definition(1 + alpha)));
  q.recursions = recursions;
  refuses(q, "do not give pow_5(alpha) <= 1");
}
TEST_CASE("exact forms, which test no number, need no more than its sign; plain ones no divisor") {
  const Theorem one = definition(1 + alpha);
  const auto emitted = [&](Expr hypothesis, Interval range, const std::string& form) {
    Quantity q = quantity(under({hypothesis}, one), range);
    if (form == "closed") q.cases[0].divisors = {"one"};
    return codegen::emit_plain({{q, form}}, {}).header;
  };
  CHECK_THAT(emitted(lt(0, alpha), {0.5, 1}, "exact"), ContainsSubstring("Domain: alpha > 0."));
  CHECK_THAT(emitted(le(0, 1), {-1, 1}, "exact"), ContainsSubstring("Domain: alpha any."));
  CHECK_THROWS_WITH(emitted(le(alpha, 1), {0.5, 1}, "exact"), ContainsSubstring("do not give"));
  CHECK_THROWS_WITH(emitted(le(Expr(1) / 4, alpha), {0.5, 1}, "exact"),
                    ContainsSubstring("do not give"));
  CHECK_THROWS_WITH(emitted(lt(0, alpha), {0.5, 1}, "closed"), ContainsSubstring("alone"));
}
