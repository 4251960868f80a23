// SPDX-License-Identifier: GPL-2.0-or-later
// B's terminal velocity: V at the magic ratios only, least at the deficient ones.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr a_t() { return fun("a_t", {alpha, V}); }
Expr b_t() { return fun("b_t", {alpha, V}); }
Expr c_t() { return fun("c_t", {alpha, V}); }
Expr half() { return psi() / 2; }
Expr angle() { return (N_B() + rational(1, 2)) * psi(); }
Theorem equal_sides(Expr f, Expr g, const Theorem& forth, const Theorem& back) {
  return tautology(iff(f, g), {discharge(f, forth), discharge(g, back)});
}

/// What all statements use.
struct Given {
  explicit Given(Book& book)
      : psi_positive(part(book["rotation.psi_range"], 0)),
        psi_below(part(book["rotation.psi_range"], 1)),
        below(part(book["constraints.N_B_angle"], 0)),
        reached(part(book["constraints.N_B_angle"], 1)),
        N_B_from_1(part(book["counting.at_least"], 1)),
        cos_half(book["rotation.cos_half_psi"]),
        b_is(book["terminal.b"]),
        form(equation((2 + alpha) * b_t(), V * (1 - (1 + alpha) * cos(angle())), {b_is}, {p2})) {}
  Theorem mass = assume(alpha_positive), speed = assume(V_positive);
  Theorem p1 = positive(1 + alpha, {mass}), p2 = positive(2 + alpha, {mass});
  Theorem psi_positive, psi_below, below, reached, N_B_from_1, cos_half, b_is, form;
};

/// Four ways to say that N_B psi is as at a threshold: by B's velocity, by a cosine, by N_B, and by
/// the ratio.
struct Condition {
  std::string name, ratio, cosine_label, count_label;
  Expr velocity, cosine, shift, target;  // cos(target) = cosine
  Expr denominator(Expr i) const { return 2 * i + 2 * shift; }
};
void conditions(Book& book, const Given& g, const Condition& which) {
  const Expr fast = eq(b_t(), which.velocity), turned_back = eq(cos(angle()), which.cosine);
  Certificate c;
  c.multipliers = {g.speed, g.p1};
  c.nonzero = {g.p1, g.p2};
  c.equations = {{1, g.form}, {-(2 + alpha), assume(fast)}};
  const Theorem cosine = arithmetic(turned_back, c);
  const Theorem velocity = equation(fast, {g.b_is, assume(turned_back)}, {g.p1, g.p2});
  book.show(
      which.name + "_cosine", which.cosine_label,
      which.name == "magic"
          ? "B takes everything if and only if a cosine is -1,"
          : "B has 2V/(2 + alpha) if and only if another cosine is the negative of cos(psi/2),",
      equal_sides(fast, turned_back, cosine, velocity));

  // cos(angle) = cos(target) from 0 to pi; beyond pi the angle is 2 pi - target.
  const Expr y = angle(), t = which.target;
  const Theorem target_is = equation(cos(t), which.cosine,
                                     angles({cos(t)}, {pi(), half()}, false) +
                                         Theorems{axiom("cos pi"), axiom("sin pi"), g.cos_half},
                                     {g.p1});
  const Theorem same_cosine = chain(assume(turned_back), turned(target_is));
  const Theorem from = linear(le(0, t), {g.psi_below, positive(pi())});
  const Theorem to = linear(le(t, pi()), {g.psi_positive});
  const Theorem above_0 = linear(lt(0, y), {g.reached, g.psi_below, g.psi_positive});
  const Theorem lower = assume(le(y, pi())), upper = assume(lt(pi(), y));
  const Theorem first = same_angle(same_cosine, above_0, lower, from, to);
  const Theorem mirrored = equation(cos(2 * pi() - y), cos(t),
                                    angles({cos(2 * pi() - y)}, {pi(), y}, false) +
                                        Theorems{axiom("cos pi"), axiom("sin pi"), same_cosine});
  const Theorem second =
      same_angle(mirrored, linear(lt(0, 2 * pi() - y), {g.below, g.psi_below, g.psi_positive}),
                 linear(lt(2 * pi() - y, pi()), {upper}), from, to);
  const Theorem is_target = tautology(
      eq(y, t), {discharge(lower.conclusion(), first),
                 discharge(upper.conclusion(), linear(eq(y, t), {second, g.below, upper}))});
  const Expr count = eq(N_B(), pi() / psi() - which.shift);
  const Theorem counted =
      equation(count, {linear(eq(psi() * N_B(), t - psi() / 2), {is_target})}, {g.psi_positive});
  const Theorem at_target = equation(y, t, {assume(count)}, {g.psi_positive});
  book.show(which.name + "_count", which.count_label, "which means that nothing is rounded in N_B,",
            equal_sides(turned_back, count, counted,
                        restate(turned_back, rewrite(turned(at_target), target_is))));

  const Expr at = eq(alpha, fun(which.ratio, {N_B()}));
  const Expr quotient = pi() / which.denominator(N_B());
  const Theorem d_positive = linear(lt(0, which.denominator(N_B())), {g.N_B_from_1});
  const Theorem definition =
      use(discharge(le(1, k), book["ratios." + which.ratio + "k"]), {{k, N_B()}}, {g.N_B_from_1});
  const Theorem solved = equation(alpha, (1 - cos(half())) / cos(half()), {g.cos_half},
                                  {g.p1, part(book["rotation.half_signs"], 1)});
  const Theorem turn =
      equation(psi() * N_B(), pi() - which.shift * psi(), {assume(count)}, {g.psi_positive});
  const Theorem at_angle = equation(half(), quotient, {turn}, {d_positive});
  const Theorem ratio = chain(rewrite(at_angle, solved), turned(definition));
  const Theorem back = cut(g.N_B_from_1, instantiate(book[which.name + ".angle"], {{k, N_B()}}));
  book.show(which.name + "_only", "", "and that the ratio is a threshold:",
            equal_sides(count, at, ratio,
                        equation(count, {linear(eq(psi(), 2 * quotient), {back})},
                                 {g.psi_positive, d_positive})));
}

/// Where B and C go on together, momentum and energy leave one velocity for both.
void together(Book& book, const Given& g) {
  const Theorem same = assume(eq(c_t(), b_t()));
  const Theorem momentum = rewrite(same, part(book["terminal.energy"], 0));
  const Theorem energy = rewrite(same, part(book["terminal.energy"], 1));
  const Theorem coupled = book.show(
      "coupled", "", "Where B and C end with the same velocity, two equations are left,",
      both({linear(eq((1 + alpha) * b_t() + a_t(), V), {momentum}),
            linear(eq((1 + alpha) * power(b_t(), 2) + power(a_t(), 2), power(V, 2)), {energy})}));
  Certificate c;  // (1 + alpha) b ((2 + alpha) b - 2V) = 0
  const Theorem moving = part(book["terminal.order"], 2);
  c.multipliers = {g.p1, moving, g.p2};
  c.nonzero = {g.p2};
  const Expr rest = V - (1 + alpha) * b_t();
  c.equations = {{1, part(coupled, 1)}, {-(rest + a_t()), part(coupled, 0)}};
  const Theorem fast = arithmetic(eq(b_t(), 2 * V / (2 + alpha)), c);
  book.show("together", "eq:defb-terminal", "with one solution in which B moves:",
            both({equation(a_t(), -alpha * V / (2 + alpha),
                           {linear(eq(a_t(), rest), {part(coupled, 0)}), fast}, {g.p2}),
                  fast}));
}

/// 2V/(2 + alpha) <= b_t, as b_t = 2V/(2 + alpha) - 2V (1 + alpha)/(2 + alpha) cos(...) cos(...)
Theorem at_least(Book& book, const Given& g) {
  const Expr early = N_B() * half(), late = (N_B() + 1) * half();
  const Theorem quarter_turn = linear(le(0, pi() / 2), {positive(pi())});
  const Theorem falls = cosine_falls(quarter_turn, linear(le(pi() / 2, late), {g.reached}),
                                     linear(le(late, pi()), {g.below, g.psi_below}));
  const Theorem cos_late = linear(le(0, -cos(late)), {falls, axiom("cos pi/2")});
  const Theorem early_from = linear(lt(0, early), {g.reached, g.psi_below, g.psi_positive});
  const Theorem cos_early = cosine_positive(early_from, linear(lt(early, pi() / 2), {g.below}));
  const Expr sum = cos(half()) + cos(angle());
  const Theorem split =
      equation(sum, 2 * cos(late) * cos(early), angles({sum, cos(late)}, {early, half()}));
  Certificate c;
  c.multipliers = {g.p2};
  c.nonzero = {g.p2};
  c.equations = {{-1, g.form},
                 {-V, equation((1 + alpha) * cos(half()), 1, {g.cos_half}, {g.p1})},
                 {V * (1 + alpha), split}};
  c.products = {{2, {g.speed, g.p1, cos_late, cos_early}, {}}};
  return book.show("at_least", "", "B never has less than that,",
                   arithmetic(le(2 * V / (2 + alpha), b_t()), c));
}

/// For k: x = pi/(2k + 2), the half of psi at beta_k, and what B has there.
struct AtDeficient {
  Expr ratio, x_k;
  AngleRange range;
  Theorem ratio_positive, velocity;
};
AtDeficient at_deficient(Book& book) {
  const Expr ratio = fun("beta_", {k}), d = 2 * k + 2, x_k = pi() / d;
  const AngleRange range = range_of(d, linear(lt(2, d), {assume(le(1, k))}));
  const Theorem falls = cosine_falls(linear(le(0, 0), {}), range.positive,
                                     linear(le(x_k, pi()), {range.below_edge, positive(pi())}));
  const Theorem versed = linear(lt(0, 1 - cos(x_k)), {falls, axiom("cos 0")});
  const Theorem quotient =
      positive((1 - cos(x_k)) / cos(x_k), {versed, book["ratios.beta_k_cosine"]});
  const Theorem ratio_positive = linear(lt(0, ratio), {book["ratios.beta_k"], quotient});
  know(ratio_positive);
  const auto velocity = [&](const std::string& id) {
    const Theorem at_ratio = instantiate(book[id], {{alpha, ratio}});
    return part(cut(ratio_positive, cut(equation(ratio, ratio), at_ratio)), 1);
  };
  return {ratio, x_k, range, ratio_positive,
          book.show("at_deficient", "", "and has just that at beta_k,",
                    chain(velocity("terminal.definitions"), velocity("deficient.terminal")))};
}

/// Between beta_k and alpha_k: pi/(2k + 2) < psi/2 < pi/(2k + 1), so N_B = k.
struct Between {
  Theorem from, next_step, whole, count;
};
Between between(Book& book, const Given& g, const AtDeficient& at) {
  const Theorem k_from_1 = assume(le(1, k)), above = assume(lt(at.ratio, alpha));
  const Theorem below = assume(lt(alpha, fun("alpha_", {k})));
  const auto compared = [&](const std::string& id, const std::string& ratio, Expr d,
                            const AngleRange& range) {
    return rewrite(turned(book[ratio]), at_angle(book[id], d, range));
  };
  const Expr d = 2 * k + 2, e = 2 * k + 1;
  const Theorem e_positive = linear(lt(0, e), {k_from_1});
  const AngleRange upper = range_of(e, linear(lt(2, e), {k_from_1}));
  const Theorem from = tautology(lt(at.x_k, half()),
                                 {compared("ratios.passed", "ratios.beta_k", d, at.range), above});
  const Theorem to = tautology(lt(half(), pi() / e),
                               {compared("ratios.reached", "ratios.alpha_k", e, upper), below});
  const auto steps = [&](Expr per, const Theorem& less) {
    const Theorem per_positive = linear(lt(0, per), {k_from_1});
    return linear(lt(per * less.conclusion().arg(0), per * less.conclusion().arg(1)),
                  {times(per_positive, less)});
  };
  const Theorem next_step = linear(lt(pi() / 2, (k + 1) * half()),
                                   {steps(k + 1, from), equation((k + 1) * at.x_k, pi() / 2, {},
                                                                 {linear(lt(0, d), {k_from_1})})});
  const Theorem whole = linear(lt(e * half(), pi()),
                               {steps(e, to), equation(e * (pi() / e), pi(), {}, {e_positive})});
  const Expr z = pi() / psi();
  const auto quotient = [&](Expr goal, Expr difference, const Theorem& why) {
    Certificate c;
    c.multipliers = {g.psi_positive};
    c.nonzero = {g.psi_positive};
    c.products = {{1, {linear(lt(0, difference), {why, g.psi_positive})}, {}}};
    return arithmetic(goal, c);
  };
  const Theorem more = quotient(lt(k - 1, z - 1), pi() - k * psi(), whole);
  const Theorem less =
      linear(le(z - 1, k), {quotient(lt(z, k + 1), (k + 1) * psi() - pi(), next_step)});
  return {
      from, next_step, whole,
      chain(book["counting.N_B"],
            tautology(eq(ceil(z - 1), k), {instantiate(ceiling_is(), {{x, z - 1}}), more, less}))};
}

/// beta_k < alpha, alpha < alpha_k |- b_t at beta_k < b_t
Theorem after_minimum(Book& book, const Given& g, const AtDeficient& at) {
  const Between between_both = between(book, g, at);
  const auto& [from, next_step, whole, count] = between_both;
  const Theorem k_from_1 = assume(le(1, k)), d_positive = linear(lt(0, 2 * k + 2), {k_from_1});
  const Expr x_k = at.x_k;
  // V - b_t = V (cos(u)/cos(psi/4))^2 with u = (k + 1/2) psi/2; at beta_k tan(x/2) in its place.
  const Expr u = (k + rational(1, 2)) * half(), q = psi() / 4, v = x_k / 2, right = pi() / 2;
  const Theorem cos_q = book["table.quarter_cosine"];
  const Theorem cos_v =
      cosine_positive(linear(lt(0, v), {at.range.positive}),
                      linear(lt(v, right), {at.range.positive, at.range.below_edge}));
  const Theorem u_positive = linear(lt(0, u), {next_step, g.psi_below, positive(pi())});
  const Theorem cos_u = cosine_positive(u_positive, linear(lt(u, right), {whole}));
  const Theorem sin_v = use("sin positive", {{x, v}},
                            {linear(lt(0, v), {at.range.positive}),
                             linear(lt(v, pi()), {at.range.positive, at.range.below_edge})});
  const Theorems facts{from,
                       times(linear(lt(0, k), {k_from_1}), from),
                       equation((k + 1) * x_k, pi() / 2, {}, {d_positive}),
                       times(k_from_1, at.range.positive),
                       at.range.positive,
                       whole,
                       g.psi_below,
                       g.psi_positive};
  const auto falls = [&](Expr p, Expr r) {
    return cosine_falls(linear(le(0, p), facts), linear(lt(p, r), facts),
                        linear(le(r, pi()), facts));
  };
  const Expr w = right - v;
  const Theorem first = falls(w + q, u + v), second = falls(w - q, u - v);
  const Theorem product_u = equation(cos(u + v) + cos(u - v), 2 * cos(u) * cos(v),
                                     angles({cos(u + v), cos(u - v)}, {u, v}, false));
  const Theorem product_v = equation(cos(w + q) + cos(w - q), 2 * sin(v) * cos(q),
                                     angles({cos(w + q), cos(w - q)}, {right, v, q}, false) +
                                         Theorems{axiom("cos pi/2"), axiom("sin pi/2")});
  const Theorem smaller =
      linear(lt(cos(u) * cos(v), sin(v) * cos(q)), {first, second, product_u, product_v});
  const Theorem here = rewrite(count, book["terminal.b"]);
  const Theorem lack = equation(b_t(), V - V * power(cos(u) / cos(q), 2),
                                Theorems{here, part(book["power.quarter"], 1)} +
                                    angles({cos((k + rational(1, 2)) * psi())}, {u}),
                                {g.p1, g.p2, cos_q});
  const Theorem two_more = positive(2 + at.ratio, {at.ratio_positive});
  const Theorem lack_there =
      equation(at.velocity.conclusion().arg(0), V - V * power(sin(v) / cos(v), 2),
               Theorems{at.velocity, book["ratios.beta_k"]} + angles({cos(x_k)}, {v}),
               {two_more, book["ratios.beta_k_cosine"], cos_v});
  Certificate c;
  c.multipliers = {cos_q, cos_q, cos_v, cos_v};
  c.nonzero = {cos_q, cos_v};
  c.products = {{1,
                 {g.speed, smaller,
                  positive(sin(v) * cos(q) + cos(u) * cos(v), {sin_v, cos_q, cos_u, cos_v})},
                 {}}};
  const Theorem values =
      arithmetic(lt(lack_there.conclusion().arg(1), lack.conclusion().arg(1)), c);
  return linear(lt(lack_there.conclusion().arg(0), b_t()), {values, lack, lack_there});
}
}  // namespace

void minima(Book& book) {
  book.chapter("minima", "What B takes", {alpha_positive, V_positive, le(1, k)});
  const Given g(book);
  conditions(book, g,
             {"magic", "alpha_", "eq:magic-b-cond", "eq:magic-b-cond-simple", V, -1, rational(1, 2),
              pi()});
  conditions(book, g,
             {"deficient", "beta_", "eq:def-b-cond", "", 2 * V / (2 + alpha), -1 / (1 + alpha), 1,
              pi() - half()});
  together(book, g);
  const Theorem least = at_least(book, g);
  const AtDeficient at = at_deficient(book);
  const Theorem after = after_minimum(book, g, at);
  const Theorem before = assume(lt(alpha, at.ratio));
  Certificate c;
  const Theorem two_more = positive(2 + at.ratio, {at.ratio_positive});
  c.multipliers = {g.p2, two_more};
  c.nonzero = {g.p2, two_more};
  c.products = {{2, {g.speed, before}, {}}};
  const Theorem slower =
      linear(after.conclusion(),
             {arithmetic(lt(2 * V / (2 + at.ratio), 2 * V / (2 + alpha)), c), least, at.velocity});
  book.show("minimum", "", "where it has less than at any other ratio below alpha_k:",
            tautology(after.conclusion(),
                      {discharge(lt(at.ratio, alpha), after),
                       discharge(before.conclusion(), slower), assume(neq(alpha, at.ratio)),
                       use("equal or less or greater", {{x, alpha}, {y, at.ratio}})}));
}
}  // namespace derivation
