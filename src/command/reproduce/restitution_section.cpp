// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "command/reproduce/sections.hpp"
#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"

namespace magicmass::command {
namespace {

/// Of rho, between two mass ratios.
struct Extremum {
  const char* name;
  double elastic;  ///< where it is for e = 1
  double left;
  double right;
  bool is_maximum;
};

double transmission(double alpha, double e) {
  double rho = 0.0;
  fast::transmission(std::span(&alpha, 1), e, std::span(&rho, 1));
  return rho;
}

/// By thirds of the interval, in which rho has this one extremum. Good for 1e-7: rho is flat at a maximum.
double place(const Extremum& extremum, double e) {
  double left = extremum.left, right = extremum.right;
  for (int i = 0; i < 100; ++i) {
    const double low = left + (right - left) / 3, high = right - (right - left) / 3;
    const bool rises = transmission(low, e) < transmission(high, e);
    (rises == extremum.is_maximum ? left : right) = rises == extremum.is_maximum ? low : high;
  }
  return std::midpoint(left, right);
}

/// The four that the paper names, each with half the way to its neighbours.
std::array<Extremum, 4> extrema() {
  const auto first = accurate::ratios(1), second = accurate::ratios(2), third = accurate::ratios(3);
  const auto between = [](double x, double y) { return std::sqrt(x * y); };
  const double right_of_beta_1 = between(first.deficient, first.magic);
  const double left_of_beta_1 = between(second.magic, first.deficient);
  const double left_of_alpha_2 = between(second.deficient, second.magic);
  return {{{"alpha_1", first.magic, right_of_beta_1, 1 / right_of_beta_1, true},
           {"beta_1", first.deficient, left_of_beta_1, right_of_beta_1, false},
           {"alpha_2", second.magic, left_of_alpha_2, left_of_beta_1, true},
           {"beta_2", second.deficient, between(third.magic, second.deficient), left_of_alpha_2,
            false}}};
}

double percent(double shifted, double elastic) { return 100 * (shifted - elastic) / elastic; }

std::string with_decimals(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_not_of("-0.") == std::string::npos ? "0" : text;
}

}  // namespace

ComparisonSection restitution_section() {
  ComparisonSection section{
      "Shifts of the extrema of rho under restitution",
      "In percent of the elastic mass ratio, at e = 0.9 (section Inelastic collisions). The first "
      "rows take our extremum rounded to three decimals, the others as it is; its place is found "
      "by "
      "search to six decimals.",
      {}};
  const std::array<const char*, 4> printed = {"0", "0.43", "4.6", "0.84"};
  const std::array<Extremum, 4> all = extrema();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double rounded = std::stod(fmt::format("{:.3f}", place(all[i], 0.9)));
    section.rows.push_back(
        {"fig:inelastic",
         fmt::format("shift of {}, extremum rounded to {:.3f}", all[i].name, rounded), printed[i],
         with_decimals(percent(rounded, all[i].elastic), 4), ""});
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double exact = place(all[i], 0.9);
    section.rows.push_back(
        {"fig:inelastic", fmt::format("shift of {}, extremum at {:.6f}", all[i].name, exact),
         printed[i], with_decimals(percent(exact, all[i].elastic), 4),
         "the paper's shift is that of the extremum rounded to three decimals; the elastic ratio "
         "is not rounded"});
  }
  for (const double e : {0.9, 0.8, 0.7})
    section.rows.push_back({"fig:inelastic", fmt::format("first maximum at e = {}", e), "1",
                            with_decimals(place(all[0], e), 6), ""});
  return section;
}

}  // namespace magicmass::command
