// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/certified.hpp"

#include "magicmass/errors.hpp"
#include "magicmass/reference/decimal.hpp"

namespace magicmass::command {

std::string certified_decimal(const reference::Enclosure& value, int digits,
                              long starting_precision) {
  for (long precision = starting_precision; precision <= 64 * starting_precision; precision *= 2) {
    const reference::Interval interval = value(precision);
    if (interval.sign() == reference::Sign::open) continue;
    std::string low = reference::to_decimal(interval.low(), digits);
    if (low == reference::to_decimal(interval.high(), digits)) return low;
  }
  throw Undecided("the digits asked for could not be told apart with " +
                  std::to_string(64 * starting_precision) + " bits");
}

}  // namespace magicmass::command
