// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "proof/definitions.hpp"
#include "proof/domain.hpp"

namespace magicmass::proof {

// The second net under every proof: both sides at random points of the domain, to 50 digits in CLN.
// Sequence elements such as a(n - 1) take independent random values: an identity must hold for all.
// Deterministic: the points depend on `seed` alone.
//
// Returns a point where the sides differ, with both values, as text; nothing when they agree at all of
// `points` points. Entries of matrices are compared one by one.
inline constexpr int sampled_points = 4;
std::optional<std::string> counterexample(const GiNaC::ex& lhs, const GiNaC::ex& rhs,
                                          const Domain& domain, const Definitions& definitions,
                                          const std::string& seed, int points = sampled_points);

// The second net for expansions: (function - terms)/s^last must vanish as s -> 0, so it is looked at for
// two small s. Returns what was seen if it does not.
std::optional<std::string> not_small(const GiNaC::ex& function, const GiNaC::ex& terms,
                                     const GiNaC::ex& s, int last);

}  // namespace magicmass::proof
