// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 5, in part: cos(m psi/2) as a polynomial in cos(psi/2) = 1/(1 + alpha), so that rational mass
// ratios have rational velocities.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;

Chebyshev chebyshev(Kernel& kernel, const Rotation& rotation, const Power& power) {
  const ex n = symbol("n"), m = symbol("m"), alpha = symbol("alpha"), psi = symbol("psi"),
           V_CM = symbol("V_CM");
  const Indices m_from_zero{{"m", 0}};

  const Theorem definition =
      kernel.definition({.id = "chebyshev.T",
                         .statement = {T(m), cos(m * psi / 2)},
                         .words = "the m-th Chebyshev polynomial of cos(psi/2)",
                         .indices = m_from_zero});
  kernel.rewriting({.id = "chebyshev.T_0", .statement = {T(0), 1}, .words = "where it starts"},
                   {definition});
  kernel.rewriting({.id = "chebyshev.T_1",
                    .statement = {T(1), rotation.cos_half_psi.rhs()},
                    .words = "where it starts"},
                   {definition});
  kernel.rewriting({.id = "chebyshev.next",
                    .statement = {T(m + 2), 2 * T(1) * T(m + 1) - T(m)},
                    .words = "the recurrence: every T(m) is a polynomial in T(1)",
                    .indices = m_from_zero},
                   {definition});
  const Theorem even = kernel.rewriting({.id = "chebyshev.even",
                                         .statement = {T(2 * m), 2 * pow(T(m), 2) - 1},
                                         .words = "doubling",
                                         .indices = m_from_zero},
                                        {definition});
  const Theorem odd = kernel.rewriting({.id = "chebyshev.odd",
                                        .statement = {T(2 * m + 1), 2 * T(m) * T(m + 1) - T(1)},
                                        .words = "doubling and one more",
                                        .indices = m_from_zero},
                                       {definition});

  kernel.rewriting(
      {.id = "chebyshev.sine",
       .statement = {sin(m * psi / 2) * sin(psi / 2), T(1) * T(m) - T(m + 1)},
       .words = "a sine from two cosines: its sign decides counts without any square root",
       .indices = m_from_zero},
      {definition});

  // T(2 n - 1) is written by the recurrence, so that T(2 n) and T(2 n + 1) suffice for all four.
  const ex before = 2 * T(1) * T(2 * n) - T(2 * n + 1);
  const auto velocity = [&](const char* id, const ex& element, const ex& form,
                            const Theorem& closed, const Indices& indices) {
    return kernel.rewriting({.id = id,
                             .statement = {element, form},
                             .words = "as a polynomial in cos(psi/2)",
                             .indices = indices},
                            {closed, definition});
  };
  return {
      definition,
      even,
      odd,
      velocity("chebyshev.a", a(n), V_CM * (1 + (1 + alpha) * T(2 * n)), power.a, from_zero),
      velocity("chebyshev.b", b(n), V_CM * (1 - (1 + alpha) * T(2 * n + 1)), power.b, from_zero),
      velocity("chebyshev.c", c(n), V_CM * (1 + (1 + alpha) / alpha * (before - T(2 * n))), power.c,
               from_one),
      velocity("chebyshev.c_prime", c_prime(n),
               V_CM * (1 - (1 + alpha) / alpha * (T(2 * n) - T(2 * n + 1))), power.c_prime,
               from_zero)};
}

}  // namespace magicmass::derivation
