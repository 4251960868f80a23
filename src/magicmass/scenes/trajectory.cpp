// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/trajectory.hpp"

#include <algorithm>

#include "magicmass/scenes/theorem.hpp"

namespace magicmass::scenes {
namespace {

using Points = std::function<void(const Point&)>;

template <class Scalar>
void follow(const Scene& scene, const Result& result, const Points& sink) {
  simulator::Line<Scalar> line = line_of<Scalar>(scene);
  std::vector<Scalar> since(line.masses.size(), Scalar(0)), times;
  for (const Value& time : scene.times) times.push_back(number_of<Scalar>(time));
  std::sort(times.begin(), times.end());
  auto next = times.begin();
  const auto all_at = [&](const Scalar& time) {
    for (std::size_t i = 0; i < since.size(); ++i)
      sink({time, i, line.positions[i] + line.velocities[i] * (time - since[i])});
  };
  const bool has_corners = times.empty();
  Scalar last(0);
  if (has_corners) all_at(last);
  stream(scene, result.plan, [&](const Row& row) {
    last = std::get<Scalar>(row.time);
    for (; next != times.end() && *next < last; ++next) all_at(*next);
    const bool is_shown = has_corners && row.number % scene.every == 0;
    const auto meets = [&](std::size_t body, const Number& velocity) {
      since[body] = last;
      line.positions[body] = std::get<Scalar>(row.position);
      line.velocities[body] = std::get<Scalar>(velocity);
      if (is_shown) sink({row.time, body, row.position});
    };
    if (row.gap > 0) meets(row.gap - 1, row.v_left);
    if (row.gap < since.size()) meets(row.gap, row.v_right);
  });
  const auto end = result.known_until;
  for (; next != times.end() && !(end && std::get<Scalar>(*end) < *next); ++next) all_at(*next);
  if (has_corners) all_at(end ? std::get<Scalar>(*end) : last);
}

/// Without all collisions before them.
void follow_by_theorem(const Scene& scene, const Result& result, const Points& sink) {
  std::vector<Value> times = scene.times;
  std::ranges::stable_sort(times, {}, &Value::to_double);
  for (const Value& at : times) {
    const double time = at.to_double();
    if (result.known_until && time > std::get<double>(*result.known_until)) return;
    std::size_t body = 0;
    for (const double place : places_by_theorem(scene, result.events, at))
      sink({time, body++, place});
  }
}

}  // namespace

void trajectory(const Scene& scene, const Result& result, const Points& sink) {
  if (result.plan.is_exact)
    follow<Quadratic>(scene, result, sink);
  else if (result.plan.model != "events" && result.status != Status::collapse &&
           !scene.times.empty())
    follow_by_theorem(scene, result, sink);
  else
    follow<double>(scene, result, sink);
}

}  // namespace magicmass::scenes
