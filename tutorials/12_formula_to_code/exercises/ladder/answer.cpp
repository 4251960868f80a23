// SPDX-License-Identifier: GPL-2.0-or-later
// cos(m psi/2) for cos(psi/2) = x, with multiplications and additions alone.
double ladder(double x, long m) {
  return x;  // change this
}
