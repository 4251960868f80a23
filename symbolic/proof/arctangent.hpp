// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <utility>

namespace GiNaC {
class ex;
class numeric;
}  // namespace GiNaC

namespace magicmass::proof {

// (q, t) for q atan(t) with a rational q; nothing for any other expression.
std::optional<std::pair<GiNaC::numeric, GiNaC::ex>> multiple_of_arctangent(const GiNaC::ex& e);

}  // namespace magicmass::proof
