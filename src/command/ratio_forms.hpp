// SPDX-License-Identifier: GPL-2.0-or-later
// The exact forms of a magic or deficient ratio, and how they are shown.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace magicmass::command {

/// Minimal polynomials are given up to this k.
constexpr std::int64_t last_polynomial = 200;

/// A number as radicals, and as a root of its minimal polynomial; what there is and is not too long.
struct ExactForms {
  std::optional<std::string> radicals;
  std::optional<std::string> polynomial;
  long hidden_degree = 0;  ///< of a polynomial that is too long to be shown unasked
};

/// Of alpha_k and beta_k, k >= 1. Polynomials that do not fit a line are left out unless asked for.
ExactForms magic_forms(std::int64_t k, bool long_ones);
ExactForms deficient_forms(std::int64_t k, bool long_ones);

/// "magic      0.2360679774997897      sqrt(5) - 2" after the head, on more than one line if it is longer than 80
/// columns.
std::string ratio_lines(const std::string& head, const std::string& name, const std::string& value,
                        const ExactForms& forms);

}  // namespace magicmass::command
