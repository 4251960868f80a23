// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

#include "magicmass/errors.hpp"
#include "magicmass/simulator/field.hpp"
#include "magicmass/simulator/motion.hpp"

namespace magicmass {

/// Throws InvalidInput, naming the quantity and, in floating point, its value.
template <Field Scalar>
[[noreturn]] void refuse_as_not_positive_finite(std::string_view name,
                                                [[maybe_unused]] const Scalar& value) {
  std::string got;
  if constexpr (std::is_floating_point_v<Scalar>) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    got = ", got " + std::string(text.data(), end);
  }
  throw InvalidInput(std::string(name) + " must be a positive finite number" + got);
}

/// Throws InvalidInput, naming the quantity, unless 0 < value and, in floating point, value is finite.
template <Field Scalar>
void require_positive_finite(std::string_view name, const Scalar& value) {
  bool valid = Scalar(0) < value;
  if constexpr (std::is_floating_point_v<Scalar>) {
    valid = valid && std::isfinite(value);
  }
  if (!valid) {
    refuse_as_not_positive_finite(name, value);
  }
}

/// Throws Undecided if results in units of V, L and L/V could leave the range of a floating-point type.
template <Field Scalar>
void require_scales_fit(const Scalar& V, const Scalar& L) {
  if constexpr (std::is_floating_point_v<Scalar>) {
    const bool fit = std::isfinite(V + V) && std::isnormal(L / V) && std::isnormal(V / L);
    if (!fit) {
      throw Undecided(
          "V and L are so far apart that times L/V do not fit this number type; choose other "
          "units");
    }
  }
}

/// Throws Undecided if a time or place of a contact left the range of a floating-point type.
template <Field Scalar>
void require_contact_fits(const Scalar& time, const BodyPositions<Scalar>& places) {
  if constexpr (std::is_floating_point_v<Scalar>) {
    const bool fits = std::isfinite(time) && std::isfinite(places.a) && std::isfinite(places.b) &&
                      std::isfinite(places.c);
    if (!fits) {
      throw Undecided("the next contact is too late or too far for this number type");
    }
  }
}

}  // namespace magicmass
