// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

// The k-th magic mass ratio, 1/cos(pi/(2k + 1)) - 1, within 4 ulp.
double magic_ratio(double k) {
  return 0;  // change this
}
