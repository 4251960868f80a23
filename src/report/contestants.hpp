// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/contestant.hpp"

namespace magicmass::report {

/// All that this library knows for a quantity, the naive ones first. Lists of others are put behind it.
std::vector<Contestant> contestants(const std::string& quantity);

/// The parts it is made of; each gives nothing for a quantity that it does not know.
/// The paper's formulas as they stand: float, double, long double, double with long double angles, and velocities with a
/// call for each.
std::vector<Contestant> naive_contestants(const std::string& quantity);
/// Every row of the generated tables in float, double and long double.
std::vector<Contestant> generated_contestants(const std::string& quantity);
/// The certified count.
std::vector<Contestant> certified_contestants(const std::string& quantity);
/// The tiers fast and accurate, one input a call.
std::vector<Contestant> tier_contestants(const std::string& quantity);
/// The tiers and the exact counts on whole arrays: with the best instruction set of this machine under a name that is the same
/// everywhere (batch_fast), with the others of this machine under theirs (batch_fast_baseline). The same bits with each.
std::vector<Contestant> batch_contestants(const std::string& quantity);
/// What computes many in a row: the stream of velocities, with a copy loop of as many bytes beside it, and the tiers' ranges of
/// ratios.
std::vector<Contestant> sequence_contestants(const std::string& quantity);
/// The event simulator up to the collision that is asked for; only where that is within 4096 collisions.
std::vector<Contestant> stepping_contestants(const std::string& quantity);
/// The generated exact forms in CLN's rationals, where they stay short, rounded once at the end.
std::vector<Contestant> rational_contestants(const std::string& quantity);
/// The paper's formulas in CLN's floats of 50 decimal digits, rounded once at the end.
std::vector<Contestant> digits_contestants(const std::string& quantity);
/// The paper's formulas, four at a time through the vector functions of glibc and of SLEEF; none where the machine, the C
/// library or this build has no such functions.
std::vector<Contestant> vector_contestants(const std::string& quantity);
/// Was this built with SLEEF?
bool has_sleef();

}  // namespace magicmass::report
