// SPDX-License-Identifier: MIT
// What the generated evaluators put out, as results. Always inlined: each target has its own.
#pragma once

#include "magicmass/evaluators/angle.hpp"
#include "magicmass/evaluators/collapse.hpp"
#include "magicmass/evaluators/collision.hpp"
#include "magicmass/evaluators/counts.hpp"
#include "magicmass/evaluators/deficient.hpp"
#include "magicmass/evaluators/magic.hpp"
#include "magicmass/evaluators/restitution.hpp"
#include "magicmass/evaluators/terminal.hpp"
#include "magicmass/evaluators/velocities.hpp"
#include "magicmass/numbers/values.hpp"

namespace magicmass::numbers {
inline namespace MAGICMASS_TARGET {
[[gnu::always_inline]] inline void set(Velocities& to, const generated::VelocitiesOutputs& v) {
  to = {v.a, v.b, v.c, v.c_prime};
}
[[gnu::always_inline]] inline void set(Terminal& to, const generated::TerminalOutputs& v) {
  to = {{v.N_A, v.N_B}, v.a_t, v.b_t, v.c_t, v.rho};
}
[[gnu::always_inline]] inline void set(Terminal& to, const generated::RestitutionOutputs& v) {
  to = {{v.N_e - v.N_e / 2, v.N_e / 2}, v.a_end, v.b_end, v.c_end, v.rho_end};
}
[[gnu::always_inline]] inline void set(Collapse& to, const generated::CollapseOutputs& v) {
  to = {v.t_end, v.v_any, v.rho_any};
}
/// Counts alone, or a collision.
[[gnu::always_inline]] inline void set(auto& to, const auto& both) {
  const auto& [first, second] = both;
  to = {first, second};
}
/// Of an angle or a ratio.
[[gnu::always_inline]] inline void set(double& to, const auto& only) {
  const auto& [value] = only;
  to = value;
}
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::numbers
