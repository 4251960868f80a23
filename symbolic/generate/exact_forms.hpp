// SPDX-License-Identifier: GPL-2.0-or-later
// Velocities as rational functions of alpha, by cosines whose index is doubled.
#pragma once
#include "codegen/doubling.hpp"
#include "generate/source.hpp"

namespace generate {
struct ExactForms {
  codegen::Doubling cosines;    ///< T_m = cos(m psi/2)
  kernel::Theorem earlier;      ///< what b_(n-1) is, by a name of its own
  kernel::Theorems velocities;  ///< a, b, c, c' for n from 1
  kernel::Theorems at_start;    ///< for n = 0
  kernel::Theorems terminal;    ///< a_t, b_t, c_t, rho by the counts
};
/// Once a process: it defines names.
ExactForms exact_forms(Source& source);
}  // namespace generate
