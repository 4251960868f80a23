// SPDX-License-Identifier: GPL-2.0-or-later
// The fraction of the energy that reaches B, with restitution e between equal blocks: one formula for both ways to
// end, with e only in its root and nothing subtracted but alpha_c from alpha.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "derivation/wedge.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::Pi;

void transmission(Kernel& kernel, const EqualBlocks& equal, const Collapse& collapse) {
  const ex e = symbol("e"), k = symbol("k"), alpha = symbol("alpha"), V = symbol("V");
  const ex h = symbol("h_e"), alpha_c = symbol("alpha_c"), V_CM = symbol("V_CM");
  const ex q = symbol("root_e"), root = symbol("root_h"), tangent = symbol("tan_half_h");
  const ex N = symbol("N"), is_odd = symbol("is_odd"), is_even = symbol("is_even"),
           rest = symbol("rest_e"), decay = symbol("decay");
  const std::vector<Statement> ending{
      {alpha, Relation::greater, alpha_c},
      {4 * e * pow(1 + alpha, 2), Relation::greater, pow(1 + e, 2)}};
  const auto named = [&](const ex& name, const ex& meaning, const char* words,
                         const Indices& indices = {}) {
    return kernel.definition({.id = "transmission." + to_text(name),
                              .statement = {name, meaning},
                              .words = words,
                              .indices = indices,
                              .assuming = ending});
  };
  const Theorem by_root = named(q, sqrt(e), "the restitution by its root");
  const Theorem threshold = kernel.rewriting({.id = "transmission.alpha_c",
                                              .statement = {alpha_c, pow(1 - q, 2) / (2 * q)},
                                              .words = "e in its root alone",
                                              .assuming = ending},
                                             {collapse.alpha_c, by_root});
  const Theorem by_name =
      named(root, 1 / sqrt((alpha - alpha_c) * (2 + alpha + alpha_c)), "one root, by name");
  const Theorem half = named(tangent, (alpha - alpha_c) * root, "the tangent of half of h");
  kernel.equal_angles({.id = "transmission.h",
                       .statement = {h, 2 * atan(tangent)},
                       .words = "h from the tangent of its half",
                       .assuming = ending});
  const Theorem rest_of_pi =
      named(rest, Pi - N * h, "what the turn by N h leaves of pi", {{"N", 0}});

  struct Last {
    const char* name;  // of the collision
    ex collisions, is_odd, decay;
  };
  for (const Last& last :
       {Last{"Q", 2 * k, 0, pow(e, k)}, Last{"P", 2 * k + 1, 1, pow(e, k) * sqrt(e)}}) {
    const std::string id = "transmission.";
    const auto assumed = [&](const ex& name, const ex& meaning, const char* words) {
      return kernel.hypothesis({.id = id + to_text(name) + "_after_" + last.name,
                                .statement = {name, meaning},
                                .words = words,
                                .indices = {{"k", 0}}});
    };
    const Theorem number = assumed(N, last.collisions, "collisions of all");
    const Theorem odd = assumed(is_odd, last.is_odd, "1 if that is odd");
    const Theorem even = assumed(is_even, 1 - last.is_odd, "1 if that is even");
    const Theorem decayed = assumed(decay, last.decay, "the root of e to the power N");
    const ex heavy = is_even * q * sin(rest) + is_odd * sin(h - rest);
    const ex form =
        V_CM * (1 + decay * (1 + alpha) * root * (q * sin(rest) + sin(h - rest) + alpha * heavy));
    const Theorem of_B =
        kernel.rewriting({.id = id + "b_after_" + last.name,
                          .statement = {equal.b.lhs().subs(symbol("n") == k), form},
                          .words = "one form for both endings",
                          .indices = {{"k", 0}, {"N", 0}},
                          .assuming = ending},
                         {equal.b, rest_of_pi, number, odd, even, decayed, by_root, by_name});
    kernel.consequence({.id = id + "rho_after_" + last.name,
                        .statement = {pow(of_B.lhs() / V, 2), pow(of_B.rhs() / V, 2)},
                        .words = "the fraction rho of the energy that reaches B",
                        .indices = {{"k", 0}, {"N", 0}},
                        .assuming = ending},
                       {{of_B, (of_B.lhs() + of_B.rhs()) / pow(V, 2)}});
  }
}

}  // namespace magicmass::derivation
