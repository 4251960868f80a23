// SPDX-License-Identifier: GPL-2.0-or-later
// cos(m psi/2) for cos(psi/2) = x, with multiplications and additions alone.
double ladder(double x, long m) {
  double before = 1;
  double here = x;
  for (long i = 0; i < m; ++i) {
    const double next = 2 * x * here - before;
    before = here;
    here = next;
  }
  return before;
}
