// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "long_run/checks.hpp"

namespace magicmass::long_run {

struct Plan {
  std::int64_t inputs = 1'000'000;      ///< of each family
  std::int64_t everyday = 10'000'000;   ///< of the family "everyday"
  std::size_t oracle_every = 1000;      ///< how many inputs are as many as one for the oracle
  unsigned threads = 0;                 ///< 0: as many as there are
  std::optional<std::string> quantity;  ///< that one alone
};

/// One row of the table, and how its inputs are drawn.
struct Row {
  std::string quantity;
  std::string family;
  std::int64_t wanted;
  Tally tally = {};
};
std::vector<Row> rows(const Plan& plan);

/// The inputs of a row by the chunk, different ones in each; fewer than asked for where the family has no more. For
/// one thread at a time.
Inputs chunk(const Row& row, std::int64_t number);
inline constexpr std::int64_t chunk_size = 4096;

/// Fills in the tallies.
void run(const Plan& plan, std::vector<Row>& rows);

}  // namespace magicmass::long_run
