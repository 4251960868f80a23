// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace GiNaC {
class ex;
class numeric;
}  // namespace GiNaC

// How a physicist orders what stands in a product and in a sum; text.cpp prints by it.
namespace magicmass::proof {

// Places in a product: numbers, speeds and lengths, pi, names, indices, sums of indices, angles, other sums,
// roots, elements of sequences, functions.
enum class Place {
  number,
  leading,
  pi,
  name,
  index,
  index_sum,
  angle,
  sum,
  root,
  element,
  function,
  other
};
Place place(const GiNaC::ex& factor);

// n + 1/2, 2 k - 1: there the constant comes last.
bool is_sum_of_indices(const GiNaC::ex& sum);

// A factor as it is printed, with its place; the second tells the leading names and functions apart.
struct OrderedFactor {
  Place place;
  int within;  // V_CM before V before L, cosines before sines, sqrt(2) before sqrt(alpha) before sqrt(2 + alpha)
  std::string shown;

  friend bool operator<(const OrderedFactor& x, const OrderedFactor& y) {
    return std::tie(x.place, x.within, x.shown) < std::tie(y.place, y.within, y.shown);
  }
};
OrderedFactor ordered(const GiNaC::ex& factor, std::string shown);

// Where a term stands in its sum: by its functions and elements first (none before some), then by degree, then
// by its names. What differs in the number in front alone has one key.
struct TermKey {
  int constant = 0;    // -1 first of all, 1 last of all
  bool mixed = false;  // elements of sequences and functions: behind elements alone
  std::vector<OrderedFactor> functions;
  double degree = 0;
  std::vector<OrderedFactor> names;

  friend bool operator<(const TermKey& x, const TermKey& y) {
    return std::tie(x.constant, x.mixed, x.functions, x.degree, x.names) <
           std::tie(y.constant, y.mixed, y.functions, y.degree, y.names);
  }
};

}  // namespace magicmass::proof
