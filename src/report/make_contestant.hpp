// SPDX-License-Identifier: GPL-2.0-or-later
// From one concrete function to a Contestant: the loops are instantiated for it, so the compiler sees what a user's
// own loop would show it.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "magicmass/counts.hpp"
#include "magicmass/quantities.hpp"
#include "report/contestant.hpp"
#include "report/ending.hpp"

namespace magicmass::report {

template <class Real>
constexpr const char* precision_name() {
  if constexpr (std::is_same_v<Real, float>) return "float";
  if constexpr (std::is_same_v<Real, double>) return "double";
  return "long double";
}

/// Members of any result, in order.
template <class Result>
requires std::is_class_v<Result>
auto members_of(const Result& result) { return generated::as_array(result); }
inline std::array<std::int64_t, 2> members_of(const Counts& n) { return {n.N_A, n.N_B}; }
template <class Real>
requires std::is_floating_point_v<Real> std::array<Real, 1> members_of(Real x) { return {x}; }

/// Calls visit with each member of any result, in order.
template <class Result, class Visit>
void each_member(const Result& result, Visit visit) {
  for (const auto member : members_of(result)) visit(member);
}
template <class Real, class Visit>
void each_member(const Ending<Real>& ending, Visit visit) {
  for (const Real velocity : {ending.a_t, ending.b_t, ending.c_t}) visit(velocity);
  for (const std::int64_t count : members_of(ending.counts)) visit(count);
}

/// The result counts as used, so that no evaluation is dropped.
template <class Result>
inline void keep(const Result& result) {
  asm volatile("" : : "m"(result) : "memory");
}

/// Zero, but the compiler cannot know.
inline std::uint64_t opaque_zero() {
  std::uint64_t zero = 0;
  asm volatile("" : "+r"(zero));
  return zero;
}

/// 64 bits that wait for x.
inline std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }
inline std::uint64_t bits_of(float x) { return std::bit_cast<std::uint32_t>(x); }
inline std::uint64_t bits_of(long double x) { return bits_of(static_cast<double>(x)); }
inline std::uint64_t bits_of(std::int64_t x) { return static_cast<std::uint64_t>(x); }

/// The same input, but it cannot be had before `result`, and no infinity or NaN of a result gets into it: its bits are
/// masked by a zero that the compiler cannot see and mixed into those of alpha and index.
template <class Result>
Input after(const Input& input, const Result& result, std::uint64_t zero) {
  std::uint64_t bits = 0;
  each_member(result, [&](const auto member) { bits ^= bits_of(member); });
  bits &= zero;
  return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(input.alpha) ^ bits),
          static_cast<std::int64_t>(static_cast<std::uint64_t>(input.index) ^ bits), input.e};
}

/// A contestant whose one evaluation is evaluate(Input).
template <class Evaluate>
Contestant make_contestant(std::string name, std::string quantity, std::string form,
                           std::string precision, Evaluate evaluate) {
  Contestant contestant;
  contestant.name = std::move(name);
  contestant.quantity = std::move(quantity);
  contestant.form = std::move(form);
  contestant.precision = std::move(precision);
  contestant.can = [](const Input&) { return true; };
  contestant.evaluate = [evaluate](const Input& input, long double* members) {
    each_member(evaluate(input),
                [&](const auto member) { *members++ = static_cast<long double>(member); });
  };
  contestant.evaluate_all = [evaluate](std::span<const Input> inputs) {
    for (const Input& input : inputs) keep(evaluate(input));
  };
  contestant.evaluate_chained = [evaluate](std::span<const Input> inputs) {
    if (inputs.empty()) return;
    const std::uint64_t zero = opaque_zero();
    auto last = evaluate(inputs[0]);
    for (const Input& input : inputs.subspan(1)) last = evaluate(after(input, last, zero));
    keep(last);
  };
  return contestant;
}

}  // namespace magicmass::report
