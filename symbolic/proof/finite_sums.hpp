// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include <ginac/ginac.h>

// Inside of the kernel; included by .cpp files only.
namespace magicmass::proof {

// The finite sums that the kernel understands, with k = summation_index():
//   sum over k from lower to upper of  front [(-1)^k] x^p y^q/(p! q!),
// p = a k + b and q = c - d k with integers a, d > 0 and b, and the bounds are exactly where p, q >= 0.
// So each term is defined, with 0^0 = 1, and as 1/m! = 0 for m < 0 the sum is one over all integers k.
struct FiniteSum {
  GiNaC::ex front;  // free of k
  bool alternating = false;
  GiNaC::ex x, p, y, q;
};

std::optional<FiniteSum> finite_sum_of(const GiNaC::ex& sum);

}  // namespace magicmass::proof
