// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/error_free.hpp"
#include "magicmass/arithmetic/half_arcsecant.hpp"
#include "magicmass/arithmetic/root_arctangent_table.hpp"
#include "magicmass/arithmetic/table_node.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A double whose root knows what it is the root of: atan(sqrt(z)) needs no more than z and its root, each rounded once.
struct Rooted {
  double value;

  explicit Rooted(double exact) : value(exact) {}

  friend Rooted operator+(Rooted x, Rooted y) { return Rooted(x.value + y.value); }
  friend Rooted operator*(Rooted x, Rooted y) { return Rooted(x.value * y.value); }
  friend Rooted operator/(Rooted x, Rooted y) { return Rooted(x.value / y.value); }
};
struct RootOf {
  double square;
};
[[gnu::always_inline]] inline RootOf sqrt(Rooted z) { return {z.value}; }

/// atan(sqrt z) of a double z, 0 <= z <= 1, within 2.01 2^-53 of itself: the root's rounding and the last one.
[[gnu::always_inline]] inline Rooted atan(RootOf root) {
  // sqrt(z) F(z), as for a pair, but for the last coefficient, 2^-57. F(z) - F(c) is below 2^-9/3, and what is rounded
  // there costs 2^-62.
  const double z = root.square;
  const double s = square_root(z);
  // F(z) is 1 within 2^-61, and the powers below would leave the normal doubles
  if (z < 0x1p-60) [[unlikely]]
    return Rooted(s);
  const TableNode node = table_node_inside<8>(root_arctangent_table, z);
  const double d = node.rest;
  const double* row = node.row;
  const double square = d * d;
  const double further = (row[3] + row[4] * d) + square * (row[5] + row[6] * d);
  const Sum<double> product = two_product(s, row[0]);
  return Rooted(product.high + (product.low + s * ((row[1] + row[2] * d) + square * further)));
}

/// A double of which nothing is asked but half an arcsecant below 1: what leads to its tangent is computed for nobody.
struct OfArcsecant {
  using Real = double;
  using ArcTangent = OfArcsecant;

  double value;

  static OfArcsecant sum(double x, double y) { return {x + y}; }
  friend OfArcsecant operator*(OfArcsecant x, double y) { return {x.value * y}; }
  friend OfArcsecant reciprocal_square_root(OfArcsecant x) { return x; }
  friend OfArcsecant half_arcsecant(double x, OfArcsecant) {
    return {rounded_half_arcsecant_of(x)};
  }
  friend OfArcsecant scaled(OfArcsecant x, double power_of_two) { return {x.value * power_of_two}; }
};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
