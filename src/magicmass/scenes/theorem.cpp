// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/theorem.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <utility>

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {
using Balls = std::function<std::vector<Ball>()>;

/// The even one of two neighbouring doubles, where low and high are by far closer than these and on
/// both sides of their middle.
std::optional<double> tie(const cln::cl_RA& low, const cln::cl_RA& high) {
  const auto below = nearest_double(low, low), above = nearest_double(high, high);
  if (!below || !above || std::nextafter(*below, *above) != *above) return {};
  const cln::cl_RA x = exact(*below), y = exact(*above), middle = (x + y) / 2;
  if ((high - low) * cln::ash(cln::cl_I(1), 300) > y - x) return {};
  return nearest_double(middle, middle);
}
/// Nearest doubles, ties to even as far as many bits tell; nothing where one is not certain. What
/// is too large is infinite, what is too small is subnormal: nothing for double_of().
std::optional<std::vector<double>> rounded(const Balls& balls) try {
  using Limits = std::numeric_limits<double>;
  const cln::cl_RA largest = exact(Limits::max());
  std::vector<double> all;
  for (const Ball& ball : balls()) {
    const cln::cl_RA low = ball.low(), high = ball.high();
    auto number = nearest_double(low, high);
    if (!number && Ball::bits() > 1500) number = tie(low, high);
    if (low > largest || high < -largest) number = Limits::infinity();
    if (!number) return {};
    if (*number == 0 && (low > 0 || high < 0)) number = Limits::denorm_min();
    all.push_back(*number);
  }
  return all;
} catch (const NotCertain&) {
  return {};
}
std::vector<double> certain(const Balls& balls) {
  return with_bits(17, [&] { return rounded(balls); });
}
Places mirrored(Places places) {
  std::reverse(places.masses.begin(), places.masses.end());
  places.line = simulator::mirrored(std::move(places.line));
  return places;
}
Ball energy(const std::vector<Ball>& masses, const std::vector<Ball>& velocities) {
  Ball sum = 0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    sum = sum + masses[i] * velocities[i] * velocities[i];
  return sum / Ball(2);
}
/// How many of the first `most` are by a time, which come one after the other.
template <class IsBy>
std::int64_t count_of(std::int64_t most, const IsBy& is_by) {
  std::int64_t count = 0, more = 1;
  const auto are_by = [&] { return count + more <= most && is_by(count + more - 1); };
  for (; are_by(); more *= 2) count += more;
  for (; more > 0; more /= 2)
    if (are_by()) count += more;
  return count;
}
/// A motion that theorems tell, or what a mirror shows of it; each number the nearest double.
template <class Motion>
struct Seen {
  Motion motion;
  bool is_mirrored;

  /// Nothing where the scene is neither.
  static std::optional<Seen> of(const Scene& scene) {
    const auto places = exact_places(scene);
    if (!places) return {};
    if (auto motion = Motion::of(*places)) return Seen{std::move(*motion), false};
    if (auto motion = Motion::of(mirrored(*places))) return Seen{std::move(*motion), true};
    return {};
  }
  /// Velocities or places of all bodies.
  std::vector<Ball> seen(std::vector<Ball> all) const {
    if (!is_mirrored) return all;
    std::reverse(all.begin(), all.end());
    for (Ball& x : all) x = -x;
    return all;
  }
  /// How many of the first `most` come by this time.
  std::int64_t count_until(const Value& time, std::int64_t most) const {
    const auto counted = [&] {
      const auto s = motion.shape();
      const Ball until = ball_of(time);
      return count_of(most, [&](std::int64_t j) {
        const auto exact = motion.exact_time(j);
        if (exact && time.exact() != nullptr) try {
            return !(*time.exact() < *exact);
          } catch (const std::domain_error&) {  // of two fields, so not equal
          }
        return motion.collision(s, j).time <= until;
      });
    };
    return with_bits(17, counted, " to tell whether a collision comes by the time " + time.text);
  }
  /// How many collisions are within the scene's limits; nothing: infinitely many, a collapse.
  std::optional<std::int64_t> within(const Scene& scene) const {
    auto N = motion.count();
    const bool is_collapse = std::same_as<Motion, Trio> && !N;
    const std::int64_t limit = std::min(scene.limit(), std::int64_t(1) << 62U);
    if (scene.max_events || (!N && !is_collapse)) N = std::min(N.value_or(limit), limit);
    if (!scene.until) return N;
    if constexpr (std::same_as<Motion, Trio>) {
      const auto collapses_by = [&] {
        return motion.collapse(motion.shape()).time <= ball_of(*scene.until);
      };
      if (is_collapse && with_bits(17, collapses_by)) return N;
    }
    return count_until(*scene.until, N.value_or(limit));
  }
  /// All but the plan after so many collisions, or after infinitely many.
  Result after(std::optional<std::int64_t> collisions) const {
    Result result;
    result.events = collisions.value_or(0);
    result.counts = motion.counts(result.events);
    if (is_mirrored) std::reverse(result.counts.begin(), result.counts.end());
    result.status = collisions ? Status::complete : Status::collapse;
    const std::size_t bodies = motion.bodies();
    const std::vector<double> numbers = certain([&] {
      const auto s = motion.shape();
      const std::vector<Ball> masses = motion.masses(s);
      std::vector<Ball> all = motion.velocities(s, result.events), end;
      if constexpr (std::same_as<Motion, Trio>) {
        if (!collisions) {
          const Trio::Collapse c = motion.collapse(s);
          all.assign(bodies, c.velocity);
          end = {c.time, is_mirrored ? -c.position : c.position};
        }
      }
      const Ball before = energy(masses, motion.velocities(s, 0)), after = energy(masses, all);
      const Ball of_last = energy({masses.back()}, {all.back()});
      all = seen(std::move(all));
      all.insert(all.end(), {before, after, of_last / before});
      all.insert(all.end(), end.begin(), end.end());
      return all;
    });
    const auto next = numbers.begin() + static_cast<std::ptrdiff_t>(bodies);
    result.terminal.assign(numbers.begin(), next);
    result.energy_before = next[0];
    result.energy = next[1];
    result.transmitted = next[2];
    if (collisions) return result;
    result.collapse_time = result.known_until = next[3];
    result.collapse_position = next[4];
    return result;
  }
  /// Where bodies are at a time, of the first `most` collisions. Where it may be that of one, the
  /// ways before and after it have the same doubles.
  std::vector<double> places(const Value& time, std::int64_t most) const {
    const auto told = [&]() -> std::optional<std::vector<double>> {
      const auto s = motion.shape();
      const Ball at = ball_of(time);
      int open = 0;
      const auto after = [&](bool if_open) {
        const std::int64_t N = count_of(most, [&](std::int64_t j) {
          try {
            return motion.collision(s, j).time <= at;
          } catch (const NotCertain&) {
            ++open;
            return if_open;
          }
        });
        return std::pair(N, rounded([&] { return seen(motion.places(s, at, N)); }));
      };
      const auto [N, places] = after(false);
      if (open == 0 || after(true) == std::pair(N + 1, places)) return places;
      return {};
    };
    return with_bits(17, told, " to tell where bodies are at the time " + time.text);
  }
  /// Every so many collisions; of infinitely many at least the first three, and more while doubles
  /// can tell their times apart.
  void stream(std::optional<std::int64_t> collisions, std::int64_t every, const Sink& sink) const {
    auto shape = with_bits(17, [&] { return motion.shape(); });
    const int enough_bits = Ball::bits();
    auto now = motion.stepped(shape, 0);
    const bool is_stepped = std::same_as<Motion, Trio> && (!collisions || every < 8);
    const std::int64_t end = collisions.value_or(INT64_MAX), step = is_stepped ? 1 : every;
    double before = -1;
    const auto row_of = [](const Trio::Collision& c) {
      return std::vector{c.time, c.position, c.v_left, c.v_right};
    };
    for (std::int64_t j = step - 1; j < end; j += std::min(step, end - j)) {
      const auto next = [&] { return row_of(motion.step(shape, now)); };
      const bool is_last = collisions && j + 2 >= *collisions;  // by theorems these may be at rest
      const bool is_alone = !is_stepped || is_last;
      const auto alone = [&] { return row_of(motion.collision(shape, j)); };
      auto row = is_alone ? rounded(alone) : rounded(next);
      if (!row) {
        row = certain([&] {
          shape = motion.shape();
          if (is_alone) return alone();
          now = motion.stepped(shape, j);
          return next();
        });
        if (is_alone) {
          Ball::set_bits(enough_bits);
          shape = motion.shape();
        }
      }
      const std::vector<double>& n = *row;
      if (!collisions && j >= 3 && n[0] == before) return;
      before = n[0];
      if ((j + 1) % every != 0) continue;
      if (is_mirrored)
        sink({j + 1, motion.bodies() - motion.gap(j), n[0], -n[1], -n[3], -n[2]});
      else
        sink({j + 1, motion.gap(j), n[0], n[1], n[2], n[3]});
    }
  }
  Result result(const Scene& scene, const char* model, const std::string& reason) const {
    constexpr std::int64_t few = 64;
    const auto events = within(scene);
    const bool is_few = events && *events <= few && has_exact_numbers(scene);
    Result result = is_few ? Result() : after(events);
    result.plan = {model, is_few,
                   reason + (is_few ? "; so few collisions are stepped exactly" : "")};
    if (is_few) return result;
    if (!events) {
      result.why =
          "infinitely many collisions; a list has the first three, and more while doubles can tell "
          "their times apart";
    } else if (events != motion.count()) {
      const bool is_limit = events == scene.limit();
      const auto next = [&] { return std::vector{motion.collision(motion.shape(), *events).time}; };
      result.status = Status::limited;
      result.why = is_limit ? at_limit(*events) : at_until;
      result.known_until = is_limit ? certain(next)[0] : scene.until->to_double();
    }
    return result;
  }
};
}  // namespace

std::string at_limit(std::int64_t limit) {
  return "stopped after " + std::to_string(limit) + (limit == 1 ? " collision" : " collisions") +
         "; more with --max-events";
}

std::optional<Result> by_theorem(const Scene& scene) {
  const auto trio = Seen<Trio>::of(scene);
  try {
    if (trio)
      return trio->result(scene, "theorem",
                          trio->motion.bodies() == 3 ? "a ball between two blocks"
                                                     : "a ball between a block and a wall");
    if (const auto cradle = Seen<Cradle>::of(scene))
      return cradle->result(scene, "transfers",
                            "a cradle: each ball of a magic ratio hands on all to the next block");
  } catch (const Undecided&) {
    if (trio && !scene.until && !scene.max_events) throw;
  }
  return {};
}

/// What to do with what the scene's motion is seen as.
template <class Do>
auto with_motion(const Scene& scene, const Do& act) {
  if (const auto trio = Seen<Trio>::of(scene)) return act(*trio);
  return act(*Seen<Cradle>::of(scene));
}
void stream_by_theorem(const Scene& scene, std::int64_t every, const Sink& sink) {
  with_motion(scene, [&](const auto& seen) { seen.stream(seen.within(scene), every, sink); });
}
std::vector<double> places_by_theorem(const Scene& scene, std::int64_t most, const Value& time) {
  return with_motion(scene, [&](const auto& seen) { return seen.places(time, most); });
}

}  // namespace magicmass::scenes
