// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/animate/layout.hpp"

#include <algorithm>
#include <cmath>

namespace magicmass::command {
namespace {

constexpr double margin = 24.0;
constexpr double largest_size = 64.0;
constexpr double least_share = 0.35;  // of the largest, so that a light body is seen

}  // namespace

Layout layout_of(const SceneMotion& motion) {
  Layout layout{};
  const auto bodies = static_cast<double>(motion.names.size());
  const double heaviest = *std::max_element(motion.masses.begin(), motion.masses.end());
  const double size = std::min(largest_size, Layout::width / 2 / bodies);
  double taken = margin;
  for (std::size_t body = 0; body < motion.names.size(); ++body) {
    const double share = std::cbrt(motion.masses[body] / heaviest);
    layout.sizes.push_back(size * std::max(least_share, share));
    layout.offsets.push_back(taken + layout.sizes.back() / 2);
    layout.is_ball.push_back(motion.names[body].starts_with("C"));
    taken += layout.sizes.back();
  }
  layout.room = Layout::width - margin - taken;
  if (motion.left_wall) layout.left_wall = margin;
  if (motion.right_wall) layout.right_wall = Layout::width - margin;
  return layout;
}

std::vector<double> places(const SceneMotion& motion, const Layout& layout, std::size_t contacts,
                           double time) {
  std::vector<double> x;
  for (std::size_t body = 0; body < motion.names.size(); ++body)
    x.push_back(motion.position(body, contacts, time));
  const double left = std::min(motion.left, x.front());
  const double scale = layout.room / (std::max(motion.right, x.back()) - left);
  for (std::size_t body = 0; body < x.size(); ++body)
    x[body] = layout.offsets[body] + scale * (x[body] - left);
  return x;
}

}  // namespace magicmass::command
