// SPDX-License-Identifier: MIT
// What the numeric functions throw.
#pragma once

#include <stdexcept>

namespace magicmass {
/// The caller's fault: an alpha that is no positive finite double, n, j, k, e or a mass out of
/// range, columns of different sizes or in the same place.
struct InvalidInput : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};
/// The answer exists, but the last precision did not settle it: never seen. Or it is one of those
/// that fast::terminal with restitution and accurate::collapse leave out.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// This thread does not round to nearest, or flushes subnormal numbers to zero (a program linked
/// with -Ofast does): array calls refuse, and single ones in debug builds of the library, since
/// results would be wrong in silence.
struct NotIeee : std::runtime_error {
  using std::runtime_error::runtime_error;
};
}  // namespace magicmass
