// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "magicmass/accurate.hpp"
#include "magicmass/fast.hpp"
#include "report/make_contestant.hpp"

namespace magicmass::testing {

/// The tiers fast and accurate, by the names under which their worst inputs are pinned.
inline std::vector<report::Contestant> contestants_of_tiers(const std::string& quantity) {
  using report::Input;
  const auto both = [&](auto of_fast, auto of_accurate) {
    std::vector<report::Contestant> all{
        report::make_contestant("fast", quantity, "tier fast", "double", of_fast),
        report::make_contestant("accurate", quantity, "tier accurate", "double", of_accurate)};
    all[1].ulp_bound = 0.5;
    return all;
  };
  if (quantity == "velocities")
    return both([](const Input& in) { return fast::velocities(in.alpha, in.index); },
                [](const Input& in) { return accurate::velocities(in.alpha, in.index); });
  if (quantity == "encounters")
    return both([](const Input& in) { return fast::encounters(in.alpha, in.index); },
                [](const Input& in) { return accurate::encounters(in.alpha, in.index); });
  if (quantity == "angle")
    return both([](const Input& in) { return fast::angle(in.alpha); },
                [](const Input& in) { return accurate::angle(in.alpha); });
  if (quantity == "ratios")
    return both([](const Input& in) { return fast::ratios(in.index); },
                [](const Input& in) { return accurate::ratios(in.index); });
  return {};
}

}  // namespace magicmass::testing
