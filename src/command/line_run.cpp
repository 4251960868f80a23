// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/line_run.hpp"

#include <algorithm>
#include <concepts>
#include <limits>

#include "command/line_events.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/line_plan.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/transfers.hpp"
#include "magicmass/simulator/trio_stepping.hpp"

namespace magicmass::command {

const std::vector<std::string> line_event_columns = {"number",   "left",   "right",  "time",
                                                     "position", "v_left", "v_right"};
const std::vector<std::string> line_point_columns = {"t", "body", "x"};

namespace {

using cln::cl_I;
using cln::cl_RA;
using reference::ExactLine;
using reference::FieldNumber;

Cell count_cell(const cl_I& count) { return digits_cell(reference::to_text(count)); }

std::vector<Cell> counts_of(const cl_I& contacts) {
  return {count_cell(cln::ceiling1(contacts, 2)), count_cell(cln::floor1(contacts, 2))};
}

/// From left to right.
template <class Float>
std::vector<Float> in_order(const Scene& scene, const BodyVelocities<Float>& v) {
  return scene.masses.size() == 2 ? std::vector{v.a, v.c} : std::vector{v.a, v.c, v.b};
}

template <class Float>
std::vector<Cell> velocity_cells(const std::vector<Float>& velocities) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < std::min(velocities.size(), most_velocities); ++i)
    cells.push_back(number_cell(velocities[i]));
  return cells;
}

/// Each so manieth event, from the powers of a cycle's map.
void list_thinned(const Scene& scene, const reference::TrioEnd& end, std::int64_t limit,
                  const LineListener& listener, LineResult& result) {
  std::int64_t rows = 0;
  for (cl_I j = scene.every; j <= end.contacts(); j = j + scene.every) {
    if (rows++ >= limit) {
      result.status = "limited";
      result.why = "as many events were printed as the limit allows";
      return;
    }
    const auto at = end.contact(j - 1);
    const bool with_A = cln::oddp(j);
    const std::string left = with_A ? "A" : "C";
    const std::string right = with_A ? "C" : scene.masses.size() == 2 ? "wall" : "B";
    result.evaluated += 4;
    if (wants(scene, Output::events))
      listener.on_event({count_cell(j), text_cell(left), text_cell(right), number_cell(at.time),
                         number_cell(at.position), number_cell(with_A ? at.after.a : at.after.c),
                         number_cell(with_A ? at.after.c : at.after.b)});
    if (wants(scene, Output::trajectory)) {
      listener.on_point({number_cell(at.time), text_cell(left), number_cell(at.position)});
      if (right != "wall")
        listener.on_point({number_cell(at.time), text_cell(right), number_cell(at.position)});
    }
  }
}

void closed_form(const Scene& scene, const ExactLine& line, const reference::TrioEnd& end,
                 std::int64_t limit, const LineListener& listener, LineResult& result) {
  if (end.collapse()) {
    result.status = "collapse";
    result.collapse = {number_cell(end.collapse()->time), number_cell(end.collapse()->position)};
    result.contacts = missing_cell();
    return;
  }
  result.contacts = count_cell(end.contacts());
  result.counts = counts_of(end.contacts());
  if (wants(scene, Output::terminal) || wants(scene, Output::energy)) {
    const std::vector<double> v = in_order(scene, end.velocities(end.contacts()));
    result.velocities = velocity_cells(v);
    result.evaluated += static_cast<std::int64_t>(result.velocities.size());
    if (wants(scene, Output::energy)) result.drift = drift_of(reference::rounded(line), v);
  }
  std::vector<FieldNumber> times = line.times;
  std::sort(times.begin(), times.end(), [](const auto& x, const auto& y) { return x < y; });
  for (const FieldNumber& one : times) {
    const BodyPositions<double> x = end.positions(one);
    const Cell time = number_cell(reference::nearest_double(one));
    const std::vector<double> places = {x.a, x.c, x.b};
    for (std::size_t body = 0; body < scene.masses.size(); ++body)
      listener.on_point({time, text_cell(body_name(scene, body)), number_cell(places[body])});
    result.evaluated += static_cast<std::int64_t>(scene.masses.size());
  }
  if (scene.every > 1) list_thinned(scene, end, limit, listener, result);
}

template <std::floating_point Scalar>
void step_velocities_alone(const Scene& scene, const Line<Scalar>& line,
                           const reference::TrioEnd& end, std::int64_t limit, LineResult& result) {
  BodyVelocities<Scalar> v = trio_velocities(line);
  // At a threshold rounding lets a pair that parts with speed 0 approach: the exact number ends the run.
  const bool has_end = !end.collapse() && end.contacts() <= cl_I(static_cast<long>(limit));
  result.stepped = step_trio(trio_of(line), v, has_end ? cln::cl_I_to_long(end.contacts()) : limit);
  if (!has_end && approach(v, result.stepped)) {
    result.status = "limited";
    result.why = "as many events as the limit allows";
  }
  result.contacts = count_cell(cl_I(static_cast<long>(result.stepped)));
  result.counts = counts_of(cl_I(static_cast<long>(result.stepped)));
  result.velocities = velocity_cells(in_order(scene, v));
  if (wants(scene, Output::energy)) result.drift = drift_of(line, in_order(scene, v));
}

void by_transfers(const Scene& scene, const ExactLine& line, std::int64_t limit,
                  LineResult& result) {
  const reference::CradleEnd end = reference::run_cradle(line, limit);
  if (!end.complete) {
    result.status = "limited";
    result.why = "the next transfer is beyond the limit";
  }
  result.contacts = count_cell(end.contacts);
  result.cradle = {count_cell(end.transfers), count_cell(end.round_trips),
                   text_cell(body_name(scene, end.mover))};
  const Line<double> start = reference::rounded(line);
  std::vector<double> velocities(start.bodies(), 0.0);
  velocities[end.mover] = end.direction * start.velocities[0];
  result.velocities = velocity_cells(velocities);
  if (wants(scene, Output::energy)) result.drift = drift_of(start, std::move(velocities));
}

/// Numbers of one field as rationals.
Line<cl_RA> as_rationals(const Line<FieldNumber>& line) {
  return converted<cl_RA>(line, [](const FieldNumber& x) { return x.rational(); });
}

}  // namespace

LineResult run_line(const Scene& scene, const ExactLine& line,
                    const reference::SceneOptions& options, const LineListener& listener) {
  LineResult result;
  result.status = "complete";
  const reference::LinePlan plan = reference::plan_line(scene, line, options);
  result.plan = plan.plan;
  result.fractions = options.scalars == reference::Scalars::exact || !options.model.empty();
  const bool wide = options.scalars == reference::Scalars::long_doubles;
  const std::int64_t limit = reference::event_limit(scene, options);
  switch (plan.model) {
    case reference::Model::closed_form:
      closed_form(scene, line, *plan.end, limit, listener, result);
      return result;
    case reference::Model::velocity_stepping:
      if (wide)
        step_velocities_alone(scene, reference::rounded<long double>(line), *plan.end, limit,
                              result);
      else
        step_velocities_alone(scene, reference::rounded(line), *plan.end, limit, result);
      return result;
    case reference::Model::transfers:
      by_transfers(scene, line, limit, result);
      return result;
    case reference::Model::event_driven:
      if (wide)
        step_line(scene, line, reference::rounded<long double>(line), limit, listener, result);
      else
        step_line(scene, line, reference::rounded(line), limit, listener, result);
      break;
    case reference::Model::exact_events:
      if (line.is_rational())
        step_line(scene, line, as_rationals(line.together()), limit, listener, result);
      else
        step_line(scene, line, line.together(), limit, listener, result);
      break;
  }
  // What was stepped into a collapse that a theorem knows is told by the theorem.
  if (plan.end && plan.end->collapse()) {
    const auto& [time, position] = *plan.end->collapse();
    result.status = "collapse";
    result.why = "";
    result.collapse = {number_cell(time), number_cell(position)};
  }
  return result;
}

}  // namespace magicmass::command
