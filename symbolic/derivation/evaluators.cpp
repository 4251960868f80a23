// SPDX-License-Identifier: GPL-2.0-or-later
// The forms that are evaluated: from tan(psi/4) and cot(psi/2), without cancellation or overflow.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr from_0 = le(0, n);
Expr of_alpha(const std::string& name) { return fun(name, {alpha}); }
Expr of_both(const std::string& name) { return fun(name, {alpha, n}); }
const Expr quarter_turn = pi() / 2;

/// Names for parts of a form, each defined by those before it; the generator's nodes.
class Names {
public:
  explicit Names(Book& the_book) : book(the_book) {}

  Theorem name(const std::string& name, const Exprs& params, Expr value,
               const std::string& words = "and") {
    Exprs domain;
    for (const Expr& p : params)
      domain.push_back(p == alpha ? alpha_positive : p == V ? V_positive : le(p == k ? 1 : 0, p));
    const bool indexed = params.back() == n || params.back() == k;
    const Theorem definition = define(name, params, value, indexed ? int(params.size()) - 1 : -1);
    restrict_domain(name, params, logic_and(domain));
    book.show("def_" + name, "", words, under(domain, definition));
    return definition;
  }
  Book& book;
};

/// half_h = psi/4, t = sin(psi/4)/cos(psi/4), w = t/alpha, and their signs.
struct Angle {
  Theorem quarter, tangent, t_is, w_is, w_positive, cos_positive, t_small;
};
Angle angle(Names& names) {
  Book& book = names.book;
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass}), p2 = positive(2 + alpha, {mass});
  const Theorem above = names.name("above", {alpha}, 2 + alpha, "With");
  book.facts.push_back(linear(lt(0, of_alpha("above")), {above, p2}));
  const Theorem w = names.name("w", {alpha}, 1 / sqrt(alpha * of_alpha("above")));
  const Theorem z = rewrite(above, names.name("z", {alpha}, alpha / of_alpha("above")));
  const Theorem t = names.name("t", {alpha}, alpha * of_alpha("w"));
  const Theorem half_h = names.name("half_h", {alpha}, atan(of_alpha("t")));
  const Theorem root = root_squared(positive(alpha * (2 + alpha), {mass, p2}));
  const Theorem under_root = rewrite(above, w);
  const Theorem w_positive = linear(
      lt(0, of_alpha("w")), {under_root, positive(1 / sqrt(alpha * (2 + alpha)), {mass, p2})});
  const Theorem t_positive = linear(lt(0, of_alpha("t")), {t, times(mass, w_positive)});
  const Theorem t_squared =
      book.show("t_squared", "", "t^2 is",
                equation(power(of_alpha("t"), 2), of_alpha("z"), {t, under_root, z, root},
                         {p2, positive(sqrt(alpha * (2 + alpha)), {mass, p2})}));
  // cos(2 atan t) = (1 - t^2)/(1 + t^2) = 1/(1 + alpha) = cos(psi/2)
  const Expr T = of_alpha("t"), q = of_alpha("half_h");
  const Theorem one_more = positive(1 + power(T, 2), {t_positive});
  const Theorems values{rewrite(turned(half_h), use("cos atan", {{x, T}})),
                        rewrite(turned(half_h), use("sin atan", {{x, T}})), root_squared(one_more)};
  const Theorem cos_twice =
      equation(cos(2 * q), 1 / (1 + alpha),
               angles({cos(2 * q)}, {q}, false) + values + Theorems{t_squared, z},
               {p1, p2, positive(sqrt(1 + power(T, 2)), {t_positive})});
  const Theorem q_positive = linear(lt(0, q), {half_h, positive(atan(T), {t_positive})});
  const Theorem q_below = linear(lt(2 * q, pi()), {half_h, part(use("atan range", {{x, T}}), 1)});
  const Theorem psi_from = part(book["rotation.psi_range"], 0),
                psi_to = part(book["rotation.psi_range"], 1);
  const Theorem same =
      same_angle(chain(cos_twice, turned(book["rotation.cos_half_psi"])),
                 linear(lt(0, 2 * q), {q_positive}), q_below, linear(lt(0, psi() / 2), {psi_from}),
                 linear(lt(psi() / 2, pi()), {psi_from, psi_to}));
  const Theorem is_quarter = linear(eq(q, psi() / 4), {same});
  const Theorem light = assume(le(alpha, 1));
  Certificate third;  // 1/3 - alpha/(2 + alpha) = 2 (1 - alpha)/(3 (2 + alpha))
  third.multipliers = {p2};
  third.nonzero = {p2};
  third.equations = {{2 + alpha, z}};
  third.products = {{rational(2, 3).value(), {light}, {}}};
  book.show("z_at_most", "", "a third at most for a ball that is not heavier than a block:",
            arithmetic(le(of_alpha("z"), rational(1, 3)), third));
  book.show("psi", "", "psi is four times the arctangent of t:", linear(eq(psi(), 4 * q), {same}));
  const Theorem cosine = rewrite(is_quarter, values[0]);
  const Theorem sine = rewrite(is_quarter, values[1]);
  const Theorem cos_positive =
      linear(lt(0, cos(psi() / 4)), {cosine, positive(1 / sqrt(1 + power(T, 2)), {t_positive})});
  const Theorem tangent = equation(T, sin(psi() / 4) / cos(psi() / 4), {sine, cosine},
                                   {cos_positive, positive(sqrt(1 + power(T, 2)), {t_positive})});
  Certificate smaller;  // w - t = (1 - alpha) w
  smaller.equations = {{1, t}};
  smaller.products = {{1, {light, w_positive}, {}}};
  return {is_quarter,
          tangent,
          t,
          equation(of_alpha("w"), T / alpha, {t}, {mass}),
          w_positive,
          cos_positive,
          arithmetic(le(T, of_alpha("w")), smaller)};
}

/// Proves that a velocity is a form in t, w and a sine and cosine.
struct Prover {
  const Angle& a;
  Theorem sine_positive;
  Theorems rules, divisors;

  Prover(Book& book, const Angle& the_angle)
      : a(the_angle), sine_positive(part(book["power.quarter"], 0)) {
    const Theorem mass = assume(alpha_positive);
    rules = {a.w_is,
             a.tangent,
             part(book["power.quarter"], 1),
             part(book["power.quarter"], 2),
             book["power.V_CM"],
             root_squared(positive(alpha * (2 + alpha), {mass}))};
    divisors = {positive(1 + alpha, {mass}),
                positive(2 + alpha, {mass}),
                mass,
                a.cos_positive,
                sine_positive,
                positive(sqrt(alpha * (2 + alpha)), {mass})};
    const Expr root = sqrt(alpha * (2 + alpha)), q = psi() / 4;
    const Theorem circle = angles({}, {q})[0];
    const auto rationalised = [&](Expr l, Expr r) {
      return cancel(eq(l, r), {a.cos_positive}, rules + Theorems{circle}, divisors);
    };
    rules = rules + Theorems{rationalised(root * sin(q), alpha * cos(q)),
                             rationalised(root * cos(q), (2 + alpha) * sin(q))};
  }
  Theorem equal(Expr l, Expr r, const Theorems& more, const Exprs& bases,
                const Theorems& factors) const {
    Exprs terms{l, r};
    for (const Theorem& t : more) terms.push_back(t.conclusion().arg(1));
    return cancel(eq(l, r), factors, more + angles(terms, bases) + rules, divisors);
  }
};

/// 0 <= x, t <= w |- t x <= w x, for the names of both products.
Theorem larger(const Theorem& t_small, Expr factor, const Theorem& t_product,
               const Theorem& w_product) {
  Certificate c;
  c.equations = {{1, t_product}, {-1, w_product}};
  c.products = {{1, {t_small, assume(le(0, factor))}, {}}};
  return arithmetic(le(t_product.conclusion().arg(0), w_product.conclusion().arg(0)), c);
}

/// Both velocities after P_n and both after Q_n, from one sine and one cosine.
void velocities(Names& names, const Angle& a) {
  Book& book = names.book;
  const Exprs both_inputs{alpha, n};
  const Theorem def_x = names.name("phase", both_inputs, 2 * of_alpha("half_h") * n, "With");
  const auto at_angle = [&](const std::string& name, Expr value) {
    const Theorem t = names.name(name, both_inputs, value);
    return rewrite(a.quarter, rewrite(def_x, t));
  };
  const auto f = of_both;
  const Theorems parts{at_angle("sine", sin(f("phase"))),
                       at_angle("cosine", cos(f("phase"))),
                       names.name("t_sine", both_inputs, of_alpha("t") * f("sine")),
                       names.name("w_sine", both_inputs, of_alpha("w") * f("sine")),
                       names.name("plus", both_inputs, f("cosine") + f("t_sine")),
                       names.name("minus", both_inputs, f("cosine") - f("t_sine")),
                       names.name("along", both_inputs, f("cosine") + f("w_sine"))};
  book.show("t_sine_at_most", "", "where for a ball that is not heavier than a block",
            under({alpha_positive, from_0}, larger(a.t_small, f("sine"), parts[2], parts[3])));
  const Prover prover(book, a);
  const Exprs bases{n * psi() / 2, psi() / 4};
  const auto show = [&](const std::string& name, const std::string& id, Expr velocity, Expr form,
                        const Theorems& factors) {
    const Theorem t =
        prover.equal(velocity, V * form, Theorems{book["power." + id]} + parts, bases, factors);
    book.show(name, "", name == "a" ? "the velocities are" : "and", t);
  };
  const Theorems cosines{a.cos_positive, a.cos_positive};
  show("a", "a_product", derivation::a(n), f("plus") * f("minus"), cosines);
  show("b", "b_product", b(n), 2 * f("along") * f("t_sine"), cosines);
  show("c", "c_product", c(n), 2 * f("plus") * f("w_sine"), cosines);
  show("c_prime", "c_prime_product", c_prime(n), -2 * f("minus") * f("w_sine"), cosines);
}
/// |- 0 <= x implies sqrt(x^2) = x, and |- x <= 0 implies sqrt(x^2) = -x
std::pair<Theorem, Theorem> root_of_square() {
  const Expr s = sqrt(power(x, 2));
  const Theorem square = not_negative(power(x, 2));
  const Theorem squared = root_squared(square);
  const Theorem s_from_0 = use("root not negative", {{x, power(x, 2)}}, {square});
  const auto with_sign = [&](Expr value, const Theorem& value_from_0) {  // s = value, value^2 = x^2
    const Theorem differ = assume(neq(s + value, 0));
    Certificate c;  // (s + value)(value - s) = x^2 - s^2
    c.multipliers = {differ};
    c.equations = {{-1, squared}};
    const Theorem other = arithmetic(eq(s, value), c);
    const Theorem none = assume(eq(s + value, 0));
    const Theorem both_0 = linear(eq(s, value), {none, s_from_0, value_from_0});
    return discharge(value_from_0.hypotheses()[0],
                     tautology(eq(s, value), {discharge(differ.conclusion(), other),
                                              discharge(none.conclusion(), both_0)}));
  };
  const Theorem above = assume(le(0, x)), below = assume(le(x, 0));
  return {with_sign(x, above), with_sign(-x, linear(le(0, -x), {below}))};
}

/// The terminal velocities, from what is left of a quarter turn after N_A steps of psi/2.
void at_the_end(Names& names, const Angle& a) {
  Book& book = names.book;
  book.chapter("evaluators_end", "Forms for evaluation: terminal velocities",
               {alpha_positive, V_positive});
  const Exprs inputs{alpha, V};
  const auto f = [&](const std::string& name) { return fun(name, inputs); };
  const Theorem h = names.name("h", {alpha}, 2 * of_alpha("half_h"), "With");
  const Theorem psi_is = linear(eq(psi(), 2 * of_alpha("h")), {h, a.quarter});
  const Theorem h_positive =
      linear(lt(0, of_alpha("h")), {psi_is, part(book["rotation.psi_range"], 0)});
  book.facts.push_back(h_positive);
  const auto count = [&](const std::string& name, Expr shift) {
    const Theorem quotient = equation(pi() / psi(), pi() / (2 * of_alpha("h")),
                                      {linear(eq(of_alpha("h"), psi() / 2), {psi_is})},
                                      {part(book["rotation.psi_range"], 0), h_positive});
    book.show(name, "", name == "N_A" ? "the counts are" : "and",
              restate(eq(f(name), ceil(pi() / (2 * of_alpha("h")) - shift)),
                      rewrite(quotient, book["counting." + name])));
  };
  count("N_A", rational(1, 2));
  count("N_B", 1);

  const Expr angle = N_A() * psi() / 2;
  const Expr r = pi() / 2 - angle;
  const Theorem def_rest =
      names.name("rest", inputs, sqrt(power(pi() / 2 - of_alpha("h") * N_A(), 2)),
                 "What is left of a quarter turn:");
  const Theorem rest_is =
      restate(eq(f("rest"), sqrt(power(r, 2))),
              rewrite(linear(eq(of_alpha("h"), psi() / 2), {psi_is}), def_rest));
  const Theorem def_sine = names.name("rest_sine", inputs, sin(f("rest")));
  const Theorem def_cosine = names.name("rest_cosine", inputs, cos(f("rest")));
  const Theorems parts{names.name("t_cosine", inputs, of_alpha("t") * f("rest_cosine")),
                       names.name("w_cosine", inputs, of_alpha("w") * f("rest_cosine")),
                       names.name("t_plus", inputs, f("t_cosine") + f("rest_sine")),
                       names.name("t_minus", inputs, f("t_cosine") - f("rest_sine")),
                       names.name("w_plus", inputs, f("w_cosine") + f("rest_sine")),
                       names.name("b_form", inputs, 2 * f("w_plus") * f("t_cosine"))};
  const Prover prover(book, a);
  const Theorem N_A_from_1 = part(book["counting.at_least"], 0);
  const Theorem psi_positive = part(book["rotation.psi_range"], 0);
  const Theorem z_rounded = use("ceiling", {{x, 2 * pi() / psi()}});
  const Theorem per = equation(psi() * (2 * pi() / psi()), 2 * pi(), {}, {psi_positive});
  const auto roots = root_of_square();
  const Theorem root_above = roots.first, root_below = roots.second;

  // Q_n last: r > 0; P_n last: r <= 0.
  const auto in_case = [&](bool Q_last) {
    const Expr steps = Q_last ? 2 * n : 2 * n - 1;
    const Theorem N_is = assume(eq(N(), substitute(steps, {{n, N_A()}})));
    const Theorem end =
        use(discharge(le(1, n), discharge(eq(N(), steps),
                                          book[Q_last ? "terminal.after_Q" : "terminal.after_P"])),
            {{n, N_A()}}, {N_A_from_1});
    const Theorem facts = tautology(
        end.conclusion().op() == Op::Imp ? end.conclusion().arg(1) : end.conclusion(), {end, N_is});
    const Theorem bound = Q_last ? linear(lt(0, 2 * pi() / psi() - 2 * N_A()),
                                          {N_is, book["counting.N"], part(z_rounded, 1)})
                                 : linear(le(0, 2 * N_A() - 2 * pi() / psi()),
                                          {N_is, book["counting.N"], part(z_rounded, 0)});
    const Theorem sign = linear(Q_last ? le(0, r) : le(r, 0), {times(bound, psi_positive), per});
    const Theorem size = chain(rest_is, use(Q_last ? root_above : root_below, {{x, r}}, {sign}));
    const Theorems turned_by{use("cos minus", {{x, angle}}),
                             use("sin minus", {{x, angle}}),
                             use("cos minus", {{x, r}}),
                             use("sin minus", {{x, r}}),
                             use("cos sum", {{x, pi() / 2}, {y, -angle}}),
                             use("sin sum", {{x, pi() / 2}, {y, -angle}}),
                             axiom("cos pi/2"),
                             axiom("sin pi/2")};
    const Theorem sine = equation(f("rest_sine"), Q_last ? cos(angle) : -cos(angle),
                                  Theorems{rewrite(size, def_sine)} + turned_by);
    const Theorem cosine =
        equation(f("rest_cosine"), sin(angle), Theorems{rewrite(size, def_cosine)} + turned_by);
    const Theorem before = linear(le(0, N_A() - 1), {N_A_from_1});
    const Theorem here = linear(le(0, N_A()), {N_A_from_1});
    const auto product = [&](const std::string& id, Expr index, const Theorem& index_from_0) {
      return use(discharge(from_0, book["power." + id]), {{n, index}}, {index_from_0});
    };
    const auto value = [&](std::size_t i, const Theorem& form, Expr goal) {
      const Theorem is = part(facts, i);
      return prover.equal(is.conclusion().arg(0), goal,
                          Theorems{is, form} + parts + Theorems{sine, cosine}, {angle, psi() / 4},
                          {a.cos_positive, a.cos_positive});
    };
    const Theorem velocities = both(
        {value(2, product("a_product", N_A(), here), V * (-f("t_minus") * f("t_plus"))),
         value(3,
               Q_last ? product("b_product", N_A(), here) : product("b_product", N_A() - 1, before),
               V * f("b_form")),
         value(4,
               Q_last ? product("c_prime_product", N_A(), here) : product("c_product", N_A(), here),
               V * (2 * f("t_minus") * f("w_cosine")))});
    return discharge(N_is.conclusion(), velocities);
  };
  const Theorem Q = in_case(true);
  const Theorem P = in_case(false);
  book.show("terminal", "", "The terminal velocities are, whichever collision is the last,",
            tautology(Q.conclusion().arg(1), {Q, P, book["terminal.last"]}));
  const Theorem transmitted = define("rho", inputs, power(fun("b_t", inputs) / V, 2));
  restrict_domain("rho", inputs, logic_and({alpha_positive, V_positive}));
  book.show("def_rho", "", "and B has of the energy the fraction",
            under({alpha_positive, V_positive}, transmitted));
  book.show(
      "rho", "", "that is,",
      equation(f("rho"), power(f("b_form"), 2),
               {transmitted, part(book["evaluators_end.terminal"], 1)}, {assume(V_positive)}));

  // |r| <= h/2, so sin|r| <= tan(h/2) cos(r).
  const Expr half_h = of_alpha("h") / 2;
  const Theorem rounded = use("ceiling", {{x, pi() / psi() - rational(1, 2)}});
  const Theorem per_half = equation(psi() * (pi() / psi()), pi(), {}, {psi_positive});
  const auto scaled_by_psi = [&](Expr goal, const Theorem& relation) {
    return linear(goal, {times(relation, psi_positive), per_half, psi_is});
  };
  const Theorem number = book["counting.N_A"];
  const Theorem r_up = scaled_by_psi(
      le(r, half_h),
      linear(le(0, N_A() + rational(1, 2) - pi() / psi()), {part(rounded, 0), number}));
  const Theorem r_down = scaled_by_psi(
      le(-r, half_h),
      linear(le(0, pi() / psi() + rational(1, 2) - N_A()), {part(rounded, 1), number}));
  const auto with_sign = [&](const Theorem& root, Expr sign, const Theorem& bound,
                             const Theorem& given) {
    const Theorem is = chain(rest_is, use(root, {{x, r}}, {given}));
    const Theorem from = linear(le(0, f("rest")), {is, given});
    return discharge(sign, both({from, linear(le(f("rest"), half_h), {is, bound})}));
  };
  const Theorem above = assume(le(0, r)), below = assume(lt(r, 0));
  const Theorem bounds = book.show(
      "rest_bounds", "", "where what is left is half a step at most:",
      tautology(logic_and({le(0, f("rest")), le(f("rest"), half_h)}),
                {with_sign(root_above, above.conclusion(), r_up, above),
                 with_sign(root_below, below.conclusion(), r_down, linear(le(r, 0), {below})),
                 use("equal or less or greater", {{x, r}, {y, 0}})}));
  const Expr q = psi() / 4;
  const Theorem q_is = linear(eq(half_h, q), {psi_is});
  const Expr gap_angle = q - f("rest");
  const Theorem gap_from = linear(le(0, gap_angle), {part(bounds, 1), q_is});
  const Theorem gap_below = linear(
      lt(gap_angle, pi()), {part(bounds, 0), part(book["rotation.psi_range"], 1), psi_positive});
  const Theorem sine_from_0 = sine_not_negative(gap_from, linear(le(gap_angle, pi()), {gap_below}));
  const Theorem difference =
      equation(sin(gap_angle), sin(q) * f("rest_cosine") - cos(q) * f("rest_sine"),
               angles({sin(gap_angle)}, {q, f("rest")}, false) +
                   Theorems{turned(def_sine), turned(def_cosine)});
  Certificate c;  // cos(q) (t cos(rest) - sin(rest)) = sin(q - rest)
  c.multipliers = {a.cos_positive};
  c.nonzero = {a.cos_positive};
  c.equations = {{1, difference}, {-cos(q), parts[0]}, {-cos(q) * f("rest_cosine"), a.tangent}};
  c.products = {{1, {sine_from_0}, {}}};
  book.show(
      "t_cosine_at_most", "", "For a ball that is not heavier than a block",
      under({alpha_positive, V_positive}, larger(a.t_small, f("rest_cosine"), parts[0], parts[1])));
  book.show("sine_at_most", "", "and so", arithmetic(le(f("rest_sine"), f("t_cosine")), c));
}
/// alpha_k and beta_k from the sine of half of their angle.
void ratio_forms(Names& names) {
  Book& book = names.book;
  book.chapter("evaluators_ratios", "Forms for evaluation: ratios", {le(1, k)});
  for (const auto& [name, half_angle] :
       {std::pair{"alpha_", pi() / (2 * (1 + 2 * k))}, std::pair{"beta_", pi() / (4 * (1 + k))}}) {
    const std::string kind = std::string(name) == "alpha_" ? "magic" : "deficient";
    const auto f = [&](const std::string& part) { return fun(kind + "_" + part, {k}); };
    const Theorem y_is = names.name(kind + "_angle", {k}, half_angle, "With");
    const Theorem sine = names.name(kind + "_sine", {k}, sin(f("angle")));
    const Theorem versed = names.name(kind + "_versed", {k}, 2 * power(f("sine"), 2));
    const Theorem cosine = names.name(kind + "_cosine", {k}, 1 - f("versed"));
    const Theorem definition = book[std::string("ratios.") + name + "k"];
    const Expr whole = definition.conclusion().arg(1).arg(1).arg(0);  // cos(pi/d)
    const Theorem twice = equation(cos(2 * f("angle")), 1 - 2 * power(sin(f("angle")), 2),
                                   angles({cos(2 * f("angle"))}, {f("angle")}));
    const Theorem k_from_0 = linear(le(0, k), {assume(le(1, k))});
    const Theorem angle_is =
        equation(2 * f("angle"), whole.arg(0), {y_is},
                 {positive(2 * k + 1, {k_from_0}), positive(2 * k + 2, {k_from_0}),
                  positive(k + 1, {k_from_0})});
    const Theorem is =
        equation(f("cosine"), whole, {cosine, versed, sine, rewrite(angle_is, twice)});
    book.facts.push_back(
        linear(lt(0, f("cosine")), {is, book[std::string("ratios.") + name + "k_cosine"]}));
    book.show(kind, "", "the ratio is",
              rewrite(turned(is),
                      equation(fun(name, {k}), f("versed") / whole,
                               {definition, linear(eq(f("versed"), 1 - whole), {is, cosine})})));
  }
}
/// A ball that is not lighter than a block has one collision with each: rational velocities.
void heavy_ball(Names& names) {
  Book& book = names.book;
  const Expr heavy = le(1, alpha);
  book.chapter("heavy", "A heavy ball", {heavy, V_positive});
  const Theorem is_heavy = assume(heavy);
  const Theorem mass = linear(alpha_positive, {is_heavy});
  const Theorem one = linear(le(1, 1), {});
  const Theorem alpha_1 = book["ratios.alpha_1"];
  const Theorem beta_below = use(discharge(le(1, k), book["ratios.order"]), {{k, 1}}, {one});
  const Expr beta_1 = beta_below.conclusion().arg(0);
  const Theorem once_A = cut(mass, book["ratios.N_A_once"]),
                once_B = cut(mass, book["ratios.N_B_once"]);
  const Theorem counts = both(
      {tautology(eq(N_A(), 1),
                 {once_A, linear(le(alpha_1.conclusion().arg(0), alpha), {alpha_1, is_heavy})}),
       tautology(eq(N_B(), 1),
                 {once_B, linear(le(beta_1, alpha), {beta_below, alpha_1, is_heavy})})});
  book.show("N_A", "", "Both blocks have one collision each, A", part(counts, 0));
  book.show("N_B", "", "and B:", part(counts, 1));
  const Theorem sum = names.name("masses", {alpha}, 1 + alpha, "With");
  book.facts.push_back(
      linear(lt(0, of_alpha("masses")), {sum, positive(1 + alpha, {assume(alpha_positive)})}));
  const Theorem part_of = names.name("per_mass", {alpha}, 1 / of_alpha("masses"));
  const Theorem share = names.name("share", {alpha}, alpha * of_alpha("per_mass"));
  const Theorem less = names.name("lead", {alpha}, 1 - alpha);
  const Expr i = of_alpha("per_mass"), f = of_alpha("share"), D = of_alpha("lead");
  const Theorems rules{share, less, rewrite(sum, part_of)};
  const auto first = [&](const std::string& id, std::size_t which) {
    return part(use(discharge(le(1, n), book[id]), {{n, 1}}, {one}), which);
  };
  const Theorem zero = equation(Expr(1) - 1, 0);
  const Theorem starts = book["cycle.start_vector"];
  Theorems steps{part(starts, 0), part(starts, 1), part(starts, 2)};
  for (const Theorem& t :
       {first("cycle.P", 0), first("cycle.P", 1), first("cycle.Q", 0), first("cycle.Q", 1)})
    steps.push_back(rewrite(zero, t));
  const Theorem p1 = positive(1 + alpha, {assume(alpha_positive)});
  const auto show = [&](const std::string& name, Expr velocity, Expr form) {
    return book.show(name, "", name == "a" ? "the first velocities are" : "and",
                     equation(velocity, V * form, steps + rules, {p1}));
  };
  const Theorems after{show("a", a(1), D * i), show("b", b(1), 4 * f * i), show("c", c(1), 2 * i),
                       show("c_prime", c_prime(1), -2 * D * power(i, 2))};
  const Theorem N_is = linear(eq(N(), 2 * Expr(1)), {part(cut(mass, book["counting.shares"]), 1),
                                                     part(counts, 0), part(counts, 1)});
  const Theorem end =
      cut(mass, use(discharge(le(1, n), discharge(eq(N(), 2 * n), book["terminal.after_Q"])),
                    {{n, 1}}, {one}));
  const Theorem last = tautology(end.conclusion().arg(1), {end, N_is});
  for (const auto& [name, which, velocity] :
       {std::tuple{"a_t", 2U, 0U}, std::tuple{"b_t", 3U, 1U}, std::tuple{"c_t", 4U, 3U}})
    book.show(name, "", which == 2U ? "which are the terminal ones:" : "and",
              chain(part(last, which), cut(mass, after[velocity])));
  book.show("rho", "", "with the fraction of the energy",
            equation(fun("rho", {alpha, V}), 16 * power(f * i, 2),
                     {book["evaluators_end.def_rho"], book["heavy.b_t"]}, {assume(V_positive)}));
}
}  // namespace

void evaluators(Book& book) {
  book.chapter("evaluators", "Forms for evaluation", {alpha_positive, from_0});
  Names names(book);
  const Angle a = angle(names);
  velocities(names, a);
  at_the_end(names, a);
  ratio_forms(names);
  heavy_ball(names);
}
}  // namespace derivation
