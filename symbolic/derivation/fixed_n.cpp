// SPDX-License-Identifier: GPL-2.0-or-later
// The first two cycles: velocities as factored rational functions of alpha.
#include <utility>

#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

constexpr int last_cycle = 2;

ex numbered(const std::string& letter, int k) { return symbol(letter + "_" + std::to_string(k)); }

// N(alpha)/(1 + alpha)^m with N factored: each factor of degree d takes d of the divisors, so that nothing
// overflows, as a polynomial in mu = 1/(1 + alpha); 1 - alpha takes its one as p_1.
ex factored(const ex& fraction) {
  const ex alpha = symbol("alpha"), mu = symbol("mu");
  const ex above = GiNaC::factor(fraction.numer().expand()), below = fraction.denom().expand();
  int divisors = below.degree(alpha);
  ex product = (pow(1 + alpha, divisors) / below).normal();
  const auto take = [&](const ex& factor) {
    const int sign = factor.subs(alpha == 0).info(GiNaC::info_flags::negative) ? -1 : 1;
    const ex part = (sign * factor).expand();
    const int degree = part.degree(alpha);
    ex form = 0;
    for (int i = 0; i <= degree; ++i)  // alpha mu = 1 - mu
      form += part.coeff(alpha, i) * pow(1 - mu, i) * pow(mu, degree - i);
    product *= sign * (part.is_equal(1 - alpha) ? numbered("p", 1) : form.expand());
    divisors -= degree;
  };
  if (GiNaC::is_a<GiNaC::mul>(above))
    for (const ex& part : above) take(part);
  else
    take(above);
  return product * pow(mu, divisors);
}

// From alpha = 1 on each block is hit once: psi >= 2 pi/3.
void heavy_ball(Kernel& kernel, const Counting& counting, const Terminal& terminal,
                const std::vector<Theorem>& velocities) {
  const ex alpha = symbol("alpha"), psi = symbol("psi");
  const ex N_A = symbol("N_A"), N_B = symbol("N_B");
  const Theorem heavy = kernel.hypothesis({.id = "fixed_n.heavy_ball",
                                           .statement = {1, Relation::less_equal, alpha},
                                           .words = "a ball that is no lighter than a block"});
  const Theorem large = kernel.larger_angle({.id = "fixed_n.large_angle",
                                             .statement = {2 * Pi / 3, Relation::less_equal, psi},
                                             .words = "then psi is a third of a turn or more"},
                                            heavy);
  const auto bound = [&](const char* id, const Statement& statement, const char* words,
                         const std::vector<Kernel::NonnegativeTerm>& terms) {
    return kernel.ordering(
        {.id = std::string("fixed_n.") + id, .statement = statement, .words = words}, terms);
  };
  const Theorem A_reached =
      bound("A_reached", {Pi, Relation::less_equal, 3 * psi / 2},
            "one cycle and a half turn by pi or more", {{3 * one_half, {large}, 1}});
  const Theorem B_reached =
      bound("B_reached", {Pi, Relation::less_equal, 2 * psi}, "and so do two cycles",
            {{3 * one_half, {large}, 1}, {one_half * psi, {}, 1}});
  const Theorem A_not_before =
      bound("A_not_before", {Pi, Relation::greater, psi / 2}, "half a cycle does not",
            {{1, {terminal.psi_below_pi}, 1}, {one_half * psi, {}, 1}});
  const auto once = [&](const char* id, const ex& number, const Theorem& count,
                        const Theorem& reached, const Theorem& not_before) {
    return kernel.ceiling_value({.id = std::string("fixed_n.") + id,
                                 .statement = {number, 1},
                                 .words = "it is hit once",
                                 .indices = {{"N_A", 1}, {"N_B", 1}}},
                                count, reached, not_before);
  };
  const Theorem A_once = once("N_A", N_A, counting.N_A, A_reached, A_not_before);
  const Theorem B_once = once("N_B", N_B, counting.N_B, B_reached, terminal.psi_below_pi);

  const ex elements[] = {a(N_A), b(N_B), c_prime(N_B)};
  const char* const names[] = {"a_t", "b_t", "c_t"};
  for (std::size_t i = 0; i < velocities.size(); ++i)
    kernel.rewriting({.id = std::string("fixed_n.") + names[i],
                      .statement = {elements[i], velocities[i].rhs()},
                      .words = "the velocities after the only collision with each",
                      .indices = {{"N_A", 1}, {"N_B", 1}}},
                     {A_once, B_once, velocities[i]});
}

// cos((2 k + 1) h/2)/cos(h/2) and sin(k h)/sin h with h = psi/2 obey f(k + 1) = 2 cos(h) f(k) - f(k - 1). That
// p_k and q_k are these ratios is only where they are looked for: what is proved is the velocities.
void name_factors(Kernel& kernel) {
  const ex alpha = symbol("alpha"), mu = symbol("mu");
  const auto named = [&](const ex& name, const ex& meaning, const char* words) {
    kernel.definition(
        {.id = "fixed_n." + to_text(name), .statement = {name, meaning}, .words = words});
  };
  named(mu, 1 / (1 + alpha), "a block's share of the mass in a contact");
  named(symbol("nu"), alpha * mu, "the ball's share");
  const auto next = [&](const ex& now, const ex& before) {
    return (2 / (1 + alpha) * now - before).normal();
  };
  ex p = 1, p_before = 1, q = 1, q_before = 0;
  for (int k = 1; k <= last_cycle; ++k) {
    p_before = std::exchange(p, next(p, p_before));
    q_before = std::exchange(q, next(q, q_before));
    // 1 - alpha is exact or rounded once: no zero of it is lost.
    named(numbered("p", k), k == 1 ? (1 - alpha) * mu : factored(p), "a factor of a and of c'");
    named(numbered("q", k + 1), factored(q), "a factor of b and of both of C's");
  }
}

}  // namespace

void fixed_n(Kernel& kernel, const Power& power, const Counting& counting, const Terminal& terminal,
             const Tangent& tangent) {
  name_factors(kernel);
  const ex V = symbol("V"), mu = symbol("mu"), nu = symbol("nu");
  for (int k = 1; k <= last_cycle; ++k) {
    const ex p = numbered("p", k), p_before = k == 1 ? ex(1) : numbered("p", k - 1);
    const ex q = k == 1 ? ex(1) : numbered("q", k), q_after = numbered("q", k + 1);
    const auto velocity = [&](const std::string& name, const ex& element, const ex& form,
                              const Theorem& closed) {
      return kernel.rewriting({.id = "fixed_n." + name + "_" + std::to_string(k),
                               .statement = {element, form},
                               .words = "a rational function of alpha, in factors"},
                              {closed});
    };
    const Theorem a_k = velocity("a", a(k), V * p * p_before, power.a);
    const Theorem b_k = velocity("b", b(k), 2 * V * nu * q * q_after, power.b);
    velocity("c", c(k), 2 * V * mu * q * p_before, tangent.c);
    const Theorem c_prime_k = velocity("c_prime", c_prime(k), -2 * V * mu * q * p, tangent.c_prime);
    if (k == 1) heavy_ball(kernel, counting, terminal, {a_k, b_k, c_prime_k});
  }
}

}  // namespace magicmass::derivation
