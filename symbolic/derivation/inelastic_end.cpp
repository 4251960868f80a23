// SPDX-License-Identifier: GPL-2.0-or-later
// Equal blocks with restitution: velocities after the last collision, and the time of a collapse, both written
// without a difference of nearly equal numbers other than alpha - alpha_c.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "derivation/wedge.hpp"
#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::Pi;

namespace {

// The last collision of all is Q_k or P_(k + 1): after N = 2 k or 2 k + 1 of them the unfolded motion has turned
// by N h and has at most one h left to pi. That rest, and h less the rest, give positive multiples.
void after_last(Kernel& kernel, const EqualBlocks& equal, const Statement& ending) {
  const ex n = symbol("n"), k = symbol("k"), e = symbol("e"), alpha = symbol("alpha"),
           V = symbol("V"), V_CM = symbol("V_CM"), h = symbol("h_e");
  const std::vector<Statement> assuming{ending};
  struct Last {
    std::string name;  // of the collision
    ex collisions;     // N
    ex of_A;           // the index of A's last collision
    const Theorem& ball;
  };
  for (const Last& last :
       {Last{"Q", 2 * k, k, equal.c_prime}, Last{"P", 2 * k + 1, k + 1, equal.c}}) {
    const bool is_Q = last.name == "Q";
    const std::string id = "inelastic_end.after_" + last.name;
    const ex rest = symbol("delta_" + last.name);
    const Theorem left = kernel.definition({.id = id + "_rest",
                                            .statement = {rest, Pi - last.collisions * h},
                                            .words = "what the turn by N h leaves of pi",
                                            .indices = k_from_zero,
                                            .assuming = assuming});
    // e^(N/2) sin((N + 1) h) and e^((N + 1)/2) sin(N h), both over sin h, up to a sign.
    const ex odd = pow(e, k) * sqrt(e);
    const ex away = (is_Q ? ex(pow(e, k)) : odd) * sin(h - rest) / sin(h);
    const ex back = (is_Q ? odd : ex(pow(e, k + 1))) * sin(rest) / sin(h);
    const auto velocity = [&](const std::string& name, const Theorem& general, const ex& index,
                              const ex& form) {
      return kernel.rewriting({.id = id + "_" + name,
                               .statement = {general.lhs().subs(n == index), V_CM * form},
                               .words = "if " + last.name + " is the last collision of all",
                               .indices = k_from_zero,
                               .assuming = assuming},
                              {general, left});
    };
    const ex heavy = 1 + alpha;
    velocity("a_t", equal.a, last.of_A, is_Q ? 1 - heavy * away - back : 1 - away - heavy * back);
    const Theorem of_B =
        velocity("b_t", equal.b, k, is_Q ? 1 + heavy * back + away : 1 + heavy * away + back);
    velocity("c_t", last.ball, last.of_A, is_Q ? 1 + away - back : 1 - away + back);
    kernel.consequence({.id = id + "_rho",
                        .statement = {pow(of_B.lhs() / V, 2), pow(of_B.rhs() / V, 2)},
                        .words = "the fraction rho of the energy that reaches B",
                        .indices = k_from_zero,
                        .assuming = assuming},
                       {{of_B, (of_B.lhs() + of_B.rhs()) / pow(V, 2)}});
  }
}

// P_1 and Q_1 alone: rational functions, right also where h is so near pi/2 that pi - 2 h would lose its digits.
void two_collisions(Kernel& kernel, const EqualBlocks& equal, const Statement& ending) {
  const ex n = symbol("n"), e = symbol("e"), alpha = symbol("alpha"), V = symbol("V");
  const auto velocity = [&](const std::string& name, const Theorem& general, const ex& form) {
    return kernel.instance({.id = "inelastic_end.two_" + name,
                            .statement = {general.lhs().subs(n == 1), V * form},
                            .words = "after P_1 and Q_1",
                            .assuming = {ending}},
                           general, {{n, ex(1)}});
  };
  const ex to_ball = (1 + e) / (1 + alpha);
  velocity("a_t", equal.a, (1 - e * alpha) / (1 + alpha));
  velocity("c_t", equal.c_prime, to_ball * (alpha - e) / (1 + alpha));
  const Theorem of_B = velocity("b_t", equal.b, alpha * pow(to_ball, 2));
  kernel.rewriting({.id = "inelastic_end.two_rho",
                    .statement = {pow(of_B.lhs() / V, 2), pow(of_B.rhs() / V, 2)},
                    .words = "the fraction rho of the energy that reaches B",
                    .assuming = {ending}},
                   {of_B});
}

}  // namespace

void inelastic_end(Kernel& kernel, const EqualBlocks& equal, const Collapse& collapse) {
  const ex e = symbol("e"), alpha = symbol("alpha"), L = symbol("L"), V = symbol("V");
  const ex alpha_c = collapse.alpha_c.lhs(), root = sqrt(e);
  const Statement ending{4 * e * pow(1 + alpha, 2), Relation::greater, pow(1 + e, 2)};
  kernel.identity({.id = "inelastic_end.alpha_c",
                   .statement = {alpha_c, pow(1 - root, 2) / (2 * root)},
                   .words = "the heaviest ball with a collapse: no digit lost as e grows to 1"});
  kernel.equal_angles(
      {.id = "inelastic_end.h",
       .statement = {equal.h.lhs(), 2 * atan(sqrt((alpha - alpha_c) / (2 + alpha + alpha_c)))},
       .words = "the angle of the wedge from half of it",
       .assuming = {{alpha, Relation::greater, alpha_c}, ending}});
  after_last(kernel, equal, ending);
  two_collisions(kernel, equal, ending);

  // The collapse, at the share of equal blocks and their xi = exp(eta).
  const ex above = sqrt((alpha_c - alpha) * (2 + alpha + alpha_c));  // (1 + alpha) sinh(eta)
  const Theorem share = kernel.hypothesis({.id = "inelastic_end.share_of_A",
                                           .statement = {symbol("mu_A"), 1 / (1 + alpha)},
                                           .words = "the share of a block"});
  const Theorem growth =
      kernel.hypothesis({.id = "inelastic_end.xi",
                         .statement = {symbol("xi"), (1 + alpha_c + above) / (1 + alpha)},
                         .words = "exp(eta) for equal blocks"});
  const std::vector<Statement> beyond{
      {pow(1 + e, 2), Relation::greater, 4 * e * pow(1 + alpha, 2)}};
  kernel.rewriting({.id = "inelastic_end.share_of_B",
                    .statement = {collapse.share_of_B, share.rhs()},
                    .words = "so B is such a block too",
                    .assuming = beyond},
                   {growth, share});
  kernel.rewriting(
      {.id = "inelastic_end.t_infinity",
       .statement = {collapse.t_infinity.lhs(), L / V * (1 + alpha) / ((1 + e) / 2 + root * above)},
       .words = "when infinitely many collisions have happened",
       .indices = {{"n", 1}},
       .assuming = beyond},
      {collapse.t_infinity, growth, share});
}

}  // namespace magicmass::derivation
