// SPDX-License-Identifier: MIT
// Kernels' numbers rounded, and Ziv's strategy as far as it goes without certified arithmetic.
#pragma once

#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/quantities.hpp"

namespace magicmass::tiers {
inline namespace MAGICMASS_TARGET {

template <class Number>
generated::Velocities<double> nearest(const generated::Velocities<Number>& x) {
  return {rounded(x.a), rounded(x.b), rounded(x.c), rounded(x.c_prime)};
}
template <class Number>
generated::Encounters<double> nearest(const generated::Encounters<Number>& x) {
  return {rounded(x.t), rounded(x.s)};
}
template <class Number>
generated::Ratios<double> nearest(const generated::Ratios<Number>& x) {
  return {rounded(x.magic), rounded(x.deficient)};
}
template <class Number>
generated::TerminalValues<double> nearest(const generated::TerminalValues<Number>& x) {
  return {rounded(x.a_t), rounded(x.b_t), rounded(x.c_t), rounded(x.rho)};
}
template <class Number>
double nearest(const Number& x) {
  return rounded(x);
}

/// Whether the nearest double of a number within relative_error of y, which is normalised, is certainly rounded(y).
[[gnu::always_inline]] inline bool certainly_rounded(arithmetic::Pair<double> y,
                                                     double relative_error) {
  const double margin = y.high * (relative_error + 0x1p-105);
  return (y.high + (y.low + margin)) == (y.high + (y.low - margin));
}

template <template <class> class Result, class Number>
bool is_certain(const Result<Number>& x) requires requires {
  as_array(x);
}
{
  bool all = true;
  for (const Number& member : as_array(x)) all &= certainly_rounded(member);
  return all;
}
template <class Number>
bool is_certain(const Number& x) {
  return certainly_rounded(x);
}

/// Ziv's second stage: numbers within some 2^-84.
template <template <class> class Kernel, class Result, class... Inputs>
bool in_second_stage(Result& result, Inputs... inputs) {
  const auto second = Kernel<arithmetic::Bounded<double>>::evaluate(inputs...);
  result = nearest(second);
  return is_certain(second);
}

/// The first two, after numbers within 2^-67.
template <template <class> class Kernel, class Result, class... Inputs>
bool in_two_stages(Result& result, Inputs... inputs) {
  const auto first = Kernel<arithmetic::Tracked<double, true>>::evaluate(inputs...);
  result = nearest(first);
  if (is_certain(first)) [[likely]]
    return true;
  return in_second_stage<Kernel>(result, inputs...);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::tiers
