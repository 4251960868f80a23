// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "report/make_contestant.hpp"

namespace magicmass::report {

/// Calls a generated function as it wants to be called.
template <auto Evaluate, class Real>
auto call(const Input& input) {
  const auto alpha = static_cast<Real>(input.alpha);
  if constexpr (std::is_invocable_v<decltype(Evaluate), Real, std::int64_t>)
    return Evaluate(alpha, input.index);
  else if constexpr (std::is_invocable_v<decltype(Evaluate), std::int64_t> &&
                     !std::is_same_v<decltype(Evaluate), Real (*)(Real)>)
    return Evaluate(input.index);
  else
    return Evaluate(alpha);
}

/// Every evaluator of one generated table; a row that is added to the table becomes a contestant.
template <class Real, const auto& table>
std::vector<Contestant> table_contestants(const std::string& quantity) {
  std::vector<Contestant> contestants;
  const auto add = [&]<std::size_t index>(std::integral_constant<std::size_t, index>) {
    constexpr const auto& row = table[index];
    Contestant one = make_contestant(
        row.name, quantity, row.form, precision_name<Real>(),
        [](const Input& input) { return call<table[index].evaluate, Real>(input); });
    one.ulp_bound = row.ulp_bound;
    one.eps_bound = row.eps_bound;
    contestants.push_back(std::move(one));
  };
  [&]<std::size_t... index>(std::index_sequence<index...>) {
    (add(std::integral_constant<std::size_t, index>{}), ...);
  }
  (std::make_index_sequence<table.size()>{});
  return contestants;
}

}  // namespace magicmass::report
