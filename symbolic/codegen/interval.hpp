// SPDX-License-Identifier: GPL-2.0-or-later
// Closed intervals of doubles, rounded outwards: one step after each of + - * / sqrt, four after a
// function of libm (the bounds of GNU's, musl's and FreeBSD's are below one and a half).
#pragma once

namespace codegen {
struct Interval {
  double low, high;

  double size() const;   ///< the largest |x|
  double least() const;  ///< the smallest |x|
  bool is_point() const { return low == high; }
};
Interval meet(Interval x, Interval y);
Interval around(double low, double high, int steps = 1);
Interval operator+(Interval x, Interval y);
Interval operator*(Interval x, Interval y);
Interval operator/(Interval x, Interval y);  ///< Refused: y with 0 inside; 0 at its end: infinite
Interval root(Interval x);                   ///< Refused: a negative x
Interval reciprocal_root(Interval x);        ///< Refused: a negative x; of 0: infinite
Interval magnitude(Interval x);
Interval arc_tangent(Interval x);
Interval sine(Interval x);    ///< [-1, 1] where x is not within [-pi/2, pi]
Interval cosine(Interval x);  ///< [-1, 1] where x is not within [-pi, pi]
}  // namespace codegen
