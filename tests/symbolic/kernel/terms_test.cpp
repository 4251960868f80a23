// Attacks on terms: names, sorts, bound indices, sizes; matrices: entries, shapes, powers, det.

#include "attack.hpp"
#include "kernel/names.hpp"
#include "kernel/polynomial.hpp"
#include "rows.hpp"

using namespace kernel;

template <class T>
concept makes_expr = requires(T t) {
  Expr(t);
};
template <class T>
concept times_expr = requires(Expr e, T t) {
  e* t;
};
template <class T>
concept is_exponent = requires(Expr e, T t) {
  power(e, t);
};
static_assert(is_exponent<int> && !is_exponent<double> && !is_exponent<long>);
static_assert(makes_expr<int> && makes_expr<cln::cl_RA> && times_expr<int>);
static_assert(!makes_expr<double> && !makes_expr<float> && !times_expr<double>);
static_assert(!makes_expr<long> && !makes_expr<unsigned> && !makes_expr<long long>);
static_assert(!makes_expr<bool> && !makes_expr<char> && !makes_expr<Op> && !makes_expr<Sort>);
static_assert(!makes_expr<const char*> && !makes_expr<std::string>);
// What an accessor gives is a value: nothing of a tree can be changed through it.
static_assert(!std::is_reference_v<decltype(Expr().args())>);
static_assert(!std::is_reference_v<decltype(Expr().arg(0))>);
static_assert(!std::is_reference_v<decltype(Expr().name())>);
static_assert(!std::is_reference_v<decltype(Expr().value())>);

namespace {
// A bound index torn out of its quantifier.
const Expr loose = all(i, eq(i, 0)).arg(0).arg(0);

Expr nested(int depth) {
  Expr e = x;
  for (int k = 0; k < depth; ++k) e = sin(e);
  return e;
}

const Expr a = matrix(2, {1, x, y, 2});
const Expr wide = matrix(3, {1, 2, 3, 4, 5, 6});
const Theorem turn = define("turn", {x}, matrix(2, {cos(x), -sin(x), sin(x), cos(x)}), 0);
Expr turned(Expr by) { return fun("turn", {by}); }
}  // namespace

TEST_CASE("names are identifiers and mean one thing for ever") {
  define("taken", {}, 6);
  const Signature at_index{.args = {Sort::Int}, .result = Sort::Real};
  for (const std::string name : {"height", "step_", "plain"}) declare(name, at_index);
  for (const std::string name : {"depth_3", "depth_n", "plain_k"}) real(name);
  define("tube_3", {}, 1);
  const auto declared = [](const std::string& name, const Signature& s) {
    return [=] { declare(name, s); };
  };
  for (const auto& row : rows_of("symbolic/kernel/names.tsv", 3, 36)) {
    const std::string& name = row[1];
    const std::map<std::string, std::function<void()>> kinds{
        {"real", [&] { real(name); }},
        {"integer", [&] { integer(name); }},
        {"function", [&] { define(name, {}, 1); }},
        {"indexed", declared(name, at_index)}};
    refused(row[0] + " " + name, row[2], kinds.at(row[0]));
  }
  refused("beside one at an index", "prints as step_", declared("step", {.args = {Sort::Real}}));
  refused("h by h_n", "at an index", [&] { define_recursive({"depth"}, {}, n, {x}, {0}, {x}); });
  refused("an unknown function", "no function", [&] { fun("unheard_of", {x}); });
  refused("too many arguments", "another number of arguments", [&] { fun("sin", {x, y}); });
  refused("of formulas", "must be a number", declared("odd", {.args = {Sort::Bool}}));
  refused("a matrix without shape", "does not fit", declared("odd", {.result = Sort::Matrix}));
  refused("9 rows", "does not fit",
          declared("odd", {.result = Sort::Matrix, .rows = 9, .cols = 1}));
  refused("a number with a shape", "does not fit", declared("odd", {.rows = 1, .cols = 1}));
  refused("more hidden than there are", "does not fit", declared("odd", {.params = {x}}));
  refused("a formula's variable", "real or integer",
          made({.op = Op::Var, .name = "formula", .variable = Sort::Bool}));
  CHECK_NOTHROW(real(std::string(60, 'x')));
  CHECK_NOTHROW(real("x'"));
  const Expr v = real(std::string(60, 'v'));
  CHECK(text(all(v, all(v, all(v, eq(v, 0))))).size() > 150);  // two names for it
  CHECK_NOTHROW(real("height_t"));
  CHECK(integer("i") == i);
}

TEST_CASE("sorts are checked wherever a tree is made") {
  const Theorem every = generalize(n, discharge(le(0, n), assume(le(0, n))));
  define("counted", {n}, n);
  for (const auto& row : rows_of("symbolic/kernel/terms.tsv", 2, 29))
    refused(row[1], row[0], [&] { notation::read(row[1]); });
  refused("n = 1/2", "is an integer", [] { instantiate(zero, {{n, half}}); });
  refused("n = x", "is an integer", [] { instantiate(zero, {{n, x}}); });
  refused("for every integer, at x", "is an integer", [&] { specialize(every, x); });
  refused("an integer as a real", "an integer term only", [] { rewrite(assume(eq(n, x)), zero); });
  refused("discrete at reals", "is an integer", [] { instantiate(axiom("discrete"), {{i, x}}); });
  refused("a formula put in", "a number is needed", [] { instantiate(zero, {{x, eq(1, 1)}}); });
  refused("a formula for every n", "a number is needed", [&] { specialize(every, eq(1, 1)); });
  refused("a term put in for a term", "is not a variable", [] { instantiate(zero, {{x + y, 1}}); });
  refused("one put in for two", "a term for each", [] { substitute(x, Exprs{x, y}, Exprs{1}); });
  refused("pi put in", "is not a variable", [] { instantiate(zero, {{pi(), 3}}); });
  refused("for every pi", "only a variable can be bound", [] { generalize(pi(), zero); });
  for (const auto& of : {sum, product, logic_and, logic_or})
    refused("of nothing", "with 0 arguments", [&] { of({}); });
  refused("an implication of one", "with 1 arguments", made({.op = Op::Imp, .args = {eq(x, 1)}}));
  refused("two negated", "with 2 arguments", made({.op = Op::Not, .args = {eq(x, 1), eq(x, 2)}}));
  refused("a number with an argument", "with 1 arguments", made({.args = {x}}));
  refused("a sum of nothing", "with 0 arguments", made({.op = Op::Add}));
  refused("a bound index below 0", "no such bound", made({.op = Op::Bound, .index = -1}));
  refused("bound index 1001", "no such bound", made({.op = Op::Bound, .index = 1001}));
  refused("a bound formula", "a bound number", made({.op = Op::Bound, .variable = Sort::Bool}));
  refused("for every formula", "a bound number",
          made({.op = Op::All, .args = {eq(x, 1)}, .variable = Sort::Bool}));
  refused("an integer for every real", "of two sorts",
          made({.op = Op::All, .args = {le(loose, ceil(x))}, .name = "k"}));
  refused("one bound number, integer and real", "of two sorts",
          [] { eq(loose, make({.op = Op::Bound})); });
  refused("no tree at all", "never given a value", [] { Expr().op(); });
  refused("the third argument of two", "no argument 2", [] { eq(x, y).arg(2); });
  const Expr nameless =
      make({.op = Op::All, .args = {lt(loose, x)}, .name = "9", .variable = Sort::Int});
  CHECK(text(nameless) == "for every integer x100: x100 < x");
  CHECK(power(x, 1) == x);
  CHECK(is_term(power(x, 1000000)));
  CHECK((n * n + 2).sort() == Sort::Int);
  CHECK((n * half).sort() == Sort::Real);
}

TEST_CASE("a loose index gets into no theorem") {
  refused("as a hypothesis", "must be a formula", [] { assume(eq(loose, 0)); });
  refused("put in", "loose index", [] { instantiate(zero, {{i, loose}}); });
  refused("as a goal of arithmetic", "must be a formula", [] { arithmetic(eq(loose, loose), {}); });
  refused("put in for every", "loose index",
          [] { specialize(generalize(i, discharge(eq(i, 0), assume(eq(i, 0)))), loose); });
  refused("as a goal", "must be a formula", [] { tautology(imp(eq(loose, 0), eq(loose, 0)), {}); });
  refused("discharged", "must be a formula", [] { discharge(eq(loose, 0), zero); });
  refused("restated", "not the same", [] { restate(eq(loose, loose), zero); });
  refused("that cancels", "must be a formula", [] { restate(eq(0 * loose, 0), zero); });
  refused("as a definition", "only a closed term", [] { define("loose", {}, loose); });
  refused("as the start of an induction", "start of an induction",
          [] { induction(n, loose, zero.conclusion(), zero, zero); });
  refused("as a start", "must be terms", recursive({}, n, {x}, {loose}, {x}));
  refused("as a step", "must be terms", recursive({}, n, {x}, {0}, {loose}));
  refused("as a property", "least integer", least({}, n, 0, eq(loose, 0)));
  refused("as a bound", "least integer", least({}, n, loose, eq(n, 0)));
  refused("replaced", "loose index", [] { replace(eq(x, 0), loose, x); });
  refused("in place of x", "loose index", [] { replace(eq(x, 0), x, loose); });
  refused("opened", "loose index", [] { open(all(x, all(y, eq(x, y))).arg(0), 1); });
  refused("printed", "loose index", [] { text(eq(loose, 0)); });
  refused("as a power", "must be a formula", [] { matrix_power(matrix(1, {1}), loose); });
  refused("in a matrix", "a matrix is needed", [] { matrix_power(matrix(1, {loose}), 2); });
}

TEST_CASE("what is too large is refused, not computed") {
  refused("nested 1,001 deep", "nested more than 1000", [] { nested(1001); });
  refused("printed 2^40 nodes", "not printed", [] { text(doubled(40)); });
  refused("x^2^32", "exponent above", [] { arithmetic(eq(power(power(x, 65536), 65536), x), {}); });
  refused("monomials", "a million monomials", [] { polynomial(power(x + y + pi() + i + n, 40)); });
  refused("6 million bits", "a million bits", [] { polynomial(power(power(Expr(9), 2000), 999)); });
  refused("below", "a million bits", [] { polynomial(power(power(Expr(1) / 9, 2000), 999)); });
  refused("too many cases", "more than 20000 cases", [] {
    Exprs parts, turned;
    for (int k = 0; k < 20; ++k) {
      parts.push_back(logic_or({eq(x, k), eq(y, k)}));
      turned.push_back(logic_or({eq(y, k), eq(x, k)}));
    }
    tautology(logic_and(turned), {assume(logic_and(parts))});
  });
  CHECK(is_term(nested(1000)));
  CHECK(text(nested(1000)).size() > 5000);
  CHECK(canonical(doubled(40)) == canonical(sin(2 * doubled(39))));
  CHECK(free_variables(doubled(40)) == std::set<Expr>{x});
  CHECK(substitute(doubled(40), {{x, y}}).weight() == doubled(40).weight());
  CHECK(brief(doubled(40)).size() < 100);
}

TEST_CASE("one tree, one Expr; entries, products and determinants are as in alike.tsv") {
  for (const auto& row : rows_of("symbolic/kernel/alike.tsv", 3, 21)) {
    INFO(row[1] << " and " << row[2]);
    const Expr l = notation::read(row[1]), r = notation::read(row[2]);
    const bool are_alike =
        row[0].find(" tree") != row[0].npos ? l == r : canonical(l) == canonical(r);
    CHECK(are_alike == row[0].starts_with("one"));
  }
  CHECK(make({.op = Op::Add, .args = {x, y}, .name = "odd", .value = 3, .index = 7}) == x + y);
  refused("what is no operation", "no such operation",
          [&] { make({.op = Op(int(Op::Det) + 1), .args = {x}}); });
  CHECK(sum({x}) == x);
}

TEST_CASE("entries of names and powers stay entries, and shapes are those of products") {
  CHECK(entry(turned(x), 0, 1).op() == Op::Entry);
  CHECK(entry(power(a, n), 1, 1).op() == Op::Entry);
  CHECK(substitute(entry(power(a, n), 1, 1), {{x, y}}) ==
        entry(power(matrix(2, {1, y, y, 2}), n), 1, 1));
  CHECK(times(wide, transpose(wide)).rows() == 2);
  CHECK(transpose(wide).cols() == 2);
}

TEST_CASE("matrices are equal entry by entry") {
  const Theorem same = assume(eq(turned(x), a));
  const Exprs entries{eq(entry(turned(x), 0, 0), 1), eq(entry(turned(x), 0, 1), x),
                      eq(entry(turned(x), 1, 0), y), eq(entry(turned(x), 1, 1), 2)};
  CHECK(restate(logic_and(entries), same).hypotheses().size() == 1);
  CHECK(tautology(entries[2], {same}).hypotheses().size() == 1);
  does_not_follow("from one entry", eq(turned(x), a), {assume(entries[0])});
}

TEST_CASE("powers and their shapes") {
  const Theorem powers = matrix_power(turned(x), n);
  CHECK(text(powers) ==
        "|- turn(x)^0 = [1, 0; 0, 1] and (0 <= n implies turn(x)^(n + 1) = turn(x) turn(x)^n)");
  CHECK(rewrite(turn, powers).conclusion().arg(0) ==
        eq(power(turn.conclusion().arg(1), Expr(0)), matrix(2, {1, 0, 0, 1})));
}

TEST_CASE("matrices stand only where they fit") {
  refused("a matrix put in", "a number is needed", [] { instantiate(turn, {{x, a}}); });
  refused("a matrix for every x", "a number is needed", [] { specialize(generalize(x, zero), a); });
  refused("a sum of one", "a number is needed", [] { sum({a}); });
  refused("a square", "a number is needed", [] { power(a, 2); });
  refused("rows that are not whole", "whole rows", [] { matrix(2, {1, 2, 3}); });
  refused("no entries", "with 0 arguments", [] { matrix(2, {}); });
  refused("no columns", "whole rows", [] { matrix(0, {1}); });
  refused("an entry of a sum", "that entry() computes", made({.op = Op::Entry, .args = {a}}));
  refused("fifth entry", "no such entry", made({.op = Op::Entry, .args = {turned(x)}, .index = 4}));
  refused("entry -1", "no such entry", made({.op = Op::Entry, .args = {turned(x)}, .index = -1}));
  refused("det of 7 rows", "more than 6 rows", [] { polynomial(det(matrix(7, Exprs(49, x)))); });
  refused("a start that is a matrix", "must be terms", recursive({}, n, {x}, {a}, {x}));
  refused("powers of a number", "a matrix is needed", [] { matrix_power(x, n); });
  CHECK(matrix(8, Exprs(8, x)).cols() == 8);
  CHECK(polynomial(det(matrix(6, Exprs(36, x)))).empty());
}
