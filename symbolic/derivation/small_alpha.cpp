// SPDX-License-Identifier: GPL-2.0-or-later
// Small mass ratios: the ranges of theta and psi, and what the paper approximates as bounds from
// both sides.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr light = lt(alpha, 1);
const Expr p = sqrt(2 * alpha), q = sqrt(alpha / (2 + alpha));

/// Of atan(x) for 0 < x: x - x^3/3 <= atan(x) and atan(x) <= x
Theorem atan_bounds(const Theorem& positive_x) {
  const Expr t = positive_x.conclusion().arg(1);
  return use("atan bounds", {{x, t}}, {linear(le(0, t), {positive_x})});
}

void theta_bounds(Book& book) {
  const Theorem mass = assume(alpha_positive);
  const Expr s = sqrt(alpha);
  const Theorem s_positive = positive(s, {mass});
  const Theorem definition = book["ball.theta"];
  const Theorem above = linear(lt(0, theta()), {definition, positive(atan(s), {s_positive})});
  const Theorem below =
      linear(lt(theta(), pi()), {definition, part(use("atan range", {{x, s}}), 1)});
  book.show("theta_range", "", "The range of theta:", both({above, below}));
  const Theorem cosine =
      linear(lt(0, cos(theta())),
             {book["ball.cos_theta"], positive((1 - alpha) / (1 + alpha), {mass, assume(light)})});
  const Theorem beyond = assume(le(pi() / 2, theta()));
  const Theorem falls = cosine_falls(linear(le(0, pi() / 2), {positive(pi())}), beyond, below);
  book.show("theta_light", "", "for a ball lighter than a block:",
            otherwise(lt(theta(), pi() / 2), linear(lt(0, 0), {cosine, falls, axiom("cos pi/2")})));
  const Theorem bounds = atan_bounds(s_positive);
  const Theorem cube = equation(power(s, 3), alpha * s, {root_squared(mass)});
  book.show("theta_bounds", "", "theta is about 2 sqrt(alpha):",
            both({linear(le(2 * s * (1 - alpha / 3), theta()), {definition, part(bounds, 0), cube}),
                  linear(le(theta(), 2 * s), {definition, part(bounds, 1)})}));
}

/// 2 p (1 - 5 alpha/12) <= psi and psi < 2 p, as psi = 4 atan(q), q^2 = alpha/(2 + alpha).
Theorem psi_bounds(Book& book) {
  const Theorem mass = assume(alpha_positive);
  const Theorem p2 = positive(2 + alpha, {mass});
  const Theorem q_positive = positive(q, {mass});
  const Theorem p_squared = root_squared(positive(2 * alpha, {mass}));
  const Theorem q_squared = equation((2 + alpha) * power(q, 2), alpha,
                                     {root_squared(positive(alpha / (2 + alpha), {mass}))}, {p2});
  const Theorems sum{positive(p + 2 * q, {mass})};
  Certificate upper;  // (p + 2q)(p - 2q) = 2 alpha q^2
  upper.multipliers = sum;
  upper.equations = {{-1, p_squared}, {2, q_squared}};
  upper.products = {{2, {mass, q_positive, q_positive}, {}}};
  const Theorem q_below = arithmetic(lt(2 * q, p), upper);
  Certificate lower;  // (p + 2q)(2q - p + alpha p/4) = alpha^2 q^2/2 + alpha q (p - 2q)/2
  lower.multipliers = sum;
  lower.equations = {{1 - alpha / 4, p_squared}, {alpha / 2 - 2, q_squared}};
  const cln::cl_RA half = rational(1, 2).value();
  lower.products = {{half, {mass, mass}, {q}}, {half, {mass, q_positive, q_below}, {}}};
  const Theorem q_above = arithmetic(le(p - alpha * p / 4, 2 * q), lower);
  const Theorem q_squared_below =
      linear(le(0, alpha / 2 - power(q, 2)),
             {q_squared, positive(alpha * power(q, 2), {mass, q_positive})});
  const Theorem bounds = atan_bounds(q_positive);
  const Theorem quarter = book["table.quarter_psi"];
  return book.show("psi_bounds", "eq:NA-approx", "psi is about 2 sqrt(2 alpha):",
                   both({linear(le(2 * p * (1 - rational(5, 12) * alpha), psi()),
                                {quarter, part(bounds, 0), q_above,
                                 times(q_positive, q_squared_below), times(mass, q_below)}),
                         linear(lt(psi(), 2 * p), {quarter, part(bounds, 1), q_below})}));
}

void counts(Book& book, const Theorem& bounds) {
  const Theorem mass = assume(alpha_positive);
  const Theorem psi_positive = part(book["rotation.psi_range"], 0);
  const Theorem p_positive = positive(p, {mass});
  const Expr share = 1 - rational(5, 12) * alpha;
  const Theorem small = assume(lt(alpha, rational(12, 5)));
  const Theorem share_positive = linear(lt(0, share), {small});
  know(share_positive);
  const Expr fewest = pi() / (2 * p), most = pi() / (2 * p * share);
  const auto quotients = [&](Expr l, Expr r, const Theorems& divisors, const Theorem& difference) {
    Certificate c;
    c.multipliers = divisors;
    c.nonzero = divisors;
    c.products = {{rational(1, 2).value(), {positive(pi()), difference}, {}}};
    return arithmetic(le(l, r), c);
  };
  const Theorem at_least =
      quotients(fewest, pi() / psi(), {psi_positive, p_positive}, part(bounds, 1));
  const Theorem at_most =
      quotients(pi() / psi(), most, {psi_positive, p_positive, share_positive}, part(bounds, 0));
  for (const auto& [name, count, shift, below] :
       {std::tuple{"N_A", N_A(), rational(1, 2), most + rational(1, 2)},
        std::tuple{"N_B", N_B(), Expr(1), most}}) {
    const Theorem number = book["counting." + std::string(name)];
    const Theorem rounded = use("ceiling", {{x, pi() / psi() - shift}});
    book.show(name, "eq:NA-approx",
              std::string(name) == "N_A" ? "So A has about pi/(2 sqrt(2 alpha)) collisions,"
                                         : "and so has B:",
              both({linear(le(fewest - shift, count), {at_least, number, part(rounded, 0)}),
                    linear(lt(count, below), {at_most, number, part(rounded, 1)})}));
  }
}
}  // namespace

void small_alpha(Book& book) {
  book.chapter("small_alpha", "Small mass ratios", {alpha_positive, V_positive});
  theta_bounds(book);
  const Expr third = pi() / 3;
  const Theorem from = positive(third);
  const Theorem below = linear(lt(third, pi() / 2), {positive(pi())});
  const Theorem reached = cut(from, cut(below, instantiate(book["ratios.reached"], {{x, third}})));
  const Theorem first =
      use(discharge(le(1, k), book["ratios.alpha_k"]), {{k, 1}}, {linear(le(1, 1), {})});
  const Theorem is_1 = linear(eq(first.conclusion().arg(1), 1), {first, book["ratios.alpha_1"]});
  const Theorem angle = assume(le(third, psi() / 2));
  const Expr ratio = reached.conclusion().arg(0).arg(0);
  const Theorem heavy = tautology(le(ratio, alpha), {reached, angle});
  const Theorem less =
      otherwise(lt(psi() / 2, third), linear(lt(0, 0), {heavy, assume(light), is_1}));
  book.show("psi_light", "",
            "The range of psi for such a ball:", linear(lt(psi(), 2 * pi() / 3), {less}));
  counts(book, psi_bounds(book));
}
}  // namespace derivation
