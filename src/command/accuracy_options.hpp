// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace magicmass::command {

/// fast: tier fast at the nearest double. accurate: the double nearest to the value at alpha as it is written.
/// exact: p/q, or `digits` certified decimal digits.
struct Accuracy {
  std::string tier;           ///< "fast", "accurate" or "exact"
  std::optional<int> digits;  ///< with "exact"
};

/// --tier and --digits as they were given.
struct AccuracyOptions {
  std::optional<std::string> tier;
  std::optional<std::string> digits;
};

void add_accuracy_options(CLI::App& command, AccuracyOptions& options);

/// Without --tier: exact if --digits is given, else fast. Throws InvalidInput for an unknown tier.
Accuracy accuracy(const AccuracyOptions& options);

/// A number of decimal digits from 1 to 100000, which take seconds. Throws InvalidInput.
int parse_digits(const std::string& text);

}  // namespace magicmass::command
