// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/drawings.hpp"

#include "answers/evaluate.hpp"
#include "answers/motion.hpp"
#include "magicmass/scenes/trajectory.hpp"

namespace answers {
namespace {

using namespace magicmass::scenes;
using notation::Alpha;
using notation::Magic;

/// The time and the places of all bodies, at the start, at each collision and at the end.
using Places = std::vector<std::vector<double>>;

/// Of a scene in TOML that has `until`; times as if it began at -1.
Places places(const std::string& text) {
  Scene scene = parse_scene(text, "a scene of the figures");
  const Result result = run(scene);
  scene.times = {value_of(0), *scene.until};
  stream(scene, result.plan, [&](const magicmass::scenes::Row& row) {
    const auto* time = std::get_if<double>(&row.time);
    scene.times.push_back({"", time ? Quadratic(*time) : std::get<Quadratic>(row.time)});
  });
  Places all;
  trajectory(scene, result, [&](const Point& point) {
    if (point.body == 0) all.push_back({double_of(point.time).value() - 1});
    all.back().push_back(double_of(point.position).value());
  });
  return all;
}

/// A and C are a length apart, so that the first collision is at time 0 of the paper.
Places three_bodies(const std::string& alpha) {
  return places("alpha = " + alpha + "\npositions = [-1, 0, 1]\nuntil = 6\n");
}

}  // namespace

Table setup_data() {
  const answers::Row v = rounded([] { return velocities(Magic{3}, 0); });
  Table table{named_columns({"body", "x", "v"}), {}};
  table.rows = {{text_cell("A"), real_cell(-1), v[0]},
                {text_cell("C"), real_cell(0), v[2]},
                {text_cell("B"), real_cell(1), v[1]}};
  return table;
}

Table trajectories_data() {
  Table table{named_columns({"panel", "t", "x_A", "x_C", "x_B"}), {}};
  for (const auto& [panel, alpha] :
       {std::pair{"a", "\"magic:3\""}, {"b", "\"12/100\""}, {"c", "\"10/100\""}}) {
    for (const std::vector<double>& place : three_bodies(alpha)) {
      table.rows.push_back(real_cells(place));
      table.rows.back().insert(table.rows.back().begin(), text_cell(panel));
    }
  }
  return table;
}

Table sphere_data() {
  constexpr int cycles = 5;
  constexpr int steps = 24;  // from one V_n to the next
  Table table{named_columns({"part", "n", "a", "b", "sqrt_alpha_c_prime"}), {}};
  const auto add = [&](const char* part, int n, int over) {
    answers::Row row = rounded([&] {
      const Ball alpha = ball_of(Magic{cycles});
      const Ball index(cln::cl_RA(n) / over);
      const Values values{
          {kernel::real("alpha"), alpha}, {kernel::real("V"), 1}, {kernel::integer("n"), index}};
      const auto of = [&](const char* id) { return evaluate(right_side(id), values); };
      // Far from 0 each: what is 0 has no nearest double that digits could show.
      const Ball shift = 4;
      return Balls{index, of("power.a") + shift, of("power.b") + shift,
                   sqrt(alpha) * of("power.c_prime") + shift};
    });
    for (std::size_t i = 1; i < row.size(); ++i) row[i] = real_cell(std::stod(row[i].text) - 4);
    row.insert(row.begin(), text_cell(part));
    table.rows.push_back(row);
  };
  for (int n = 0; n <= cycles; ++n) add("V_n", n, 1);
  for (int i = 0; i <= (2 * cycles + 1) * steps; ++i) add("circle", i, steps);
  return table;
}

Table wedge_data() {
  Table table{named_columns({"collision", "t", "s", "angle"}), {}};
  const Places all = three_bodies("\"magic:3\"");
  for (std::size_t j = 1; j + 1 < all.size(); ++j) {
    const std::vector<double>& at = all[j];
    const std::string name = (j % 2 == 1 ? "P_" : "Q_") + std::to_string((j + 1) / 2);
    const answers::Row angle = rounded([&] {
      const Values values{{kernel::real("alpha"), ball_of(Magic{3})}};
      return Balls{evaluate(right_side("rotation.psi"), values) *
                   Ball(cln::cl_RA(static_cast<int>(j)) / 2)};
    });
    table.rows.push_back({text_cell(name), real_cell(at[0]), real_cell(at[3] - at[1]), angle[0]});
  }
  return table;
}

Table way_data() {
  Table table{named_columns({"t", "x_block", "x_ball"}), {}};
  Places all = places("kind = \"wall\"\nmass_ratio = 100\nuntil = 3\n");
  for (std::vector<double>& place : all) {
    place[0] += 1;  // they touch at time 0
    table.rows.push_back(real_cells(place));
  }
  return table;
}

Table cradle_data() {
  Table table{
      named_columns({"t", "x_A1", "x_C1", "x_A2", "x_C2", "x_A3", "x_C3", "x_A4", "x_C4", "x_A5"}),
      {}};
  const Places all = places(
      "kind = \"chain\"\n"
      "masses = [1, \"magic:1\", 1, \"magic:2\", 1, \"magic:3\", 1, \"magic:4\", 1]\n"
      "positions = [-1, 0, 1, 2, 3, 4, 5, 6, 7]\n"
      "velocities = [1, 0, 0, 0, 0, 0, 0, 0, 0]\n"
      "right_wall = 8\nuntil = 20\n");
  for (const std::vector<double>& place : all) table.rows.push_back(real_cells(place));
  return table;
}

}  // namespace answers
