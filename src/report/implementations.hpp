// SPDX-License-Identifier: GPL-2.0-or-later
// The ways to get the numbers, all called alike: columns of inputs in, columns of results out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "report/families.hpp"

namespace report {

struct Columns {
  explicit Columns(std::span<const Input> inputs);
  std::size_t size() const { return alpha.size(); }

  std::vector<double> alpha;
  std::vector<std::int64_t> index;
  std::array<std::vector<double>, 4> values;        ///< in the order of Quantity's words
  std::array<std::vector<std::int64_t>, 2> counts;  ///< N_A, N_B
};

struct Implementation {
  std::string name;
  Quantity quantity;
  /// Fills the results. Throws std::domain_error for an input that this way does not take.
  std::function<void(Columns&)> run;
  std::size_t most_timed = 500;  ///< rows of a pass that is timed: fewer where it is slow
};
/// The naive one of a quantity before its others.
const std::vector<Implementation>& implementations();

}  // namespace report
