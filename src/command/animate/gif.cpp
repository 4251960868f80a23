// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "command/animate/animation.hpp"
#include "command/animate/layout.hpp"
#include "command/figure/drawing.hpp"

namespace magicmass::command {
namespace {

constexpr int pictures = 200;
constexpr double most_crossings = 3.0;  // in 10 seconds; there and back takes two

/// x, half a side or 0, radius or 0: of all bodies at one moment.
std::string moment(const SceneMotion& motion, const Layout& layout, double time) {
  const auto done = static_cast<std::size_t>(
      std::partition_point(motion.contacts.begin(), motion.contacts.end(),
                           [&](const MotionContact& contact) { return contact.time <= time; }) -
      motion.contacts.begin());
  std::string rows;
  const std::vector<double> x = places(motion, layout, done, time);
  for (std::size_t body = 0; body < x.size(); ++body) {
    const double half = layout.sizes[body] / 2;
    rows += fmt::format("{:.4f},{:.4f},{:.4f}\n", x[body], layout.is_ball[body] ? 0 : half,
                        layout.is_ball[body] ? half : 0);
  }
  return rows + "\n\n";
}

std::string wall_script(double x) {
  return fmt::format("set arrow from {0:.3f},0 to {0:.3f},110 nohead lw 5 lc rgb '#6e7781'\n", x);
}

}  // namespace

std::string animation_gif(const SceneMotion& motion) {
  const Layout layout = layout_of(motion);
  const double span = std::min(motion.end - motion.begin, most_crossings * motion.crossing);
  std::string rows, times;
  for (int i = 0; i < pictures; ++i) {
    const double time = motion.begin + span * i / (pictures - 1);
    rows += moment(motion, layout, time);
    times += fmt::format(" {:.4g}", time);
  }
  std::string script = fmt::format(
      "set terminal gif animate delay 5 loop 0 size 800,160 font 'sans,12'\nset output 'figure'\n"
      "set key off\nunset border\nunset tics\nset margins 0,0,0,0\nset xrange [0:{0}]\nset yrange "
      "[-50:150]\nset style fill solid 1 border lc rgb '#1b1f24'\ntimes = '{1}'\n"
      "set arrow from 0,0 to {0},0 nohead lw 1.5 lc rgb '#6e7781'\n",
      Layout::width, times);
  if (layout.left_wall) script += wall_script(*layout.left_wall);
  if (layout.right_wall) script += wall_script(*layout.right_wall);
  script += fmt::format(
      "do for [i=0:{}] {{\nset label 1 't = '.word(times, i + 1) at graph 0.5,0.1 center\n"
      "plot data index i using ($2 > 0 ? $1 : NaN):2:2:2 with boxxyerror lc rgb '#bcd9ec', "
      "data index i using ($3 > 0 ? $1 : NaN):3:3 with circles lc rgb '#e69b5f'\n}}\n",
      pictures - 1);
  return gnuplot_file(rows, script, "allowed without it: the page alone, no --gif");
}

}  // namespace magicmass::command
