// SPDX-License-Identifier: GPL-2.0-or-later
// Each name is defined once, for the whole program.
#include "quantities.hpp"

#include <cmath>

namespace test {
namespace {
using namespace kernel;
using codegen::Case;
using codegen::Interval;
using codegen::Quantity;

const Expr alpha = real("alpha");
const Expr n = integer("n");
const Expr k = integer("k");
const Exprs of_alpha{alpha};
const Exprs of_both{alpha, n};
constexpr double below_1 = 0x1.fffffffffffffp-1;
constexpr double largest = 0x1.fffffffffffffp1023;
constexpr double smallest = 0x1p-1074;

Expr half() { return Expr(1) / Expr(2); }
/// |- name(params) = term, and the term name(params).
struct Named {
  Theorem theorem;
  Expr term() const { return theorem.conclusion().arg(0); }
};
Named define_as(const std::string& name, const Exprs& params, Expr term) {
  return {define(name, params, term)};
}

struct Angle {
  Named above = define_as("above", of_alpha, 2 + alpha);
  Named w = define_as("w", of_alpha, 1 / sqrt(alpha * above.term()));
  Named t = define_as("t", of_alpha, alpha* w.term());
  Named z = define_as("z", of_alpha, alpha / above.term());
  Named half_h = define_as("half_h", of_alpha, atan(t.term()));
  Theorems definitions() const {
    return {above.theorem, w.theorem, z.theorem, t.theorem, half_h.theorem};
  }
  std::vector<codegen::Fact> facts() const {
    return {{le(z.term(), Expr(1) / Expr(3)), "alpha <= 1"},
            {eq(power(t.term(), 2), z.term()), "t^2 = alpha^2/(alpha (2 + alpha))"}};
  }
};
const Angle& angle() {
  static const Angle a;
  return a;
}
Case small(const std::vector<Named>& definitions, const std::vector<Named>& outputs) {
  Case c{"small", {{"alpha", {smallest, below_1}}}, angle().definitions(), {}, angle().facts(), {}};
  for (const Named& d : definitions) c.definitions.push_back(d.theorem);
  for (const Named& o : outputs) c.outputs.push_back(o.theorem);
  return c;
}

Quantity velocities() {
  const Angle& A = angle();
  const Named x = define_as("x", of_both, 2 * A.half_h.term() * n);
  const Named S = define_as("S", of_both, sin(x.term()));
  const Named C = define_as("C", of_both, cos(x.term()));
  const Named tS = define_as("tS", of_both, A.t.term() * S.term());
  const Named wS = define_as("wS", of_both, A.w.term() * S.term());
  const Named P = define_as("P", of_both, C.term() + tS.term());
  const Named M = define_as("M", of_both, C.term() - tS.term());
  const Named Q = define_as("Q", of_both, C.term() + wS.term());
  const Named a = define_as("a", of_both, P.term() * M.term());
  const Named b = define_as("b", of_both, 2 * Q.term() * tS.term());
  const Named c = define_as("c", of_both, 2 * P.term() * wS.term());
  const Named c_prime = define_as("c'", of_both, -2 * M.term() * wS.term());
  Case main = small({x, S, C, tS, wS, P, M, Q}, {a, b, c, c_prime});
  main.facts.push_back({le(tS.term(), wS.term()), "t = alpha w <= w"});
  main.guards = {{"x", {-0.001, 2.0945}}};
  return {"velocities",
          "eq:a-final to eq:c'-final",
          {{alpha, {0x1p-300, 0x1p300}, {smallest, largest}}, {n, {0, 0x1p50}, {0, 0x1p63}}},
          {main}};
}

Quantity terminal() {
  const Angle& A = angle();
  const Named h = define_as("h", of_alpha, 2 * A.half_h.term());
  const Named N_A = define_as("N_A", of_alpha, ceil(pi() / (2 * h.term()) - half()));
  const Named N_B = define_as("N_B", of_alpha, ceil(pi() / (2 * h.term()) - 1));
  const Expr rest = pi() / 2 - h.term() * N_A.term();
  const Named r = define_as("r", of_alpha, sqrt(power(rest, 2)));
  const Named S = define_as("S_t", of_alpha, sin(r.term()));
  const Named C = define_as("C_t", of_alpha, cos(r.term()));
  const Named tC = define_as("tC", of_alpha, A.t.term() * C.term());
  const Named wC = define_as("wC", of_alpha, A.w.term() * C.term());
  const Named P = define_as("P_t", of_alpha, tC.term() + S.term());
  const Named M = define_as("M_t", of_alpha, tC.term() - S.term());
  const Named Q = define_as("Q_t", of_alpha, wC.term() + S.term());
  const Named B = define_as("B_t", of_alpha, 2 * Q.term() * tC.term());
  const Named a = define_as("a_t", of_alpha, -1 * M.term() * P.term());
  const Named b = define_as("b_t", of_alpha, B.term());
  const Named c = define_as("c_t", of_alpha, 2 * M.term() * wC.term());
  const Named rho = define_as("rho", of_alpha, power(B.term(), 2));
  Case main = small({h, N_A, N_B, r, S, C, tC, wC, P, M, Q, B}, {N_A, N_B, a, b, c, rho});
  const std::vector<codegen::Fact> more{
      {le(S.term(), tC.term()), "r <= h/2",
       "r < h/2 is tested of computed values, and S and C are of the computed r"},
      {le(tC.term(), wC.term()), "t = alpha w <= w"}};
  main.facts.insert(main.facts.end(), more.begin(), more.end());
  return {"terminal",
          "eq:NA-ans, eq:NB-ans, eq:a-terminal to eq:c-terminal",
          {{alpha, {0x1p-100, 0x1p300}, {smallest, largest}}},
          {main}};
}

Quantity ratio(const std::string& name, const std::string& suffix, Expr angle_of_k,
               double first_k) {
  const Exprs of_k{k};
  const Named y = define_as("y_" + suffix, of_k, angle_of_k);
  const Named S = define_as("S_" + suffix, of_k, sin(y.term()));
  const Named D2 = define_as("D2_" + suffix, of_k, 2 * power(S.term(), 2));
  const Named D = define_as("D_" + suffix, of_k, 1 - D2.term());
  const Named ratio = define_as(name, of_k, D2.term() / D.term());
  Case c{"general", {}, {y.theorem, S.theorem, D2.theorem, D.theorem}, {ratio.theorem}, {}, {}};
  return {name, "exact:ak, exact:bk", {{k, {first_k, 0x1p50}, {first_k, 0x1p63}}}, {c}};
}
Quantity of_angle() {
  const Named psi = define_as("psi", of_alpha, 4 * angle().half_h.term());
  return {"angle", "def:psi", {{alpha, {0x1p-300, 1}, {smallest, 1}}}, {small({}, {psi})}};
}
}  // namespace

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      velocities(), terminal(), ratio("magic", "magic", pi() / (2 * (1 + 2 * k)), 2),
      ratio("deficient", "deficient", pi() / (4 * (1 + k)), 1), of_angle()};
  return all;
}
}  // namespace test
