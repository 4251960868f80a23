// Between rationals and doubles, exactly; numbers as the generator prints them; closed intervals of
// doubles, rounded outwards: one step after each of + - * / sqrt, four after a function of libm
// (the bounds of GNU's, musl's and FreeBSD's are below one and a half).
#pragma once

#include <limits>

#include "kernel/expr.hpp"

namespace codegen {
using kernel::Refused;
constexpr double infinity = std::numeric_limits<double>::infinity();

cln::cl_RA exact(double x);           ///< Refused: NaN, infinity
double nearest(const cln::cl_RA& x);  ///< ties to even; |x| from 2^-960 to 2^1000, or 0
double upper(const cln::cl_RA& x);    ///< a double that is at least x
bool is_double(const cln::cl_RA& x);
bool is_power_of_2(double x);  ///< or minus one
/// pi, off by less than 2^-400.
const cln::cl_RA& pi();

std::string hex(double x);
/// "2^-73.6", at least x.
std::string as_power_of_2(double x);
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
