// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/figure/ratio_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "command/alpha_value.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/restitution.hpp"

namespace magicmass::command {

std::vector<MassRatio> thresholds(double first, double last) {
  std::vector<MassRatio> descending;
  for (std::int64_t k = 1;; ++k) {
    const generated::Ratios<double> ratios = fast::ratios(k);
    if (ratios.magic < first) break;
    if (ratios.magic <= last) descending.emplace_back(Magic{k});
    if (ratios.deficient >= first && ratios.deficient <= last)
      descending.emplace_back(Deficient{k});
  }
  return {descending.rbegin(), descending.rend()};
}

std::vector<double> ratio_grid(double first, double last, int steps) {
  std::vector<double> grid = {first, last};
  for (int octave = std::ilogb(first); octave <= std::ilogb(last); ++octave)
    for (int i = 0; i < steps; ++i) {
      const double alpha = std::ldexp(1.0 + static_cast<double>(i) / steps, octave);
      if (alpha > first && alpha < last) grid.push_back(alpha);
    }
  for (const MassRatio& threshold : thresholds(first, last))
    grid.push_back(nearest_double(threshold));
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  return grid;
}

double last_where(double first, double last, const std::function<bool(double)>& holds) {
  while (std::nextafter(first, last) < last) {
    const double middle = std::midpoint(first, last);
    (holds(middle) ? first : last) = middle;
  }
  return first;
}

double last_collapse(double e) {
  const cln::cl_RA exact_e = reference::exact(e);
  return last_where(1e-40, 1.0,
                    [&](double alpha) { return !reference::count_collisions(alpha, exact_e); });
}

}  // namespace magicmass::command
