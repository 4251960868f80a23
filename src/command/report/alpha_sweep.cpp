// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/alpha_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "command/alpha_value.hpp"
#include "command/figure/ratio_grid.hpp"
#include "magicmass/counts.hpp"
#include "report/exact_value.hpp"
#include "report/quantities.hpp"

namespace magicmass::command {
namespace {

constexpr double lowest = 0.01;
constexpr double highest = 1.6;
const std::string quantity = "velocities";

bool is_shown(const report::Contestant& one) {
  return one.is_naive || one.name.starts_with(quantity + "_") || one.name == "fast" ||
         one.name == "accurate";
}

double error(const report::Contestant& contestant, const report::Input& input,
             const report::ExactValue& exact, std::size_t member) {
  std::array<long double, 8> got{};
  contestant.evaluate(input, got.data());
  return report::deviation(static_cast<double>(got[member]), exact).ulp;
}

}  // namespace

std::vector<AlphaSweep> alpha_sweeps(const std::vector<report::Contestant>& contestants,
                                     std::size_t size, report::Oracle& oracle, Progress& progress) {
  const std::vector<std::string> members = report::quantity_named(quantity).members;
  std::vector<const report::Contestant*> shown;
  AlphaSweep empty;
  for (const report::Contestant& one : contestants)
    if (one.quantity == quantity && one.precision == "double" && is_shown(one)) {
      shown.push_back(&one);
      empty.evaluators.push_back(one.name);
    }
  if (shown.empty()) return {};
  for (const MassRatio& one : thresholds(lowest, highest))
    (std::holds_alternative<Magic>(one) ? empty.magic : empty.deficient)
        .push_back(nearest_double(one));
  std::vector<AlphaSweep> sweeps(2, empty);
  sweeps[0].member = "a";
  sweeps[1].member = "b";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < size; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(size);
    if (!progress.step("errors against alpha", share)) return {};
    const double alpha = lowest * std::pow(highest / lowest, share);
    const Counts counts = count_collisions(alpha).value();
    for (AlphaSweep& sweep : sweeps) {
      const report::Input input{alpha, sweep.member == "a" ? counts.N_A : counts.N_B};
      const auto which = static_cast<std::size_t>(
          std::find(members.begin(), members.end(), sweep.member) - members.begin());
      const report::ExactValue& exact = oracle.at(quantity, input).at(which);
      AlphaSweep::Point point{alpha, std::max(0.5, exact.condition / 2), {}};
      for (const report::Contestant* one : shown)
        point.ulp.push_back(one->can(input) ? error(*one, input, exact, which) : nan);
      sweep.points.push_back(std::move(point));
    }
  }
  return sweeps;
}

}  // namespace magicmass::command
