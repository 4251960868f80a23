
#include "answers/commands.hpp"
#include "answers/motion.hpp"
#include "magicmass/scenes/run.hpp"

namespace answers {
namespace {

using namespace notation;

/// alpha_k and beta_k down to a mass ratio, from the largest.
std::vector<Alpha> thresholds_above(double least) {
  std::vector<Alpha> all;
  for (int k = 1;; ++k)
    for (const Alpha& alpha : {magic(k), deficient(k)}) {
      if (nearest(alpha) < least) return all;
      all.push_back(alpha);
    }
}

/// Up to 1.2 with all thresholds, closer where the curves are narrower.
std::vector<Alpha> alphas() {
  constexpr double least = 0.01;
  std::vector<Alpha> all = thresholds_above(least);
  for (int i = 0; i <= 400; ++i) all.emplace_back(least * std::pow(1.2 / least, i / 400.0));
  std::ranges::sort(all, {}, nearest);
  return all;
}

/// The time and the places of all bodies, at the start, at each collision and at the end.
using Places = std::vector<std::vector<double>>;

/// Of a scene in TOML that has `until`; times as if it began at `start`.
Places places(const std::string& text, double start) {
  using namespace magicmass::scenes;
  Scene scene = parse_scene(text, "a scene of the figures");
  const Result result = run(scene);
  scene.times = {value_of(0), *scene.until};
  stream(scene, result.plan, [&](const magicmass::scenes::Row& row) {
    scene.times.push_back({"", std::visit([](const auto& t) { return Surd(t); }, row.time)});
  });
  Places all;
  trajectory(scene, result, [&](const Point& point) {
    if (point.body == 0) all.push_back({double_of(point.time).value() + start});
    all.back().push_back(double_of(point.position).value());
  });
  return all;
}

Table table_of(const Names& columns, const auto& all, const auto& row_of) {
  Table table{columns, {}};
  for (const auto& one : all) table.rows.push_back(row_of(one));
  return table;
}

/// A body a row: its place, its velocity before the first collision.
Table setup_data() {
  const Row v = rounded([] { return velocities(magic(3), 0); });
  return {{"body", "x", "v"},
          {{text_cell("A"), real_cell(-1), v[0]},
           {text_cell("C"), real_cell(0), v[2]},
           {text_cell("B"), real_cell(1), v[1]}}};
}

Table counts_data() {
  std::vector<Alpha> steps = thresholds_above(0.01);
  steps.insert(steps.begin(), 2.0);
  steps.emplace_back(0.01);
  std::ranges::reverse(steps);
  return table_of({"alpha", "N_A", "N_B"}, steps, [](const Alpha& alpha) {
    return concatenated({{real_cell(nearest(alpha))}, count_cells(count_collisions(alpha))});
  });
}

/// Places of A, C, B from collision to collision, one panel after the other.
Table trajectories_data() {
  Table table{{"panel", "t", "x_A", "x_C", "x_B"}, {}};
  // A and C are a length apart, so that the first collision is at time 0 of the paper.
  const std::string rest = "\"\npositions = [-1, 0, 1]\nuntil = 6\n";
  for (const auto& [panel, alpha] : {std::pair{"a", "magic:3"}, {"b", "12/100"}, {"c", "10/100"}})
    for (const auto& place : places("alpha = \"" + (alpha + rest), -1))
      table.rows.push_back(concatenated({{text_cell(panel)}, real_cells(place)}));
  return table;
}

Table terminal_data() {
  return table_of({"alpha", "a_t", "b_t", "c_t"}, alphas(), [](const Alpha& alpha) {
    const LargeCounts counts = count_collisions(alpha);
    const Row v = rounded([&] { return terminal(alpha, counts); });
    return Row{real_cell(nearest(alpha)), v[0], v[1], v[2]};
  });
}

Table transmission_data() {
  const Names columns{"alpha", "rho_1", "rho_0.9", "rho_0.8", "rho_0.7"};
  return table_of(columns, alphas(), [](const Alpha& alpha) {
    Row row{real_cell(nearest(alpha))};
    for (const int tenths : {10, 9, 8, 7}) row.push_back(rho(alpha, cln::cl_RA(tenths) / 10));
    return row;
  });
}

Table velocities_data() {
  const Alpha alpha = cln::cl_RA(1) / 1000;
  Table table{{"n", "a", "b", "c", "c_prime"}, {}};
  for (int n = 0; n <= count_collisions(alpha).N_A; ++n)
    table.rows.push_back(
        concatenated({{whole_cell(n)}, rounded([&] { return velocities(alpha, n); })}));
  return table;
}

/// V_n at alpha_5, then the circle on which they lie.
Table sphere_data() {
  constexpr int cycles = 5;
  constexpr int steps = 24;  // from one V_n to the next
  Table table{{"part", "n", "a", "b", "sqrt_alpha_c_prime"}, {}};
  const auto add = [&](const char* part, const cln::cl_RA& n) {
    Row row = rounded([&] {
      const Ball alpha = ball_of(magic(cycles));
      // Far from 0 each: what is 0 has no nearest double that digits could show.
      const Ball shift = 4;
      return Balls{n, right_side_at("power.a", alpha, n) + shift,
                   right_side_at("power.b", alpha, n) + shift,
                   sqrt(alpha) * right_side_at("power.c_prime", alpha, n) + shift};
    });
    for (std::size_t i = 1; i < row.size(); ++i) row[i] = real_cell(std::stod(row[i].text) - 4);
    table.rows.push_back(concatenated({{text_cell(part)}, row}));
  };
  for (int n = 0; n <= cycles; ++n) add("V_n", n);
  for (int i = 0; i <= (2 * cycles + 1) * steps; ++i) add("circle", cln::cl_RA(i) / steps);
  return table;
}

/// Distance of A and B at each collision, and the direction of its ray in the unfolded wedge.
Table wedge_data() {
  Table table{{"collision", "t", "s", "angle"}, {}};
  const Trio trio = Trio::equal_blocks(value_of(magic(3)), value_of(1));
  for (std::int64_t j = 0; j < trio.count(); ++j) {
    const std::string name = (j % 2 == 0 ? "P_" : "Q_") + std::to_string(j / 2 + 1);
    const auto balls = [&] {
      const Ball time = trio.collision(trio.shape(), j).time;
      const Balls places = trio.places(trio.shape(), time, j + 1);
      const Ball psi = right_side_at("rotation.psi", ball_of(magic(3)));
      return Balls{time, places[2] - places[0], psi * Ball(cln::cl_RA(j + 1) / 2)};
    };
    table.rows.push_back(concatenated({{text_cell(name)}, rounded(balls)}));
  }
  return table;
}

/// A block and the ball between it and a wall, from collision to collision; they touch at time 0.
Table way_data() {
  return table_of({"t", "x_block", "x_ball"},
                  places("kind = \"wall\"\nmass_ratio = 100\nuntil = 3\n", 0), real_cells);
}

/// Five blocks and four balls at magic ratios, from collision to collision, there and back.
Table cradle_data() {
  return table_of(
      {"t", "x_A1", "x_C1", "x_A2", "x_C2", "x_A3", "x_C3", "x_A4", "x_C4", "x_A5"},
      places("kind = \"chain\"\n"
             "masses = [1, \"magic:1\", 1, \"magic:2\", 1, \"magic:3\", 1, \"magic:4\", 1]\n"
             "positions = [-1, 0, 1, 2, 3, 4, 5, 6, 7]\n"
             "velocities = [1, 0, 0, 0, 0, 0, 0, 0, 0]\n"
             "right_wall = 8\nuntil = 20\n",
             -1),
      real_cells);
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{{"setup", setup_data},
                                       {"counts", counts_data},
                                       {"trajectories", trajectories_data},
                                       {"terminal", terminal_data},
                                       {"transmission", transmission_data},
                                       {"velocities", velocities_data},
                                       {"sphere", sphere_data},
                                       {"wedge", wedge_data},
                                       {"way", way_data},
                                       {"cradle", cradle_data}};
  return all;
}

}  // namespace answers
