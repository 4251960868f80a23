// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "report/contestant.hpp"
#include "report/exact_value.hpp"

namespace magicmass::report {

/// psi at a double alpha, from CLN's arctangent.
std::vector<ExactValue> exact_angle(const Input& input);

/// Time t_j and distance s_j of collision j: stepped in exact rationals up to j = 2, beyond that from CLN's
/// arctangent and sine, t_j = sin(j h)/sin((j+1) h), s_j = sin h/sin((j+1) h), h = psi/2.
/// exists is false beyond the last collision.
std::vector<ExactValue> exact_encounter(const Input& input);

}  // namespace magicmass::report
