// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/evaluation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "report/errors.hpp"
#include "report/last_collision.hpp"
#include "report/quantities.hpp"

namespace magicmass::report {
namespace {

constexpr std::size_t most_members = 16;

/// Counts are whole numbers whatever they were computed in: right or wrong by so many.
Deviation compared_counts(long double got, const ExactValue& exact) {
  Deviation result;
  result.ulp = static_cast<double>(std::fabs(got - exact.high));
  result.has_ulp = true;
  result.correctly_rounded = got == exact.high;
  return result;
}

Deviation compared_in(const std::string& precision, long double got, const ExactValue& exact) {
  if (precision == "float") return deviation(static_cast<float>(got), exact);
  if (precision == "double") return deviation(static_cast<double>(got), exact);
  return deviation(got, exact);
}

std::int64_t last_index(const std::string& quantity, double alpha) {
  const LastCollision last = last_collision(alpha);
  return quantity_named(quantity).takes("n") ? last.N_A : last.total() - 1;
}

}  // namespace

Input rounded_input(const Input& input, const std::string& quantity, const std::string& precision) {
  if (precision != "float" || !takes_alpha(quantity)) return input;
  Input rounded{static_cast<double>(static_cast<float>(input.alpha)), input.index,
                static_cast<double>(static_cast<float>(input.e))};
  if (has_last_index(quantity) && rounded.alpha > 0 && std::isfinite(rounded.alpha))
    rounded.index = std::min(rounded.index, last_index(quantity, rounded.alpha));
  return rounded;
}

std::optional<std::vector<std::optional<Deviation>>> compared(const Contestant& contestant,
                                                              const Input& input, Oracle& oracle) {
  if (takes_alpha(contestant.quantity) && !(input.alpha > 0 && std::isfinite(input.alpha)))
    return std::nullopt;
  if (input.index < (takes_alpha(contestant.quantity) ? 0 : 1)) return std::nullopt;
  if (has_last_index(contestant.quantity) &&
      input.index > last_index(contestant.quantity, input.alpha))
    return std::nullopt;
  if (has_counts(contestant.quantity) && !last_collision(input.alpha).is_known) return std::nullopt;
  if (!contestant.can(input)) return std::nullopt;
  const std::vector<ExactValue>& exact =
      oracle.at(contestant.quantity, input, contestant.derived_form);
  std::array<long double, most_members> got{};
  contestant.evaluate(input, got.data());
  const std::vector<std::string>& members = quantity_named(contestant.quantity).members;
  std::vector<std::optional<Deviation>> deviations;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    deviations.emplace_back();
    if (exact[i].exists)
      deviations.back() = is_count(members[i])
                              ? compared_counts(got[i], exact[i])
                              : compared_in(contestant.precision, got[i], exact[i]);
  }
  return deviations;
}

}  // namespace magicmass::report
