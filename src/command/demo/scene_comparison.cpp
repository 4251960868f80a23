// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <string>

#include <cln/cln.h>
#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/data_folder.hpp"
#include "command/demo/demo_report.hpp"
#include "command/scene_run.hpp"
#include "magicmass/encounters_exact.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "magicmass/velocities_exact.hpp"

namespace magicmass::command {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// Times, distances and velocities of all events in exact rationals are those of the theorems.
bool events_are_the_theorems(const cl_RA& alpha, const RecordedRun<cl_RA>& recorded) {
  cl_I j(0);
  for (const Event<cl_RA>& event : recorded.events) {
    const auto encounter = generated::encounters_exact<cl_RA, cl_I>(alpha, j);
    const auto v = generated::velocities_exact<cl_RA, cl_I>(alpha, cl_I(event.n));
    const bool with_A = event.body == Body::A;
    const bool same_velocities = with_A ? event.after.a == v.a && event.after.c == v.c
                                        : event.after.b == v.b && event.after.c == v.c_prime;
    const cl_RA distance = event.positions.b - event.positions.a;
    if (!same_velocities || event.time != encounter.t || distance != encounter.s) return false;
    j = j + 1;
  }
  return true;
}

/// Largest difference between velocities of the double and the exact event loop, in eps.
double difference_in_eps(const RecordedRun<double>& doubles, const RecordedRun<cl_RA>& exact) {
  double largest = 0.0;
  const auto look = [&](double got, const cl_RA& expected) {
    const double error = cln::double_approx(reference::exact(got) - expected);
    largest = std::max(largest, std::abs(error) / std::numeric_limits<double>::epsilon());
  };
  for (std::size_t i = 0; i < std::min(doubles.events.size(), exact.events.size()); ++i) {
    look(doubles.events[i].after.a, exact.events[i].after.a);
    look(doubles.events[i].after.b, exact.events[i].after.b);
    look(doubles.events[i].after.c, exact.events[i].after.c);
  }
  return largest;
}

constexpr double figure_end =
    5.5;  // in L/V; after the last collision and one L/V more of each scene

/// The scene's trajectory, and where the bodies are at the figure's right edge.
void save_trajectory(const SceneResult& result, const ThreeBodyRun<double>& run,
                     const std::filesystem::path& path) {
  Destination file(path.string());
  file.write(fmt::format("{}\n", fmt::join(trajectory_columns, ",")));
  for (const std::vector<Cell>& point : result.trajectory) file.write(csv_line(point));
  const BodyPositions<double>& x = run.last_positions;
  const BodyVelocities<double>& v = run.terminal;
  const double rest =
      figure_end - run.last_time;  // all three move freely from the last collision on
  file.write(csv_line({number_cell(figure_end), number_cell(x.a + v.a * rest),
                       number_cell(x.b + v.b * rest), number_cell(x.c + v.c * rest)}));
  file.finish();
}

std::string counts_text(const Counts& counts) {
  return fmt::format("{} + {}", counts.N_A, counts.N_B);
}

void show_scene(DemoReport& report, const std::string& panel, const std::filesystem::path& folder) {
  const std::string name = "trajectory_" + panel;
  const Scene scene =
      read_scene((data_folder("scenes", "tutorials/scenes") / (name + ".toml")).string());
  const SceneResult result = run_scene(scene, {});

  const double alpha = nearest_double(*scene.alpha);
  const cl_RA exact_alpha = reference::exact(alpha);
  const RecordedRun<double> doubles = record_three_body(alpha);
  const RecordedRun<cl_RA> exact = record_three_body(exact_alpha);
  save_trajectory(result, doubles.run, folder / (name + ".csv"));
  const Counts stepped = doubles.run.counts;
  const bool counts_agree =
      result.counts.N_A == cl_I(stepped.N_A) && result.counts.N_B == cl_I(stepped.N_B);
  const bool are_theorems = events_are_the_theorems(exact_alpha, exact);
  report.count_in(counts_agree && are_theorems);
  const auto& v = doubles.run.terminal;
  const auto shown = [](double value) {
    return fmt::format("{:.6f}", std::abs(value) < 5e-7 ? 0.0 : value);
  };
  report.print(fmt::format(
      " {:<3}{:<9}{:>7}{:>7}{:>11}{:>10}{:>10}{:>11}   {}\n", panel, to_text(*scene.alpha),
      reference::to_text(result.counts.N_A) + " + " + reference::to_text(result.counts.N_B),
      counts_text(stepped), shown(v.a), shown(v.b), shown(v.c),
      fmt::format("{:.1f} eps", difference_in_eps(doubles, exact)),
      !are_theorems  ? "FAILED"
      : counts_agree ? "ok"
                     : "COUNT"));
}

}  // namespace

void show_scenes(DemoReport& report, const std::filesystem::path& folder) {
  report.heading("The paper's trajectories, event by event");
  report.print(
      "N_A + N_B by the exact count (at alpha as written) and by stepping (in doubles);\n"
      "terminal velocities in V; the doubles' largest error; ok: the events in exact\n"
      "rationals have the theorems' velocities, times and distances, digit for digit.\n");
  report.print(fmt::format(" {:<3}{:<9}{:>7}{:>7}{:>11}{:>10}{:>10}{:>11}   {}\n", "", "alpha",
                           "exact", "step", "a_t", "b_t", "c_t", "error", "exact"));
  for (const char* panel : {"a", "b", "c"}) show_scene(report, panel, folder);
}

}  // namespace magicmass::command
