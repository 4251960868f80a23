// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/run.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <span>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/scenes/theorem.hpp"

namespace magicmass::scenes {
namespace {

using simulator::Collision;
using simulator::Engine;

constexpr std::int64_t events_unless_told = 1'000'000;
constexpr std::size_t most_bits = 1U << 17U;
constexpr double most_work = 5e8;  // some five seconds where exact numbers are asked for
constexpr double some_work = 1e8;  // where they are only tried

std::int64_t most_events(const Scene& scene) {
  return scene.max_events.value_or(events_unless_told);
}

const char* const at_until = "the scene ends at the time `until`";
std::string at_limit(std::int64_t limit) {
  return "stopped after " + std::to_string(limit) + " collisions; more with --max-events";
}

/// Refuses numbers that grow too long; multiplying takes more than the length.
class Lengths {
public:
  Lengths(double most, std::size_t bodies)
      : most_(most), comparisons_(1 + static_cast<double>(std::bit_width(bodies) / 4)) {}
  void look([[maybe_unused]] const Collision<double>& event) {}
  void look(const Collision<Quadratic>& event) {
    const std::size_t bits = std::max(event.time.bits(), event.v_right.bits());
    const auto length = static_cast<double>(bits);
    work_ += comparisons_ * (2000 + length * (1 + length / 2000));
    if (bits <= most_bits && work_ <= most_) return;
    throw Undecided("exact numbers have " + std::to_string(bits) + " bits after " +
                    std::to_string(event.number) + " collisions, more than are taken; at most " +
                    std::to_string(event.number - 1) + " collisions are possible exactly");
  }

private:
  double most_;
  double comparisons_;  // of times, in a tournament of so many bodies
  double work_ = 0;
};

/// Why a motion ended where it did, if nothing stopped it, and whether more is to come.
template <class Scalar>
void decide_status(const Engine<Scalar>& engine, Result& result) {
  if (result.why.empty() && std::floating_point<Scalar> && engine.has_lost())
    result.why = "bodies have become too slow for doubles";
  if (result.why.empty() && result.ties.near > 0) {
    result.why = "decisions closer than doubles can tell: " + std::to_string(result.ties.near) +
                 ", the first after collision " + std::to_string(result.ties.first_near);
  }
  result.status = result.why.empty() ? Status::complete : Status::limited;
}

template <class Scalar>
Result motion(const Scene& scene, std::int64_t limit, const Sink& sink = {},
              double work = most_work) {
  std::optional<Scalar> until;
  if (scene.until) until = number_of<Scalar>(*scene.until);
  Engine<Scalar> engine(line_of<Scalar>(scene));
  Lengths lengths(work, scene.masses.size());
  Result result;
  result.counts.resize(scene.masses.size() + 1);
  const Scalar before = simulator::kinetic_energy<Scalar>(engine.bodies());
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
  }
  for (const auto& body : engine.bodies()) result.terminal.emplace_back(body.velocity);
  result.energy = simulator::kinetic_energy<Scalar>(engine.bodies());
  result.energy_before = before;
  const Scalar last = simulator::kinetic_energy<Scalar>(std::span(&engine.bodies().back(), 1));
  result.transmitted = before == Scalar(0) ? before : Scalar(last / before);
  result.ties = engine.ties();
  decide_status(engine, result);
  return result;
}

/// Few collisions are also had exactly, sooner than their theorem's balls.
constexpr std::int64_t few = 64;

/// One triple; nothing where it is cut off or stepped exactly.
std::optional<Result> theorem(const Scene& scene, bool has_exact) {
  const auto trio = Seen<Trio>::of(scene);
  if (!trio || scene.until) return {};
  const auto N = trio->motion.count();
  if (N && (scene.is_exact || scene.max_events.value_or(*N) < *N)) return {};
  const bool is_exact = N && has_exact && *N <= few;
  Result result = is_exact ? motion<Quadratic>(scene, few) : trio->after(N);
  result.plan = {"theorem", is_exact, "one body meets a ball at rest before a block or a wall"};
  return result;
}

/// How many collisions of a cradle are within the scene's limits.
std::int64_t within(const Cradle& cradle, const Scene& scene) {
  const std::int64_t limit = most_events(scene);
  const std::int64_t most = std::min(cradle.count().value_or(limit), limit);
  return scene.until ? cradle.count_until(*scene.until->exact(), most) : most;
}

/// One triple after the other; nothing where it is stepped exactly.
std::optional<Result> transfers(const Scene& scene, bool has_exact) try {
  const auto cradle = scene.is_exact ? std::nullopt : Seen<Cradle>::of(scene);
  if (!cradle) return {};
  const std::int64_t limit = most_events(scene), events = within(cradle->motion, scene);
  const bool is_exact = has_exact && events <= few;
  Result result = is_exact ? motion<Quadratic>(scene, limit) : cradle->after(events);
  if (!is_exact && cradle->motion.count() != events) {
    const bool is_limit = events == limit;
    result.status = Status::limited;
    result.why = is_limit ? at_limit(limit) : at_until;
    result.known_until =
        is_limit ? time_by_theorem(cradle->motion, events) : scene.until->to_double();
  }
  result.plan = {"transfers", is_exact,
                 "a cradle: each ball of a magic ratio hands on all to the next block"};
  return result;
} catch (const Undecided&) {
  return {};
}

/// The models of theorems; nothing where none serves.
std::optional<Result> solved(const Scene& scene, bool has_exact) try {
  if (auto result = theorem(scene, has_exact)) return result;
  return transfers(scene, has_exact);
} catch (const std::domain_error&) {
  return {};
}

}  // namespace

std::optional<double> double_of(const Number& number) {
  const auto* value = std::get_if<double>(&number);
  return value != nullptr ? std::optional(*value) : std::get<Quadratic>(number).to_double();
}

std::string status_name(Status status) {
  constexpr std::array names{"complete", "limited", "collapse"};
  return names[static_cast<std::size_t>(status)];
}

Result run(const Scene& scene) {
  const bool has_exact = has_exact_numbers(scene);
  const std::int64_t limit = most_events(scene);
  if (auto result = solved(scene, has_exact)) return *result;
  if (scene.is_exact && !has_exact) {
    throw InvalidInput(scene.source +
                       ": --exact: values that are not of one quadratic field; "
                       "allowed: fractions and one square root");
  }
  if (scene.is_exact) {
    Result result = motion<Quadratic>(scene, limit);
    result.plan = {"events", true, "exact numbers are asked for"};
    return result;
  }
  Result result = motion<double>(scene, limit);
  result.plan = {"events", false, "no decision is closer than doubles can tell"};
  if (result.ties.near == 0) return result;
  const std::string close = "decisions are closer than doubles can tell";
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

void stream(const Scene& scene, const Plan& plan, const Sink& sink) {
  constexpr std::int64_t many = 100'000;  // from here on stepping in doubles is worth its error
  std::int64_t limit = most_events(scene);
  if (plan.is_exact) return void(motion<Quadratic>(scene, limit, sink));
  if (plan.model == "transfers") {
    const auto cradle = Seen<Cradle>::of(scene);
    return cradle->stream(within(cradle->motion, scene), sink);
  }
  if (plan.model == "theorem") {
    const auto trio = Seen<Trio>::of(scene);
    const auto N = trio->motion.count();
    if (N && *N <= many) return trio->stream(*N, sink);
    limit = N.value_or(limit);
  }
  motion<double>(scene, limit, sink);
}

}  // namespace magicmass::scenes
