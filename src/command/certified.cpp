// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/certified.hpp"

#include "magicmass/errors.hpp"
#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {

namespace {

/// Both ends rounded alike.
template <class Round>
auto certain(const reference::Enclosure& value, long starting_precision, Round round) {
  for (long precision = starting_precision; precision <= 64 * starting_precision; precision *= 2) {
    const reference::Interval interval = value(precision);
    if (interval.sign() == reference::Sign::open) continue;
    auto low = round(interval.low());
    if (low == round(interval.high())) return low;
  }
  throw Undecided("the digits asked for could not be told apart with " +
                  std::to_string(64 * starting_precision) + " bits");
}

}  // namespace

std::string certified_decimal(const reference::Enclosure& value, int digits,
                              long starting_precision) {
  return certain(value, starting_precision,
                 [digits](const cln::cl_RA& x) { return reference::to_decimal(x, digits); });
}

double certified_double(const reference::Enclosure& value, long starting_precision) {
  return certain(value, starting_precision,
                 [](const cln::cl_RA& x) { return reference::nearest<double>(x); });
}

}  // namespace magicmass::command
