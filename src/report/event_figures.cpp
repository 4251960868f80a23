// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/event_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "magicmass/reference/exact_line.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/simulator/line_motion.hpp"
#include "magicmass/simulator/trio_stepping.hpp"
#include "report/portable_random.hpp"
#include "report/statistics.hpp"

namespace magicmass::report {
namespace {

constexpr std::int64_t contacts_at_once = 1 << 20;
constexpr std::size_t events_at_once = 1 << 14;
constexpr double very_light = 1e-24;  // 2 * 10^12 contacts: no run sees the last one

/// Three bodies on and on.
Timed velocities_alone() {
  return {
      on_steady_clock([trio = trio_of(very_light), v = BodyVelocities<double>{1, 0, 0}]() mutable {
        step_trio(trio, v, contacts_at_once);
      }),
      static_cast<double>(contacts_at_once)};
}

Timed with_places() {
  struct State {
    BodyVelocities<double> v{1, 0, 0};
    TrioPlace<double> place{0, 0, 1};
    double sum = 0.0;  // of all times and places, which therefore have to be worked out
  };
  const auto state = std::make_shared<State>();
  return {on_steady_clock([trio = trio_of(very_light), state] {
            state->place = {0, 0, 1};
            state->v = {1, 0, 0};
            step_trio(trio, state->v, state->place, contacts_at_once,
                      [&](std::int64_t, const TrioPlace<double>& at,
                          const BodyVelocities<double>&) { state->sum += at.time + at.ball; });
          }),
          static_cast<double>(contacts_at_once)};
}

Timed chain(std::size_t blocks) {
  const auto motion = std::make_shared<LineMotion<double>>(busy_chain(blocks));
  const std::size_t events = std::max(events_at_once, motion->bodies());
  return {on_steady_clock([motion, events] {
            for (std::size_t i = 0; i < events; ++i) motion->step();
          }),
          static_cast<double>(events)};
}

double millions(double ns) { return 1e3 / ns; }

}  // namespace

Line<double> busy_chain(std::size_t blocks) {
  PortableRandom random(7);
  Line<double> line;
  for (std::size_t i = 0; i + 1 < 2 * blocks; ++i) {
    line.masses.push_back(i % 2 == 0 ? 1.0 : 0.3);
    line.positions.push_back(static_cast<double>(i) + random.log_uniform(0.1, 0.9));
    line.velocities.push_back(random.log_uniform(0.1, 1.0) * (random.next() % 2 == 0 ? 1.0 : -1.0));
  }
  line.left_wall = -1.0;
  line.right_wall = static_cast<double>(2 * blocks);
  return line;
}

double bytes_a_body(std::size_t blocks) {
  const Scene scene =
      parse_scene(fmt::format("kind = \"chain\"\nblocks = {}\nballs = 0.3", blocks), "chain");
  const reference::ExactLine line = reference::exact_line(scene);
  const LineMotion<double> motion(reference::rounded(line));
  const std::size_t bytes = motion.bytes() + scene.masses.capacity() * sizeof(Value) +
                            line.masses.capacity() * sizeof(reference::ExactValue);
  return static_cast<double>(bytes) / static_cast<double>(motion.bodies());
}

std::vector<EventFigure> event_figures(const Plan& plan) {
  Group group{velocities_alone(), with_places()};
  std::vector<std::size_t> sizes;
  for (std::size_t blocks = 10; blocks <= 100000; blocks *= 10) {
    sizes.push_back(blocks);
    group.push_back(chain(blocks));
  }
  const RoundTimes times = interleaved_rounds({group}, plan);
  std::vector<double> ns;
  for (const std::vector<double>& rounds : times.front()) {
    if (rounds.empty()) return {};
    ns.push_back(*std::min_element(rounds.begin(), rounds.end()));
  }
  std::vector<Point> points, against_bodies;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto bodies = static_cast<double>(2 * sizes[i] - 1);
    points.push_back({std::log(bodies), ns[2 + i]});
    against_bodies.push_back({bodies, ns[2 + i]});
  }
  const double largest = 2.0 * static_cast<double>(sizes.back()) - 1;
  return {
      {events::velocities, millions(ns[0])},
      {events::places, millions(ns[1])},
      {events::short_chain, millions(ns[4]), fmt::format("{} bodies", 2 * sizes[2] - 1)},
      {events::long_chain, millions(ns[6]), fmt::format("{} bodies", largest)},
      {events::memory, bytes_a_body(sizes.back()), "the engine's and its scene's, 199999 bodies"},
      {events::growth, fit_power_law(points).value().exponent,
       fmt::format("{} to {} bodies; as a power of their number, {:.2f}", 2 * sizes[0] - 1, largest,
                   fit_power_law(against_bodies).value().exponent)}};
}

}  // namespace magicmass::report
