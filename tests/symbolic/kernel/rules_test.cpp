// Attacks on the rules of logic, induction, definitions, domains, with a small motion of its own.
#include <functional>

#include "attack.hpp"
#include "rows.hpp"

using namespace kernel;

static_assert(!std::is_default_constructible_v<Theorem>);
static_assert(!std::is_constructible_v<Theorem, Exprs, Expr, Step>);
static_assert(!std::is_aggregate_v<Theorem>);
static_assert(!std::is_reference_v<decltype(std::declval<Theorem>().hypotheses())>);
static_assert(!std::is_reference_v<decltype(std::declval<Theorem>().conclusion())>);
static_assert(!std::is_reference_v<decltype(std::declval<Theorem>().step())>);

namespace {
const Expr m = integer("m");

Theorem part(const Theorem& t, std::size_t k) { return tautology(t.conclusion().arg(k), {t}); }

// One collision, by momentum, energy and change; and a ball that is reflected again and again.
const Expr M_1 = real("M_1"), M_2 = real("M_2"), u_1 = real("u_1"), u_2 = real("u_2"),
           v_1 = real("v_1"), v_2 = real("v_2");
const Theorem contact = define("contact", {M_1, M_2, u_1, u_2, v_1, v_2},
                               logic_and({eq(M_1 * u_1 + M_2 * u_2, M_1* v_1 + M_2 * v_2),
                                          eq(M_1* power(u_1, 2) + M_2 * power(u_2, 2),
                                             M_1* power(v_1, 2) + M_2 * power(v_2, 2)),
                                          neq(v_1, u_1)}),
                               0);
const Theorem laws = discharge(lt(0, M_1), assume(contact.conclusion().arg(1)));
const Theorems motion = define_recursive({"w"}, {x}, n, {y}, {x}, {y / 2 + 1});
Expr w(Expr at) { return fun("w", {x, at}); }
const Theorem last = define_least("N", {x}, n, 2, lt(w(n), 1));
// What a formula needs to make sense.
std::string words(const Exprs& conditions) {
  std::string out;
  for (Expr e : conditions) out += (out.empty() ? "" : "; ") + text(e);
  return out;
}
}  // namespace

TEST_CASE("laws are hypotheses: no instance loses them") {
  const Substitution numbers{{M_1, 1}, {M_2, 1}, {u_1, 1}, {u_2, 0}, {v_1, 0}, {v_2, 0}};
  const Theorem instance = instantiate(laws, numbers);
  const Theorem named = assume(fun("contact", {1, 1, 1, 0, 0, 0}));
  const Expr momentum = eq(1 * Expr(1) + 1 * Expr(0), 1 * Expr(0) + 1 * Expr(0));
  CHECK(instance.hypotheses().size() == 1);
  CHECK(instance.hypotheses().at(0).arg(0) == momentum);
  CHECK(instantiate(assume(eq(x, 3)), {{x, 7}}).hypotheses() == Exprs{eq(7, 3)});
  const Theorem follows = tautology(momentum, {instantiate(contact, numbers), named});
  CHECK(follows.hypotheses() == Exprs{named.conclusion()});
  does_not_follow("1 = 0 from momentum at 1, 1, 1, 0, 0, 0", eq(1, 0), {instance});
  does_not_follow("the momentum itself, without the law", momentum, {contact});
  does_not_follow("changed: w_(n + 1) != w_n for every n", neq(w(n + 1), w(n)), motion);
  refused("its hypothesis by arithmetic", "does not add up", [&] { arithmetic(momentum, {}); });
}

TEST_CASE("a defined name is no variable") {
  const Expr last_n = fun("N", {x});
  refused("N put in", "is not a variable", [&] { instantiate(last, {{last_n, 0}}); });
  refused("a variable N", "name of a function", [] { integer("N"); });
  refused("over N", "an integer variable", [&] { induction(last_n, 0, eq(0, 0), zero, zero); });
  refused("for every N", "only a variable can be bound", [&] { generalize(last_n, last); });
  refused("N again", "defined already", [] { define_least("N", {x}, n, 0, eq(n, 99)); });
  refused("N as a term", "defined already", [] { define("N", {}, 6); });
  refused("N of itself", "no function", [] { define("itself", {x}, fun("itself", {x}) + 1); });
  refused("w again", "defined already", [] { define_recursive({"w"}, {}, n, {y}, {7}, {y}); });
  refused("one name, two sequences", "one name for two", [] {
    define_recursive({"u", "u"}, {}, n, {x, y}, {0, 1}, {x, y});
  });
}

TEST_CASE("definitions and domains depend on their parameters alone") {
  define("somewhere", {x, n}, x);
  for (const auto& row : rows_of("symbolic/kernel/definitions.tsv", 7, 27)) {
    std::vector<Exprs> with;
    for (std::size_t k = 2; k < row.size(); ++k) with.push_back(listed(row[k]));
    INFO(row[4] << ", " << row[5] << ", " << row[6]);
    const Exprs &params = with[0], &first = with[1];
    const std::map<std::string, std::function<void()>> kinds{
        {"define", [&] { define("bad", params, first.at(0)); }},
        {"recursive", recursive(params, first.at(0), with[2], with[3], with[4])},
        {"least", [&] { least(params, first.at(0), with[2].at(0), with[3].at(0))(); }},
        {"domain", [&] { restrict_domain("somewhere", params, first.at(0)); }}};
    refused(row[1] + " " + row[2] + ", " + row[3], row[0], kinds.at(row[1]));
  }
  refused("hides more than there are", "hidden", [] { define("bad", {x}, x, 2); });
  refused("hides less than none", "hidden", [] { define("bad", {x}, x, -2); });
  refused("no name", "without a name", [] { define_recursive({}, {}, n, {}, {}, {}); });
  const Theorem t = define_least("least", {}, n, 2, lt(3, n));
  const Expr q = fun("least", {});
  CHECK(t.conclusion() ==
        imp(logic_and({le(2, n), lt(3, n)}), logic_and({le(2, q), lt(3, q), le(q, n)})));
  CHECK(motion[0].conclusion() == eq(w(0), x));
  CHECK(motion[1].conclusion() == imp(le(0, n), eq(w(n + 1), w(n) / 2 + 1)));
  const Theorem hides_all = define("hides_all", {x}, x, 1);
  CHECK(hides_all.conclusion() == eq(fun("hides_all", {x}), x));
  does_not_follow("the least of nothing", eq(1, 0), {define_least("nothing", {}, n, 0, eq(1, 0))});
  does_not_follow("before the start", eq(w(0), w(-1) / 2 + 1), {instantiate(motion[1], {{n, -1}})});
  does_not_follow("N < 5, at n = 0", lt(fun("N", {x}), 5), {instantiate(last, {{n, 0}})});
}

TEST_CASE("induction needs base and step for every n") {
  const auto inducing = [](Expr index, Expr lo, Expr f, const Theorem& base, const Theorem& step) {
    return [=] { induction(index, lo, f, base, step); };
  };
  const auto no_more = [](Expr e) { return arithmetic(le(e, e), {}); };
  const Theorems five = define_recursive({"five"}, {}, n, {x}, {5}, {x + 1});
  const auto f = [](Expr at) { return eq(fun("five", {at}), 5); };
  const Theorem wrong_step = discharge(logic_and({le(0, n), f(n)}), assume(f(n + 1)));
  const Theorem base_at_5 = assume(logic_and({eq(n, 5), f(0)}));
  const Theorem two = assume(logic_and({le(0, n), le(0, n)}));
  const Theorem step_two =
      discharge(two.conclusion(),
                arithmetic(le(0, n + 2), {.products = {{1, {part(two, 0)}}, {2, {}, {1}}}}));
  const Theorem again = tautology(imp(logic_and({le(0, n), f(n)}), f(n)), {});
  const Theorem from_0 = assume(logic_and({le(0, n), le(-1, n)}));
  const Theorem step_from_0 =
      discharge(from_0.conclusion(),
                arithmetic(le(-1, n + 1), {.products = {{1, {part(from_0, 0)}}, {2, {}, {1}}}}));
  refused("a step of nothing", "the step says", inducing(n, 0, f(n), five[0], again));
  refused("a step from 0", "the step says", inducing(n, -1, le(-1, n), no_more(-1), step_from_0));
  refused("another base", "the base says", inducing(n, 0, eq(x, 7), five[0], zero));
  refused("a base at 0, not 1", "the base says", inducing(n, 1, f(n), five[0], zero));
  refused("no step", "the step says", inducing(n, 0, f(n), five[0], zero));
  refused("a step given f(n + 1)", "in the hypothesis", inducing(n, 0, f(n), five[0], wrong_step));
  refused("a base at n = 5", "in the hypothesis", inducing(n, 0, f(n), part(base_at_5, 1), zero));
  refused("a start at n", "start of an induction", inducing(n, n, eq(n, n), zero, zero));
  refused("a start at 1/2", "from an integer on", inducing(n, half, eq(n, n), zero, zero));
  refused("over a real", "an integer variable", inducing(x, 0, eq(x, x), zero, zero));
  refused("of a number", "induction proves a formula", inducing(n, 0, x, zero, zero));
  refused("a step of two", "the step says", inducing(n, 0, le(0, n), no_more(0), step_two));
  refused("from another start", "the step says", inducing(n, -1, le(-1, n), no_more(-1), step_two));
  const Expr same = eq(x, 0);
  const Theorem base = tautology(same, {nought, assume(lt(x, y))});
  const Theorem step =
      discharge(logic_and({le(0, n), same}), tautology(same, {assume(lt(y, 0)), nought}));
  const Theorem t = induction(n, 0, same, base, step);
  CHECK(t.conclusion() == imp(le(0, n), same));
  CHECK(t.hypotheses().size() == 3);
}

TEST_CASE("propositional logic, every table of truth, and restating are as in propositions.tsv") {
  for (const auto& row : rows_of("symbolic/kernel/propositions.tsv", 4, 28)) {
    const Expr goal = notation::read(row[1]);
    Exprs from;
    Theorems premises;
    for (std::size_t k = 2; k < row.size() && !row[k].empty(); ++k) {
      from.push_back(notation::read(row[k]));
      premises.push_back(assume(from.back()));
    }
    const auto prove = [&] {
      return row[0] == "not the same" ? restate(goal, premises.at(0)) : tautology(goal, premises);
    };
    INFO(row[1]);
    if (row[0] == "follows")
      CHECK(prove().hypotheses() == from);
    else
      refused(row[2], row[0], prove);
  }
  does_not_follow("sin x is positive", lt(0, sin(x)), {axiom("sin positive")});
  does_not_follow("sqrt(-1)^2 = -1", eq(power(sqrt(Expr(-1)), 2), -1),
                  {instantiate(axiom("root squared"), {{x, -1}})});
}

TEST_CASE("quantifiers, rewriting") {
  refused("from n = 5", "in the hypothesis", [] { generalize(n, assume(eq(n, 5))); });
  refused("specialize what is not for all", "not a statement for all", [] { specialize(zero, 1); });
  refused("rewriting by an inequality", "not an equation", [] { rewrite(positive, zero); });
  refused("an axiom of one's own", "no axiom", [] { axiom("momentum"); });
  const Expr deep = all(x, all(y, logic_and({lt(x, y), all(x, lt(x, y))})));
  const Theorem one = specialize(assume(deep), 1);
  CHECK(one.conclusion() == all(y, logic_and({lt(1, y), all(x, lt(x, y))})));
  CHECK(specialize(one, 2).conclusion() == logic_and({lt(1, 2), all(x, lt(x, 2))}));
  CHECK(specialize(assume(deep), y).conclusion() ==
        all(real("z"), logic_and({lt(y, real("z")), all(x, lt(x, real("z")))})));
  CHECK(substitute(all(y, lt(x, y)), {{x, y}}) == all(real("z"), lt(y, real("z"))));
  CHECK(rewrite(nought, assume(all(y, lt(x, y)))).conclusion() == all(y, lt(0, y)));
  const auto touch = [](Expr mass) { return fun("contact", {mass, 1, 2, 3, 4, 5}); };
  CHECK(restate(touch(x + 0), assume(touch(x))).hypotheses().size() == 1);
}

TEST_CASE("hypotheses stay") {
  for (const Theorem& t : {tautology(logic_or({lt(0, x), lt(x, 0)}), {positive}),
                           restate(lt(0, 1 * x), positive), discharge(lt(x, 0), positive)})
    CHECK(t.hypotheses() == Exprs{lt(0, x)});
  for (const Theorem& t : {generalize(i, nought), specialize(generalize(i, nought), 7)})
    CHECK(t.hypotheses() == Exprs{eq(x, 0)});
  CHECK(rewrite(nought, positive).hypotheses().size() == 2);
  CHECK(discharge(lt(0, x), positive).hypotheses().empty());
}

TEST_CASE("a theorem is copied, never moved") {
  Theorem t = assume(eq(0, 1));
  const Theorem moved = std::move(t);
  CHECK(t.hypotheses() == Exprs{eq(0, 1)});
  CHECK(moved.hypotheses() == t.hypotheses());
  refused("0 = 1 after a move", "does not add up", [&] { arithmetic(eq(0, 1), {}); });
  Theorems list{positive, assume(eq(0, 1)), nought};
  const auto end = std::remove_if(list.begin(), list.end(),
                                  [](const Theorem& k) { return k.conclusion() == lt(0, x); });
  CHECK(end - list.begin() == 2);
  for (const Theorem& k : list) CHECK(k.hypotheses().size() == 1);
}

TEST_CASE("each theorem keeps its step") {
  const Theorem t = discharge(lt(0, x), positive);
  CHECK(t.step().rule == "discharge");
  CHECK(t.step().premises.at(0).conclusion() == lt(0, x));
  CHECK(t.step().extras == Exprs{lt(0, x)});
  CHECK(zero.step().certificate.has_value());
  CHECK(instantiate(zero, {{x, 1}}).step().substitution.at(x) == Expr(1));
  CHECK(axiom("circle").step().rule == "axiom circle");
  for (const std::string& name : axiom_names()) CHECK(axiom(name).hypotheses().empty());
}

TEST_CASE("each division and root asks for its condition, under what is said before it") {
  real("any1");
  for (const auto& row : rows_of("symbolic/kernel/needs.tsv", 2, 12)) {
    INFO(row[0]);
    CHECK(words(needs(notation::read(row[0]))) == row[1]);
  }
}

TEST_CASE("hypotheses are read, too, and predicates are unfolded") {
  define("inverse_of", {x, y}, eq(y, 1 / x));
  define("power_of", {x}, x + 1);
  restrict_domain("power_of", {y}, lt(0, y));
  CHECK(words(needs(assume(eq(1 / x, y)))) == "x != 0; 1/x = y implies x != 0");
  define("seen_inverse", {x}, 1 / x);
  CHECK(words(needs(eq(fun("seen_inverse", {y}), 0))) == "y != 0");
  CHECK(words(needs(fun("inverse_of", {x + 1, 2}))) == "x + 1 != 0");
  CHECK(words(needs(eq(fun("power_of", {x / y}), 0))) == "y != 0; 0 < x/y");
}

TEST_CASE("a function has one domain, and what is asked for has an end") {
  refused("of nothing", "no function", [] { restrict_domain("nowhere", {}, eq(0, 0)); });
  refused("of inv again", "a domain already", [] { restrict_domain("inv", {x}, lt(0, x)); });
  refused("of 2^20 nodes", "more than 200000 nodes", [] { needs(eq(doubled(20), 0)); });
  refused("of a number", "only a formula", [] { needs(x); });
}

// Arithmetic: certificates that do not certify, beside those that do.
namespace {
const std::set<std::string> uses{"nonzero", "multiplier", "equation", "square", "product"};
/// Of pairs of fields from the third on.
Certificate certificate(const std::vector<std::string>& row) {
  Certificate out;
  for (std::size_t k = 2; k < row.size() && !row[k].empty(); k += 2) {
    const std::string& use = row[k];
    const Exprs all = listed(row[k + 1]);
    REQUIRE(uses.contains(use));
    if (use == "nonzero") out.nonzero.push_back(assume(all.at(0)));
    if (use == "multiplier") out.multipliers.push_back(assume(all.at(0)));
    if (use == "equation") out.equations.emplace_back(all.at(0), assume(all.at(1)));
    if (use == "square") out.products.push_back({all.at(0).value(), {}, {all.at(1)}});
    if (use != "product") continue;
    Certificate::Product product{all.at(0).value()};
    for (std::size_t i = 1; i < all.size(); ++i) product.factors.push_back(assume(all[i]));
    out.products.push_back(product);
  }
  return out;
}
}  // namespace

TEST_CASE("certificates prove, under all their hypotheses, or do not, as in certificates.tsv") {
  for (const auto& row : rows_of("symbolic/kernel/certificates.tsv", 8, 54)) {
    const Expr goal = notation::read(row[1]);
    const Certificate by = certificate(row);
    INFO(row[1] << ", " << row[2] << " " << row[3]);
    if (!std::isdigit(row[0][0])) {
      refused(row[1], row[0], [&] { arithmetic(goal, by); });
      continue;
    }
    const Theorem t = arithmetic(goal, by);
    CHECK(t.conclusion() == goal);
    CHECK(std::to_string(t.hypotheses().size()) == row[0]);
  }
  const Expr loose = all(x, eq(x, 0)).arg(0).arg(0);
  const auto by = [](const Certificate& c) { return [=] { arithmetic(le(0, 0), c); }; };
  refused("a loose cofactor", "must be a term", by({.equations = {{loose, nought}}}));
  refused("a loose square", "only a term", by({.products = {{1, {}, {loose}}}}));
}
