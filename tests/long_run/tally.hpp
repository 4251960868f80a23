// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace magicmass::long_run {

/// How the rounding of an input was decided.
enum class Stage { first, second, certified };

/// What a check of some inputs found.
struct Tally {
  std::int64_t inputs = 0;
  std::int64_t misrounded_single = 0;  ///< results of the functions for one input
  std::int64_t misrounded_batch = 0;   ///< of the batch, on every instruction set of this machine
  std::int64_t wrong_counts = 0;       ///< N_A or N_B, of either
  std::array<std::int64_t, 3> by_stage{};
  std::int64_t oracle_inputs = 0;  ///< compared with the independent oracle as well
  std::int64_t oracle_wrong = 0;

  bool is_clean() const {
    return misrounded_single == 0 && misrounded_batch == 0 && wrong_counts == 0 &&
           oracle_wrong == 0;
  }
  std::int64_t& decided_at(Stage stage) { return by_stage[static_cast<std::size_t>(stage)]; }

  Tally& operator+=(const Tally& more) {
    inputs += more.inputs;
    misrounded_single += more.misrounded_single;
    misrounded_batch += more.misrounded_batch;
    wrong_counts += more.wrong_counts;
    for (std::size_t i = 0; i < by_stage.size(); ++i) by_stage[i] += more.by_stage[i];
    oracle_inputs += more.oracle_inputs;
    oracle_wrong += more.oracle_wrong;
    return *this;
  }
};

/// How many pairs differ; NaN is like NaN alone.
template <class Value>
std::int64_t differences(std::initializer_list<std::pair<Value, Value>> pairs) {
  std::int64_t different = 0;
  for (const auto& [x, y] : pairs) different += x == y || (x != x && y != y) ? 0 : 1;
  return different;
}

}  // namespace magicmass::long_run
