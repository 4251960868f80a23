// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/run.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/scenes/theorem.hpp"

namespace magicmass::scenes {
namespace {

using simulator::Collision;
using simulator::Engine;

constexpr std::size_t most_bits = 1U << 17U;
constexpr double most_work = 5e8;  // some five seconds where exact numbers are asked for
constexpr double some_work = 1e8;  // where they are only tried

/// Refuses numbers that grow too long; multiplying takes more than the length.
struct Lengths {
  double most;
  double comparisons;  ///< of times, in a tournament of all gaps
  double work = 0;

  void look(const Collision<double>& event) {
    if (!std::isfinite(event.v_right - event.v_left))
      throw Undecided("the velocities after collision " + std::to_string(event.number) +
                      " do not fit a double");
  }
  void look(const Collision<Quadratic>& event) {
    const std::size_t bits = std::max(event.time.bits(), event.v_right.bits());
    const auto length = static_cast<double>(bits);
    work += comparisons * (2000 + length * (1 + length / 2000));
    if (bits <= most_bits && work <= most) return;
    throw Undecided("exact numbers become too long; possible with --max-events " +
                    std::to_string(event.number - 1));
  }
};

/// Exactly, of bodies in doubles too: it overflows where velocities do not.
template <class Scalar>
void set_energies(const Scene& scene, const simulator::Line<Scalar>& start, Result& result) {
  const auto energy = [&](std::size_t body, const Number& velocity) {
    const Quadratic v(std::get<Scalar>(velocity));
    return Quadratic(start.masses[body]) * v * v / 2;
  };
  Quadratic before = 0, after = 0;
  for (std::size_t i = 0; i < start.masses.size(); ++i) {
    before = before + energy(i, start.velocities[i]);
    after = after + energy(i, result.terminal[i]);
  }
  result.energy_before = before;
  result.energy = after;
  if (const auto last = scene.receiver())
    result.transmitted = energy(*last, result.terminal[*last]) / before;
}

const std::string close = "decisions are closer than doubles can tell";
const std::string too_slow = "bodies have become too slow for doubles";
/// Little more, and numbers would be subnormal.
bool is_too_slow(double v) { return v != 0 && std::abs(v) < 0x1p-1000; }
bool is_too_slow(const Quadratic& /*v*/) { return false; }

/// Whether rounding decided where the motion ends, and whether more is to come.
template <class Scalar>
void decide_status(const Engine<Scalar>& engine, Result& result) {
  std::string doubt;
  if (result.why.empty() && std::floating_point<Scalar> && engine.has_lost()) doubt = too_slow;
  if (engine.ties().near > 0)
    doubt = "uncertain after collision " + std::to_string(engine.ties().first_near) + ": " + close;
  result.is_undecided = !doubt.empty();
  if (!doubt.empty()) result.why = result.why.empty() ? doubt : result.why + "; " + doubt;
  result.status = result.why.empty() ? Status::complete : Status::limited;
}

template <class Scalar>
Result motion(const Scene& scene, std::int64_t limit, const Sink& sink = {},
              double work = most_work) {
  std::optional<Scalar> until;
  if (scene.until) until = number_of<Scalar>(*scene.until);
  const auto line = line_of<Scalar>(scene);
  Engine<Scalar> engine(line);
  Lengths lengths{work, 1 + static_cast<double>(std::bit_width(scene.masses.size()) / 4)};
  Result result;
  result.counts.resize(scene.masses.size() + 1);
  while (engine.next()) {
    if (until && !engine.is_due_by(*until)) {
      result.why = at_until;
      result.known_until = *until;
      break;
    }
    if (result.events == limit) {
      result.why = at_limit(limit);
      result.known_until = *engine.next();
      break;
    }
    const Collision<Scalar> event = engine.step();
    lengths.look(event);
    ++result.events;
    ++result.counts[event.gap];
    if (sink)
      sink({event.number, event.gap, event.time, event.position, event.v_left, event.v_right});
    if (is_too_slow(event.v_left) || is_too_slow(event.v_right)) {
      result.why = too_slow;
      result.known_until = event.time;
      break;
    }
  }
  for (const auto& body : engine.bodies()) result.terminal.emplace_back(body.velocity);
  set_energies(scene, line, result);
  decide_status(engine, result);
  if constexpr (std::floating_point<Scalar>)
    if (result.events > 0 && !result.is_undecided && std::isfinite(engine.errors().position))
      result.errors = engine.errors();
  return result;
}

/// Of a collapse, how many are told one by one.
std::int64_t told(const Scene& collapse) {
  std::int64_t rows = 0;
  stream_by_theorem(collapse, 1, [&](const Row&) { ++rows; });
  return rows;
}

/// What a collapse comes to in exact numbers, but for its time and place: momentum is kept.
Result exactly(const Scene& scene, Result result) {
  const auto line = line_of<Quadratic>(scene);
  const std::size_t bodies = line.masses.size();
  Quadratic mass = 0, momentum = 0;
  for (std::size_t i = 0; i < bodies; ++i) {
    mass = mass + line.masses[i];
    momentum = momentum + line.masses[i] * line.velocities[i];
  }
  result.terminal.assign(bodies, bodies == 2 ? Quadratic(0) : momentum / mass);  // 2: a wall
  set_energies(scene, line, result);
  result.known_until = motion<Quadratic>(scene, told(scene)).known_until;
  result.plan.is_exact = true;
  return result;
}

}  // namespace

std::optional<double> double_of(const Number& number) {
  const auto* value = std::get_if<double>(&number);
  if (value == nullptr) return std::get<Quadratic>(number).to_double();
  return *value == 0 || std::isnormal(*value) ? std::optional(*value) : std::nullopt;
}

std::string status_name(Status status) {
  constexpr std::array names{"complete", "limited", "collapse"};
  return names[static_cast<std::size_t>(status)];
}

Result run(const Scene& scene) {
  const bool has_exact = has_exact_numbers(scene);
  const std::int64_t limit = scene.limit();
  if (scene.is_exact && !has_exact) {
    throw InvalidInput(scene.source +
                       ": --exact: values that are not of one quadratic field; "
                       "allowed: fractions and one square root");
  }
  auto solved = by_theorem(scene);
  if (solved && !solved->plan.is_exact) {
    if (!scene.is_exact) return *solved;
    if (solved->status == Status::collapse) return exactly(scene, std::move(*solved));
  }
  if (solved || scene.is_exact) try {
      Result result = motion<Quadratic>(scene, limit);
      result.plan =
          scene.is_exact ? Plan{"events", true, "exact numbers are asked for"} : solved->plan;
      return result;
    } catch (const Undecided& error) {
      if (!solved || solved->plan.is_exact) throw;
      throw Undecided(std::to_string(solved->events) + " collisions by theorem, but " +
                      error.what() + ", or without --exact");
    }
  Result result = motion<double>(scene, limit);
  result.plan = {"events", false, "no decision is closer than doubles can tell"};
  if (!result.is_undecided) return result;
  result.plan.reason = close + "; the scene has no exact numbers";
  if (!has_exact) return result;
  try {
    result = motion<Quadratic>(scene, limit, {}, some_work);
    result.plan = {"events", true, close + ", exact numbers decide"};
  } catch (const Undecided& error) {
    result.plan.reason = close + "; " + error.what();
  }
  return result;
}

void stream(const Scene& scene, const Plan& plan, const Sink& sink, std::int64_t every) {
  const bool is_stepped = plan.model == "events";
  if (!is_stepped && !plan.is_exact) return stream_by_theorem(scene, every, sink);
  const std::int64_t limit = !is_stepped && scene.is_exact ? told(scene) : scene.limit();
  const auto show = [&](const Row& row) {
    if (row.number % every == 0) sink(row);
  };
  (plan.is_exact ? motion<Quadratic> : motion<double>)(scene, limit, show, most_work);
}

}  // namespace magicmass::scenes
