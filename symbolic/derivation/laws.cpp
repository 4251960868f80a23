// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/laws.hpp"

#include <ginac/ginac.h>

#include "proof/names.hpp"

namespace magicmass::derivation {

Laws conservation_laws() {
  using namespace proof;
  using GiNaC::ex;
  const ex M_1 = symbol("M_1"), M_2 = symbol("M_2");
  const ex u_1 = symbol("u_1"), u_2 = symbol("u_2"), v_1 = symbol("v_1"), v_2 = symbol("v_2");
  const ex n = symbol("n");
  return {
      .momentum = {M_1 * u_1 + M_2 * u_2, M_1 * v_1 + M_2 * v_2},
      .energy = {M_1 * pow(u_1, 2) + M_2 * pow(u_2, 2), M_1 * pow(v_1, 2) + M_2 * pow(v_2, 2)},
      .contact = {v_1, Relation::not_equal, u_1},
      .restitution = {v_2 - v_1, symbol("e") * (u_1 - u_2)},
      .wall = {v_1, u_1},
      .a_initial = {a(0), symbol("V")},
      .b_initial = {b(0), 0},
      .c_initial = {c_prime(0), 0},
      .t_initial = {t_P(1), 0},
      .s_initial = {s_P(1), symbol("L")},
      .t_Q = {(c(n) - b(n - 1)) * (t_Q(n) - t_P(n)), s_P(n)},
      .s_Q = {s_Q(n) - s_P(n), (b(n - 1) - a(n)) * (t_Q(n) - t_P(n))},
      .t_P = {(a(n - 1) - c_prime(n - 1)) * (t_P(n) - t_Q(n - 1)), s_Q(n - 1)},
      .s_P = {s_P(n) - s_Q(n - 1), (b(n - 1) - a(n - 1)) * (t_P(n) - t_Q(n - 1))},
  };
}

}  // namespace magicmass::derivation
