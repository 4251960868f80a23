// SPDX-License-Identifier: GPL-2.0-or-later
// The data of figures that show bodies and directions.
#pragma once

#include "answers/table.hpp"

namespace answers {

/// A body a row: its place, its velocity before the first collision.
Table setup_data();
/// Places of A, C, B from collision to collision, one panel after the other.
Table trajectories_data();
/// V_n at alpha_5, then the circle on which they lie.
Table sphere_data();
/// Distance of A and B at each collision, and the direction of its ray in the unfolded wedge.
Table wedge_data();
/// Places of a block and of the ball between it and a wall, from collision to collision.
Table way_data();
/// Places of five blocks and four balls at magic ratios from collision to collision, there and
/// back.
Table cradle_data();

}  // namespace answers
