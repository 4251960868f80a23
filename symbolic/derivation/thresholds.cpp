// SPDX-License-Identifier: GPL-2.0-or-later
// The mass ratios at which the counts change: N_A = k if and only if alpha_k <= alpha <
// alpha_(k-1); beta_k for N_B.
#include "derivation/symbols.hpp"
#include "kernel/print.hpp"

namespace derivation {
namespace {
const Expr edge = pi() / 2;
Expr half() { return psi() / 2; }
Theorem pi_positive() { return positive(pi()); }
/// A goal l < r or l <= r about 1/cos, from `difference` of the right sign, times cosines and
/// others proved positive.
Theorem multiplied(Expr goal, const Theorems& positives, const Theorems& factors) {
  Certificate c;
  c.multipliers = positives;
  c.nonzero = positives;
  for (const Theorem& f : factors)
    if (f.conclusion().op() == Op::Lt) c.nonzero.push_back(f);
  c.products = {{1, factors, {}}};
  return arithmetic(goal, c);
}

/// For 0 < x < pi/2: the ratio with psi/2 = x is at most alpha if and only if x <= psi/2.
void ratio_of_angle(Book& book) {
  const Theorem mass = assume(alpha_positive);
  const Theorem above_0 = assume(lt(0, x));
  const Theorem below_edge = assume(lt(x, edge));
  const Theorem p1 = positive(1 + alpha, {mass});
  const Theorem value = book["rotation.cos_half_psi"];
  const Expr ratio = solve({eq(value.conclusion().arg(1), cos(x))}, {alpha})[0];
  const Theorem cx = cosine_positive(above_0, below_edge);
  know(cx);
  const Theorem solved = assume(eq(alpha, ratio));
  Certificate back;
  back.multipliers = {p1};
  back.nonzero = {p1, cx};
  back.equations = {{-cos(x), solved}};
  book.show("ratio", "",
            "The mass ratio at which psi/2 is an angle x between 0 and pi/2, by solving "
            "1/(1 + alpha) = cos(x):",
            chain(value, arithmetic(eq(1 / (1 + alpha), cos(x)), back)));
  const Theorem range_0 = part(book["rotation.psi_range"], 0);
  const Theorem range_1 = part(book["rotation.psi_range"], 1);
  const Theorem less = assume(lt(half(), x));
  const Theorem more = assume(lt(x, half()));
  const Theorem same = assume(eq(half(), x));
  const Theorem x_to_pi = linear(le(x, pi()), {below_edge, pi_positive()});
  const Theorem half_from_0 = linear(le(0, half()), {range_0});
  const Theorem half_to_pi = linear(le(half(), pi()), {range_0, range_1});
  const auto compared = [&](Expr goal, Expr cosines, const Theorem& falls) {
    return multiplied(goal, {cx}, {p1, linear(cosines, {falls, value})});
  };
  const Theorem beyond = compared(lt(alpha, ratio), lt(cos(x), 1 / (1 + alpha)),
                                  cosine_falls(half_from_0, less, x_to_pi));
  const Theorem within = compared(lt(ratio, alpha), lt(1 / (1 + alpha), cos(x)),
                                  cosine_falls(above_0, more, half_to_pi));
  const Theorem at_x = equation(
      ratio, alpha, {linear(eq(cos(x), 1 / (1 + alpha)), {rewrite(same, value)})}, {cx, p1});
  const Theorems cases{discharge(less.conclusion(), beyond), discharge(more.conclusion(), within),
                       use("equal or less or greater", {{x, half()}, {y, x}})};
  const auto in_case = [&](Expr f, Expr g, const Theorem& angle, const Theorem& ratios) {
    Theorems all = cases;
    for (const auto& [given, proof] : {std::pair{angle, ratios}, std::pair{same, at_x}})
      all = all +
            Theorems{discharge(given.conclusion(), both({linear(f, {proof}), linear(g, {given})}))};
    return tautology(iff(f, g), all);
  };
  book.show("reached", "", "Ratios from there on have psi/2 >= x, and no others:",
            in_case(le(ratio, alpha), le(x, half()), more, within));
  book.show("passed", "", "and larger ratios psi/2 > x:",
            tautology(iff(lt(ratio, alpha), lt(x, half())),
                      {in_case(le(alpha, ratio), le(half(), x), less, beyond)}));
  // A larger angle is that of a larger ratio.
  const Theorem x_less = assume(lt(x, y));
  const Theorem y_below = assume(lt(y, edge));
  const Theorem cy = cosine_positive(linear(lt(0, y), {above_0, x_less}), y_below);
  const Theorem cosines =
      cosine_falls(above_0, x_less, linear(le(y, pi()), {y_below, pi_positive()}));
  const Theorem cx_too = cosine_positive(above_0, linear(lt(x, edge), {x_less, y_below}));
  know(both({cy, cx_too}));
  book.show("rises", "", "A larger angle is that of a larger ratio:",
            multiplied(lt(ratio, substitute(ratio, {{x, y}})), {cx_too, cy}, {cosines}));
}

struct Threshold {
  std::string count, name, label, range_label;
  Expr shift;  // N = ceil(pi/psi - shift)
  Expr denominator(Expr i) const { return 2 * i + 2 * shift.value(); }
};

void threshold(Book& book, const Threshold& which) {
  const Theorem k_from_1 = assume(le(1, k));
  const Theorem k_from_2 = assume(le(2, k));
  const Theorem psi_positive = part(book["rotation.psi_range"], 0);
  const Theorem psi_below = part(book["rotation.psi_range"], 1);
  const Theorem number = book["counting." + which.count];
  const Expr count = number.conclusion().arg(0);
  const Expr d = which.denominator(k), d_before = which.denominator(k - 1);
  const Expr ratio = book["ratios.reached"].conclusion().arg(0).arg(0);
  const AngleRange here = range_of(d, linear(lt(2, d), {k_from_1}));
  const AngleRange before = range_of(d_before, linear(lt(2, d_before), {k_from_2}));
  const Theorem cosine = cosine_positive(here.positive, here.below_edge);
  know(cosine);
  book.show(which.name + "k_cosine", "", "The cosine of pi/(" + text(d) + ") is positive:", cosine);
  const Theorem definition = define(which.name, {k}, substitute(ratio, {{x, pi() / d}}), 0);
  restrict_domain(which.name, {k}, le(1, k));
  book.show(which.name + "k", "",
            "The ratio at which psi/2 = pi/(" +
                std::string(which.count == "N_A" ? "2k + 1" : "2k + 2") + "):",
            under({le(1, k)}, definition));
  const Expr secant = Expr(-1) + 1 / cos(pi() / d);
  book.show(which.name + "k_paper", which.label, "as the paper writes it:",
            equation(fun(which.name, {k}), secant, {definition}, {cosine}));

  // N = k if and only if k - 1 < pi/psi - shift <= k, that is pi/d_k <= psi/2 < pi/d_(k-1)
  const Expr z = pi() / psi() - which.shift;
  const auto counted = [&](Expr i) {
    const Expr meaning = logic_and({lt(i - 1, z), le(z, i)});
    const Theorem ceiling = instantiate(ceiling_is(), {{x, z}, {k, i}});
    return restate(iff(eq(count, i), meaning), rewrite(turned(number), ceiling));
  };
  const auto side = [&](Expr i, const Theorem& d_positive) {  // z <= i iff pi/d_i <= psi/2
    const Expr angle = pi() / which.denominator(i);
    const Theorem in = assume(le(z, i));
    const Theorem out = assume(lt(i, z));
    const auto by = [&](Expr goal, const Theorem& relation) {
      Certificate c;
      c.multipliers = {d_positive};
      c.nonzero = {d_positive, psi_positive};
      c.products = {{1, {psi_positive, relation}, {}}};
      return arithmetic(goal, c);
    };
    return tautology(iff(le(z, i), le(angle, half())),
                     {discharge(in.conclusion(), by(le(angle, half()), in)),
                      discharge(out.conclusion(), by(lt(half(), angle), out))});
  };
  const auto reached = [&](Expr i,
                           const AngleRange& range) {  // threshold_i <= alpha iff pi/d_i <= psi/2
    const Theorem at = at_angle(book["ratios.reached"], which.denominator(i), range);
    return rewrite(turned(instantiate(definition, {{k, i}})), at);
  };
  const auto t = [&](Expr i) { return fun(which.name, {i}); };
  const auto weaker = [&](const Theorem& from_1) {
    return cut(linear(le(1, k), {k_from_2}), from_1);
  };
  const Theorem in_range = tautology(
      iff(eq(count, k), logic_and({le(t(k), alpha), lt(alpha, t(k - 1))})),
      {counted(k), weaker(side(k, linear(lt(0, d), {k_from_1}))), weaker(reached(k, here)),
       side(k - 1, linear(lt(0, d_before), {k_from_2})), reached(k - 1, before)});
  book.show(which.count + "_range", which.range_label,
            which.count + " = k exactly from there up to the ratio before,", in_range);
  // k = 1: the other side always holds, as psi < pi.
  Certificate c;
  c.multipliers = {psi_positive};
  c.nonzero = {psi_positive};
  c.products = {{1, {psi_below}, {}}, {1 - which.shift.value(), {psi_positive}, {}}};
  const Theorem always = arithmetic(lt(Expr(1) - 1, z), c);
  const auto at_1 = [&](const Theorem& theorem) {
    return use(discharge(le(1, k), theorem), {{k, 1}}, {linear(le(1, 1), {})});
  };
  book.show(which.count + "_once", which.range_label,
            "and " + which.count + " = 1 from the first on:",
            tautology(iff(eq(count, 1), le(t(1), alpha)),
                      {counted(1), at_1(side(k, linear(lt(0, d), {k_from_1}))),
                       at_1(reached(k, here)), always}));
}

/// ... < beta_2 < alpha_2 < beta_1 < alpha_1 = 1
void order(Book& book) {
  const Theorem k_from_1 = assume(le(1, k));
  const Theorem k_from_2 = assume(le(2, k));
  const Theorem rises = book["ratios.rises"];
  const auto below = [&](const Theorem& smaller, Expr ds, const Theorem& larger, Expr dl,
                         const Theorem& from) {  // pi/ds < pi/dl, as ds > dl > 2
    const Theorem s_positive = linear(lt(0, ds), {from});
    const Theorem l_positive = linear(lt(0, dl), {from});
    const Theorem less = multiplied(lt(pi() / ds, pi() / dl), {s_positive, l_positive},
                                    {pi_positive(), linear(lt(dl, ds), {})});
    const Theorem at = instantiate(rises, {{x, pi() / ds}, {y, pi() / dl}});
    const AngleRange s = range_of(ds, linear(lt(2, ds), {from}));
    const AngleRange l = range_of(dl, linear(lt(2, dl), {from}));
    const Theorem angles_less = cut(s.positive, cut(less, cut(l.below_edge, at)));
    return rewrite(turned(larger), rewrite(turned(smaller), angles_less));
  };
  const auto definition = [&](const std::string& name, Expr i, const Theorem& from_1) {
    return use(discharge(le(1, k), book["ratios." + name + "k"]), {{k, i}}, {from_1});
  };
  const Theorem alpha_k = definition("alpha_", k, k_from_1);
  book.show("order", "", "Their order: for every k,",
            below(definition("beta_", k, k_from_1), 2 * k + 2, alpha_k, 2 * k + 1, k_from_1));
  const Theorem one_less = linear(le(1, k - 1), {k_from_2});
  const Theorem from_1 = linear(le(1, k), {k_from_2});
  book.show("order_next", "", "and",
            below(definition("alpha_", k, from_1), 2 * k + 1, definition("beta_", k - 1, one_less),
                  2 * (k - 1) + 2, k_from_2));
  // alpha_1 = 1: cos(3x) = -1 at x = pi/3, and (c + 1)(2c - 1)^2 = 0.
  const Expr third = pi() / 3, cosine = cos(third);
  const Theorem c_positive =
      cosine_positive(positive(third), linear(lt(third, edge), {pi_positive()}));
  const Theorem triple = linear(eq(4 * power(cosine, 3) - 3 * cosine, -1),
                                {equation(cos(3 * third), 4 * power(cosine, 3) - 3 * cosine,
                                          angles({cos(3 * third)}, {third})),
                                 restate(eq(cos(3 * third), -1), axiom("cos pi"))});
  const Theorem other = assume(neq(cosine, rational(1, 2)));
  Certificate c;  // (1 + c)(1/2 - c)(1/2 - c) = (4c^3 - 3c + 1)/4
  c.multipliers = {linear(lt(0, 1 + cosine), {c_positive}), other};
  c.equations = {{-rational(1, 4), triple}};
  const Theorem is_half =
      tautology(eq(cosine, rational(1, 2)),
                {discharge(other.conclusion(), arithmetic(eq(cosine, rational(1, 2)), c))});
  book.show("third", "", "The cosine of a third of pi", is_half);
  const Expr angle = pi() / (2 * Expr(1) + 1);
  book.show("alpha_1", "", "and the first is 1:",
            equation(fun("alpha_", {1}), 1,
                     {definition("alpha_", 1, linear(le(1, 1), {})),
                      restate(eq(cos(angle), rational(1, 2)), is_half)},
                     {restate(lt(0, cos(angle)), c_positive)}));
}
}  // namespace

AngleRange range_of(Expr d, const Theorem& above_2) {
  const Theorem d_positive = linear(lt(0, d), {above_2});
  Certificate c;
  c.multipliers = {d_positive};
  c.nonzero = {d_positive};
  c.products = {{rational(1, 2).value(), {pi_positive(), above_2}, {}}};
  return {positive(pi() / d, {d_positive}), arithmetic(lt(pi() / d, edge), c)};
}
Theorem at_angle(const Theorem& t, Expr d, const AngleRange& range) {
  return cut(range.positive, cut(range.below_edge, instantiate(t, {{x, pi() / d}})));
}

void thresholds(Book& book) {
  book.chapter("ratios", "Thresholds", {alpha_positive, V_positive});
  ratio_of_angle(book);
  threshold(book, {"N_A", "alpha_", "exact:ak", "NA-range", rational(1, 2)});
  threshold(book, {"N_B", "beta_", "exact:bk", "NB-range", 1});
  order(book);
}
}  // namespace derivation
