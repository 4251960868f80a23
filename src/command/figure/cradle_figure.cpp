// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "command/figure/figure.hpp"
#include "command/scene_motion.hpp"

namespace magicmass::command {
namespace {

/// tutorials/scenes/cradle.toml, for one round trip; here, so that an installed program needs no other file.
constexpr const char* one_round_trip = R"(
kind = "chain"
blocks = 5
balls = ["magic:1", "magic:2", "magic:3", "magic:4"]
walls = "both"
until = 20
outputs = ["events"]
)";

/// Places of all bodies at one time.
std::vector<Cell> row(const SceneMotion& motion, double time, std::size_t contacts) {
  std::vector<Cell> cells = {number_cell(time), number_cell(static_cast<std::int64_t>(contacts))};
  for (std::size_t body = 0; body < motion.names.size(); ++body)
    cells.push_back(number_cell(motion.position(body, contacts, time)));
  return cells;
}

bool is_ball(std::size_t body) { return body % 2 == 1; }

}  // namespace

SceneMotion cradle_motion() {
  return follow_scene(parse_scene(one_round_trip, "cradle"), most_contacts_of_a_picture);
}

Figure cradle_figure() {
  const SceneMotion motion = cradle_motion();
  Figure figure{
      .title = "The generalised Newton's cradle in space and time",
      .description =
          "Position over time of five equal blocks A_1 to A_5 (solid) and the balls C_1 to C_4 "
          "between them (dashed), whose mass ratios are the magic ones alpha_1 to alpha_4, between "
          "two walls (thick). A_1 comes from below and stops at once; each ball C_k "
          "bounces k times between its blocks, then rests, and the next block has the whole "
          "momentum. A_5 meets the upper wall at t = 9, and all happens again the other way "
          "round: at t = 20 A_1 is where it began, with the speed it began with. Lines "
          "of bodies at rest are horizontal, and at most three neighbours move at a time.",
      .width = 900,
      .height = 640,
      .columns = {"t", "contacts"},
      .rows = {},
      .script = fmt::format(
          "set key outside above center horizontal Left reverse samplen 4 width -4\nset xrange "
          "[{}:{}]\nset yrange "
          "[{}:{}]\n"
          "set xlabel 't / (L/V)'\nset ylabel 'x / L' offset 1\nset xtics 0,2 nomirror\n"
          "set ytics 0,1 nomirror\nset rmargin 6\nset border 2\n",
          motion.begin, motion.end, motion.left - 0.25, motion.right + 0.25)};
  for (const double wall : {motion.left, motion.right})
    figure.script += fmt::format(
        "set arrow from graph 0, first {0} to graph 1, first {0} nohead front lw 4 lc rgb "
        "'#444444'\n",
        wall);
  figure.rows.push_back(row(motion, motion.begin, 0));
  for (std::size_t i = 0; i < motion.contacts.size(); ++i)
    figure.rows.push_back(row(motion, motion.contacts[i].time, i + 1));
  figure.rows.push_back(row(motion, motion.end, motion.contacts.size()));
  std::string plots;
  for (std::size_t body = 0; body < motion.names.size(); ++body) {
    figure.columns.push_back("x_" + motion.names[body]);
    figure.script +=
        fmt::format("set label '{}' at graph 1, first {:.9g} offset 1,0{}\n", motion.names[body],
                    motion.position(body, motion.contacts.size(), motion.end),
                    is_ball(body) ? " textcolor rgb '#d55e00'" : "");
    plots += fmt::format(
        "{}data using 1:{} with lines {} {}", plots.empty() ? "" : ", ", figure.columns.size(),
        is_ball(body) ? "lw 1.8 dt (6,4) lc rgb '#d55e00'" : "lw 2 dt solid lc rgb 'black'",
        body == 0   ? "title 'blocks A_1 to A_5'"
        : body == 1 ? "title 'balls C_1 to C_4, magic:1 to magic:4'"
                    : "notitle");
  }
  figure.script += "plot " + plots + "\n";
  return figure;
}

}  // namespace magicmass::command
