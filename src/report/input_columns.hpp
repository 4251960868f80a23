// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "report/contestant.hpp"

namespace magicmass::report {

/// Inputs as what works on arrays takes them: plain vectors, aligned as they happen to be.
struct InputColumns {
  std::vector<double> alpha;
  std::vector<std::int64_t> index;

  explicit InputColumns(std::span<const Input> inputs) {
    for (const Input& input : inputs) {
      alpha.push_back(input.alpha);
      index.push_back(input.index);
    }
  }
};

}  // namespace magicmass::report
