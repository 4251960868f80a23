// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cln/integer.h>
#include <cln/rational.h>

#include "random_numbers.hpp"

namespace magicmass::testing {

/// Columns of as many rows each.
using Columns = std::vector<std::vector<double>>;

/// What a primitive gives for one double at a time, and for vectors.
struct Results {
  Columns single;
  Columns lanes;
};

/// Runs the primitive on every instruction set of this machine and every number of lanes, and requires that lanes have the
/// same bits everywhere, and single doubles too; the sign of a zero counts if told so.
Results at_every_width(const char* name, const Columns& inputs, bool is_zero_signed = false);

/// The same, where single doubles and lanes have to agree as well.
Columns the_same_at_every_width(const char* name, const Columns& inputs,
                                bool is_zero_signed = false);

/// Single doubles and lanes have to agree, and all instruction sets but for primitives called "fused_...": of these all that fuse
/// products and sums, and all that do not. What they give, each once.
std::vector<Columns> at_every_rounding(const std::string& name, const Columns& inputs);

/// What it gives on every instruction set at every number of lanes, each by itself: for what may differ in all of them.
std::vector<Columns> at_each_width(const char* name, const Columns& inputs);

/// Single doubles alone, for operands that are none of a vector's.
Columns of_single_doubles(const char* name, const Columns& inputs);

/// Both columns' bits.
bool same_bits(const std::vector<double>& x, const std::vector<double>& y);

/// Positive or negative with a uniform exponent from low to high and a random, sparse or full significand.
double any_double(Generator& generator, int low, int high);
/// A low part for that high part: at most half an ulp, sometimes just that, sometimes 0.
double any_low(Generator& generator, double high);

/// 2^exponent.
inline cln::cl_RA power(long exponent) {
  const cln::cl_RA size(cln::ash(cln::cl_I(1), exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? cln::recip(size) : size;
}

/// high + low.
cln::cl_RA exact_pair(const Columns& columns, std::size_t first, std::size_t row);

}  // namespace magicmass::testing
