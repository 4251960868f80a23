// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/scene_run.hpp"

#include <limits>

#include <cln/cln.h>

#include "command/alpha_value.hpp"
#include "command/velocity_tiers.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/line_plan.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/three_body.hpp"

namespace magicmass::command {

const std::vector<std::string> event_columns = {"body", "n", "time", "position", "a", "b", "c"};
const std::vector<std::string> trajectory_columns = {"t", "x_A", "x_B", "x_C"};

namespace {

using cln::cl_I;
using cln::cl_RA;

Cell cell(double value) { return number_cell(value); }
Cell cell(const cl_RA& value) { return text_cell(reference::to_text(value)); }

template <class Scalar>
std::vector<Cell> event_cells(const Event<Scalar>& event) {
  return {text_cell(event.body == Body::A ? "A" : "B"),
          number_cell(event.n),
          cell(event.time),
          cell(event.position),
          cell(event.after.a),
          cell(event.after.b),
          cell(event.after.c)};
}

template <class Scalar>
std::vector<Cell> trajectory_cells(const Scalar& time, const BodyPositions<Scalar>& x) {
  return {cell(time), cell(x.a), cell(x.b), cell(x.c)};
}

/// Numbers in which a scene is computed.
template <class Scalar>
struct SceneNumbers {
  Scalar alpha, V, L;
};

template <class Scalar>
void run_events(const Scene& scene, const SceneNumbers<Scalar>& numbers, std::int64_t max_events,
                SceneResult& result) {
  const auto& [alpha, V, L] = numbers;
  const bool keeps_events = wants(scene, Output::events);
  const bool keeps_trajectory = wants(scene, Output::trajectory);
  const Scalar unit_time = L / V;
  const Scalar zero(0);
  if (keeps_trajectory)
    result.trajectory.push_back(trajectory_cells<Scalar>(zero - unit_time, {zero - L, L, zero}));
  // At a threshold rounding lets a pair that parts with speed 0 approach: the exact count ends the run.
  const cl_I all = result.counts.N_A + result.counts.N_B;
  const std::int64_t most = all < cl_I(max_events) ? cln::cl_I_to_long(all) : max_events;
  const ThreeBodyRun<Scalar> run =
      simulate_three_body(alpha, V, L, most, [&](const Event<Scalar>& event) {
        if (keeps_events) result.events.push_back(event_cells(event));
        if (keeps_trajectory)
          result.trajectory.push_back(trajectory_cells(event.time, event.positions));
      });
  result.stepped = reference::LargeCounts{run.counts.N_A, run.counts.N_B};
  result.drift = {cell(run.drift.energy), cell(run.drift.momentum)};
  if (run.status == RunStatus::limited && cl_I(run.counts.N_A + run.counts.N_B) < all) {
    result.status = "limited";
    return;
  }
  const auto& v = run.terminal;
  const Scalar share = v.b / V;
  result.terminal = {cell(v.a), cell(v.b), cell(v.c), cell(Scalar(share * share))};
  const auto& x = run.last_positions;
  if (keeps_trajectory)
    result.trajectory.push_back(trajectory_cells<Scalar>(
        run.last_time + unit_time,
        {x.a + v.a * unit_time, x.b + v.b * unit_time, x.c + v.c * unit_time}));
}

/// Terminal velocities from the generated formulas, no event stepped.
template <class Scalar>
void run_closed_form(const SceneNumbers<Scalar>& numbers, const Last<Scalar>& last,
                     SceneResult& result) {
  const auto& [alpha, V, L] = numbers;
  result.terminal = {cell(Scalar(last.a * V)), cell(Scalar(last.b * V)), cell(Scalar(last.c * V)),
                     cell(Scalar(last.b * last.b))};
  if (!result.drift.empty()) return;
  ConservationAudit<Scalar> audit(alpha, {Scalar(1), Scalar(0), Scalar(0)});
  audit.look({last.a, last.b, last.c});
  result.drift = {cell(audit.largest().energy), cell(audit.largest().momentum)};
}

/// Bits of all numbers that exact events print: each event makes them longer by about twice alpha's length.
void require_short(const cl_RA& alpha, const cl_I& events) {
  const auto bits =
      static_cast<long>(cln::integer_length(cln::numerator(alpha) + cln::denominator(alpha)));
  constexpr long longest = 1L << 31;
  if (events * events * 8 * cl_I(bits) > longest)
    throw Undecided("exact fractions of " + reference::to_text(events) +
                    " events would fill gigabytes; leave out --exact or lower --max-events");
}

}  // namespace

SceneResult run_scene(const Scene& scene, const reference::SceneOptions& options) {
  SceneResult result;
  result.status = "complete";
  result.counts = reference::count_collisions(*scene.alpha);
  result.plan = reference::plan_papers_scene(scene, options);
  const std::int64_t limit = reference::event_limit(scene, options);
  const bool steps_events = result.plan.model == "event-driven";
  if (steps_events && result.plan.events > cl_I(most_kept))
    throw InvalidInput("a table of " + reference::to_text(result.plan.events) +
                       " events is kept in memory; allowed: up to " + std::to_string(most_kept) +
                       ", --format jsonl, or --model event-driven with --format csv");
  if (options.scalars == reference::Scalars::exact) {
    const std::optional<cl_RA> alpha = reference::exact(*scene.alpha);
    if (!alpha)
      throw InvalidInput("--exact needs a rational alpha, got " + to_text(*scene.alpha) +
                         "; allowed: a decimal, a hex float or a fraction p/q");
    const SceneNumbers<cl_RA> numbers{*alpha, reference::exact(std::get<double>(scene.V)),
                                      reference::exact(std::get<double>(scene.L))};
    result.computed_alpha = cell(*alpha);
    if (steps_events) require_short(*alpha, result.plan.events);
    if (steps_events) run_events(scene, numbers, limit, result);
    if (result.terminal.empty() && result.status == "complete")
      run_closed_form(numbers, exact_terminal_velocities(*alpha, result.counts), result);
    return result;
  }
  const SceneNumbers<double> numbers{nearest_double(*scene.alpha), std::get<double>(scene.V),
                                     std::get<double>(scene.L)};
  result.computed_alpha = cell(numbers.alpha);
  if (steps_events) run_events(scene, numbers, limit, result);
  if (result.terminal.empty() && result.status == "complete")
    run_closed_form(numbers, fast_terminal_velocities(*scene.alpha, result.counts), result);
  return result;
}

}  // namespace magicmass::command
