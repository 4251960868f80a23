// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

// The k-th magic mass ratio, 1/cos(pi/(2k + 1)) - 1, within 4 ulp.
double magic_ratio(double k) {
  const double x = 3.14159265358979323846 / (2 * k + 1);
  const double s = std::sin(x / 2);
  return 2 * s * s / std::cos(x);
}
