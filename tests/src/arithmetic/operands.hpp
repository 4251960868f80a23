// SPDX-License-Identifier: GPL-2.0-or-later
// Operands of the numbers of src/magicmass/arithmetic: hard ones, with what they stand for.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cln/integer.h>
#include <cln/rational.h>

#include "arithmetic/every_width.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::testing {

inline void append(Columns& columns, std::initializer_list<double> row) {
  columns.resize(row.size());
  std::size_t k = 0;
  for (const double x : row) columns[k++].push_back(x);
}

struct TwoPairs {
  double x, x_low, y, y_low;
};

/// Two pairs of high parts 2^low to 2^high: alike, far apart, nearly opposite, nearly equal.
inline TwoPairs two_pairs(Generator& generator, int low, int high) {
  TwoPairs two{};
  two.x = any_double(generator, low, high);
  two.x_low = any_low(generator, two.x);
  two.y = any_double(generator, low, high);
  const auto kind = whole(generator, 0, 7);
  if (kind == 0) two.y = -two.x;
  if (kind == 1) two.y = std::nextafter(-two.x, 0.0);
  if (kind == 2) two.y = two.x * (1 + any_double(generator, -40, -2));
  if (kind == 3) two.y = -two.x * (1 + any_double(generator, -40, -2));
  if (kind == 4) two.y = std::ldexp(two.x, -50);
  if (std::ilogb(two.y) > high || std::ilogb(two.y) < low) two.y = two.x;
  two.y_low = kind == 0 && whole(generator, 0, 1) == 0 ? -two.x_low : any_low(generator, two.y);
  return two;
}

/// -1, 0, 1 or a number in between: where in its enclosure a true number is.
inline cln::cl_RA place(Generator& generator) {
  const auto kind = whole(generator, 0, 3);
  if (kind < 3) return cln::cl_I(static_cast<long>(kind - 1));
  return cln::cl_RA(static_cast<long>(whole(generator, -1000, 1000))) / 1000;
}

}  // namespace magicmass::testing
