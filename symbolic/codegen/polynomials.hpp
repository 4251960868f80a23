// SPDX-License-Identifier: GPL-2.0-or-later
// Polynomials from the functions' series, in exact rationals, each with a proof of its error:
// |p - f| <= the sum of the Chebyshev coefficients of p - (series), and the series' remainder.
#pragma once

#include <string>
#include <vector>

namespace codegen {
struct Polynomial {
  std::string name;          ///< arc_tangent, sine, cosine, small_sine, small_cosine
  std::vector<double> high;  ///< coefficients of (z - centre)^k, for z from 0 to top
  std::vector<double> low;   ///< what the first of them lack
  double centre;
  double top;
  double least;  ///< of the function there
  double error;  ///< proved, relative to the function
};
/// A set of polynomials. arc_tangent is of atan(sqrt z)/sqrt z, sines are of sin(sqrt z)/sqrt z,
/// cosines of cos(sqrt z).
struct Tier {
  std::string name;  ///< Fast, Accurate, Slow
  bool is_tested;    ///< whether results pass the rounding test
  std::vector<Polynomial> polynomials;
  const Polynomial& operator[](const std::string& polynomial) const;
};
const std::vector<Tier>& tiers();
/// The error of a polynomial, from its coefficients alone.
double proved_error(const Polynomial& p);
/// generated/magicmass/evaluators/polynomials.hpp
std::string emit_polynomials();
}  // namespace codegen
