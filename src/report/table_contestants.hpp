// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "report/make_contestant.hpp"

namespace magicmass::report {

/// Calls a generated function as it wants to be called.
template <std::floating_point Real, class Result>
Result call(Result (*evaluate)(Real), const Input& in) {
  return evaluate(static_cast<Real>(in.alpha));
}
template <std::floating_point Real, class Result>
Result call(Result (*evaluate)(Real, std::int64_t), const Input& in) {
  return evaluate(static_cast<Real>(in.alpha), in.index);
}
template <std::floating_point Real, class Result>
Result call(Result (*evaluate)(Real, Real), const Input& in) {
  return evaluate(static_cast<Real>(in.alpha), static_cast<Real>(in.e));
}
template <std::floating_point Real, class Result>
Result call(Result (*evaluate)(Real, Real, std::int64_t), const Input& in) {
  return evaluate(static_cast<Real>(in.alpha), static_cast<Real>(in.e), in.index);
}
template <class Result>
Result call(Result (*evaluate)(std::int64_t), const Input& in) {
  return evaluate(in.index);
}

/// Every evaluator of one generated table; a row that is added to the table becomes a contestant.
template <class Real, const auto& table>
std::vector<Contestant> table_contestants(const std::string& quantity) {
  std::vector<Contestant> contestants;
  const auto add = [&]<std::size_t index>(std::integral_constant<std::size_t, index>) {
    constexpr const auto& row = table[index];
    Contestant one =
        make_contestant(row.name, quantity, row.form, precision_name<Real>(),
                        [](const Input& input) { return call(table[index].evaluate, input); });
    one.derived_form = row.form;
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
