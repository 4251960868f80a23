// THE table that all bounds rest on: what each operation of a number type loses and leaves below.
#pragma once

#include "codegen/exact.hpp"

namespace codegen {
/// From its function's series, in exact rationals, with a proof of its error: |p - f| <= the sum of
/// the Chebyshev coefficients of p - (series), and the series' remainder.
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

/// `loss` is relative to the result's size; `loose`: |low| <= loose |high|. Neither is negative.
struct Loss {
  double loss, loose;
};
/// Terms of third order, and sizes of computed in place of exact values, go into this factor.
constexpr double and_more = 1 + 0x1p-20;
/// No low part is looser: what `and_more` allows for.
constexpr double loosest = 0x1p-40;
/// Stands for each power below it.
constexpr double least_power(bool is_wide) { return is_wide ? 0x1p-480 : 0x1p-200; }

/// DoubleDouble with a tier's polynomials, or (tier null) a type that rounds each result correctly
/// to a unit u: MPFR, whose bounds are emitted in units of u.
struct NumberType {
  double u;
  const Tier* tier;
  bool is_pair() const { return tier != nullptr; }
  std::string name() const { return is_pair() ? tier->name : "Ziv"; }

  Loss exact_sum() const;
  Loss constant(double lost) const;  ///< `lost`: what high + low of it lacks, relative
  Loss sum(double x, double y) const;
  /// Losses relative to |x|, |y| and the result.
  struct Cancelling {
    double of_x, of_y, of_result, loose;
  };
  Cancelling cancelling_sum(double x, double y) const;
  Loss product(double x, double y) const;
  Loss product(double x) const;  ///< by an exact number
  Loss quotient(double x, double y) const;
  Loss reciprocal_root(double y) const;

  /// A polynomial where |z - centre| <= size, |low part of z - centre| <= low. Relative to the
  /// function's least value; `slope` is how much an error of z counts.
  struct OfPolynomial {
    double loss, loose, slope;
  };
  OfPolynomial polynomial(const Polynomial& p, double size, double low) const;
  /// Of t where z = t^2 has a low part z and an error `z_off`, relative.
  Loss arc_tangent(double t, double z, double z_off) const;
  /// `angle`: what taking off a quarter turn loses, relative to the angle. The cosine loses
  /// `absolute` more, and its low part is larger by up to `spill`: near 0 it is large.
  struct SineCosine {
    Loss sine, cosine;
    double angle = 0, absolute = 0, spill = 0;
  };
  SineCosine small_sine_cosine(double x) const;
  SineCosine sine_cosine(double x) const;
  /// x^k for a whole k up to `most`, x off by `of_x`, relative.
  Loss power(double of_x, double most) const;
  /// The roundings of the rounding test itself, relative to the result.
  double rounding_test(double x) const;
};
}  // namespace codegen
