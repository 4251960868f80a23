// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>

namespace GiNaC {
class ex;
}

// What many chapters write.
namespace magicmass::derivation {

extern const GiNaC::ex one_half;  ///< 1/2; not for initialising other constants at start

/// The indices of a claim, and the first value of each.
using Indices = std::map<std::string, long>;
inline const Indices from_zero{{"n", 0}}, from_one{{"n", 1}}, from_two{{"n", 2}},
    j_from_zero{{"j", 0}}, k_from_zero{{"k", 0}}, k_from_one{{"k", 1}},
    last_collisions{{"N_A", 1}, {"N_B", 1}};

}  // namespace magicmass::derivation
