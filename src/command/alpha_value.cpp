// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/alpha_value.hpp"

#include <cmath>
#include <optional>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"

namespace magicmass::command {

double nearest_double(const MassRatio& alpha) {
  if (const auto* magic = std::get_if<Magic>(&alpha))
    return reference::nearest_ratio<double>(*magic);
  if (const auto* deficient = std::get_if<Deficient>(&alpha))
    return reference::nearest_ratio<double>(*deficient);
  const auto value = reference::nearest<double>(*reference::exact(alpha));
  if (!(value > 0.0) || !std::isfinite(value))
    throw Undecided("alpha is outside the doubles (5e-324 to 1.8e308); use --tier exact");
  return value;
}

Cell alpha_cell(const MassRatio& alpha) {
  if (const auto* value = std::get_if<double>(&alpha)) return number_cell(*value);
  return text_cell(to_text(alpha));
}

}  // namespace magicmass::command
