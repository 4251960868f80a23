// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of rough numbers, in primitives_for_target.cpp's table.
#pragma once

#include <type_traits>

#include "arithmetic/primitive_numbers.hpp"
#include "magicmass/arithmetic/rough_functions.hpp"

namespace magicmass::testing {
inline namespace MAGICMASS_TARGET {

using arithmetic::Angle;
using arithmetic::Magnitude;
using arithmetic::Rounded;

inline constexpr auto rounded_rest = [](const auto* x, auto* y) {
  using T = std::remove_cvref_t<decltype(x[0])>;
  const Wide<T> wide{x[0], x[1]};
  y[0] = rounded((wide - Rounded<T>{x[2]}) + T(1.0));
  y[1] = rounded(Rounded<T>{x[0]} / x[2]);
  y[2] = rounded(-wide);
};

inline constexpr auto cut_sums = [](const auto* x, auto* y) {
  using T = std::remove_cvref_t<decltype(x[0])>;
  const auto cut = parts(rough(x));
  put(T(1.0) - scaled(-cut, 4.0), y);
  const Wide<T> wide{x[2], x[3]};
  y[2] = rounded(cut + wide);
  y[3] = rounded(Rounded<T>(cut)) + rounded(Rounded<T>(wide));
};

inline constexpr auto cut_times_near_one = [](const auto* x, auto* y) {
  put(parts(rough(x)) * near_one(x[2]), y);
};

inline constexpr auto wide_sums = [](const auto* x, auto* y) {
  using T = std::remove_cvref_t<decltype(x[0])>;
  const Wide<T> one{x[0], x[1]}, other{x[2], x[3]};
  y[0] = rounded(scaled(one + other, -2.0));
  y[1] = rounded(one - other);
};

inline constexpr auto rough_root = [](const auto* x, auto* y) {
  using Number = decltype(rough(x));
  const auto square = Number::root_argument(x[0], x[0] >= typename Number::Real(1.0));
  put(square, y);
  put(reciprocal_square_root(square), y + 2);
};

inline constexpr auto rough_reciprocal = [](const auto* x, auto* y) {
  using Number = decltype(rough(x));
  const auto sum = Number::sum(typename Number::Real(1.0), x[0]);
  put(sum, y);
  put(reciprocal(sum), y + 2);
};

inline constexpr auto rough_tangent = [](const auto* x, auto* y) {
  const auto tangent = decltype(rough(x))::half_arcsecant_tangent(x[0]);
  put(tangent, y);
  const auto angle = arctangent(tangent);
  y[2] = angle.high;
  y[3] = angle.low;
};

inline constexpr auto rough_arctangent = [](const auto* x, auto* y) {
  const auto angle = arctangent(rough(x));
  y[0] = angle.high;
  y[1] = angle.low;
};

inline constexpr auto rough_sine_cosine = [](const auto* x, auto* y) {
  const auto both = sine_cosine(rough(x));
  put(both.sine, y);
  put(both.cosine, y + 2);
  using T = std::remove_cvref_t<decltype(x[0])>;
  const auto small = small_sine_cosine(Magnitude<T>{x[0], x[1]});
  put(small.sine, y + 4);
  y[6] = small.cosine.below;
};

inline constexpr auto rough_square = [](const auto* x, auto* y) { put(squared(rough(x)), y); };

inline constexpr auto rough_from_pi = [](const auto* x, auto* y) {
  const auto rest = magnitude(scaled(decltype(rough(x))::pi(), 0.5) - rough(x));
  y[0] = rest.high;
  y[1] = rest.low;
};

inline constexpr auto angle_times_whole = [](const auto* x, auto* y) {
  const auto given = rough(x);
  put(Angle<typename decltype(rough(x))::Real>{given.high, given.low} * x[2], y);
};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::testing
