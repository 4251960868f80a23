// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/theorem.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <utility>

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {
using Balls = std::function<std::vector<Ball>()>;

/// Nearest doubles; nothing where one is not certain.
std::optional<std::vector<double>> rounded(const Balls& balls) try {
  std::vector<double> all;
  for (const Ball& ball : balls()) {
    const auto number = nearest_double(ball.low(), ball.high());
    if (!number) return {};
    all.push_back(*number);
  }
  return all;
} catch (const NotCertain&) {
  return {};
}
std::vector<double> certain(const Balls& balls) {
  return with_bits(17, [&] { return rounded(balls); });
}
/// What a mirror shows; a wall's place likewise.
void turn(Quadratic& x) { x = Quadratic(0) - x; }
void turn(Ball& x) { x = -x; }
template <class Number>
void turn(std::vector<Number>& line) {
  std::reverse(line.begin(), line.end());
  for (Number& x : line) turn(x);
}
Places mirrored(Places places) {
  auto& [masses, line] = places;
  std::reverse(masses.begin(), masses.end());
  turn(line.positions);
  turn(line.velocities);
  std::swap(line.left_wall, line.right_wall);
  for (auto* wall : {&line.left_wall, &line.right_wall})
    if (*wall) turn(**wall);
  return places;
}
Ball energy(const std::vector<Ball>& masses, const std::vector<Ball>& velocities) {
  Ball sum = 0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    sum = sum + masses[i] * velocities[i] * velocities[i];
  return sum / Ball(2);
}
}  // namespace

template <class Motion>
std::optional<Seen<Motion>> Seen<Motion>::of(const Scene& scene) {
  const auto places = exact_places(scene);
  if (!places) return {};
  if (auto motion = Motion::of(*places)) return Seen{std::move(*motion), false};
  if (auto motion = Motion::of(mirrored(*places))) return Seen{std::move(*motion), true};
  return {};
}

template <class Motion>
Result by_theorem(const Seen<Motion>& seen, std::optional<std::int64_t> collisions) {
  const Motion& motion = seen.motion;
  const bool is_mirrored = seen.is_mirrored;
  Result result;
  result.events = collisions.value_or(0);
  result.counts = motion.counts(result.events);
  if (is_mirrored) std::reverse(result.counts.begin(), result.counts.end());
  result.status = collisions ? Status::complete : Status::collapse;
  const std::vector<double> numbers = certain([&] {
    const auto s = motion.shape();
    std::vector<Ball> masses = motion.masses(s), at_end = motion.velocities(s, result.events);
    const Ball before = energy(masses, motion.velocities(s, 0));
    std::vector<Ball> all;
    if constexpr (std::same_as<Motion, Trio>) {
      if (!collisions) {
        const Trio::Collapse end = motion.collapse(s);
        at_end.assign(masses.size(), end.velocity);
        all = {end.time, is_mirrored ? -end.position : end.position};
      }
    }
    if (is_mirrored) turn(at_end);
    if (is_mirrored) std::reverse(masses.begin(), masses.end());
    const Ball of_last = energy({masses.back()}, {at_end.back()});
    all.insert(all.end(), {before, energy(masses, at_end), of_last / before});
    all.insert(all.end(), at_end.begin(), at_end.end());
    return all;
  });
  std::size_t next = 0;
  if (!collisions) {
    result.collapse_time = numbers[next++];
    result.collapse_position = numbers[next++];
    result.known_until = result.collapse_time;
  }
  result.energy_before = numbers[next++];
  result.energy = numbers[next++];
  result.transmitted = numbers[next++];
  for (; next < numbers.size(); ++next) result.terminal.emplace_back(numbers[next]);
  return result;
}

template <class Motion>
void stream_by_theorem(const Seen<Motion>& seen, std::int64_t collisions, const Sink& sink) {
  const auto& motion = seen.motion;
  constexpr int enough_bits = 192;
  Ball::set_bits(enough_bits);
  auto shape = motion.shape();
  constexpr std::size_t most_kept = 1U << 14U;
  std::vector<std::array<double, 3>> first;  // place and velocities, which come again
  for (std::int64_t j = 0; j < collisions; ++j) {
    const auto again = static_cast<std::size_t>(j % motion.period());
    const bool is_known = again < first.size();
    const auto row = [&](const typename Motion::Shape& s) {
      const Trio::Collision c = motion.collision(s, j);
      if (is_known) return std::vector{c.time};
      return std::vector{c.time, c.position, c.v_left, c.v_right};
    };
    auto numbers = rounded([&] { return row(shape); });
    if (!numbers) {
      numbers = certain([&] { return row(motion.shape()); });
      Ball::set_bits(enough_bits);
      shape = motion.shape();
    }
    const std::vector<double>& n = *numbers;
    const std::array<double, 3> of_place = is_known ? first[again] : std::array{n[1], n[2], n[3]};
    if (again == first.size() && again < most_kept) first.push_back(of_place);
    const auto [position, v_left, v_right] = of_place;
    if (seen.is_mirrored)
      sink({j + 1, motion.bodies() - motion.gap(j), n[0], -position, -v_right, -v_left});
    else
      sink({j + 1, motion.gap(j), n[0], position, v_left, v_right});
  }
}

double time_by_theorem(const Cradle& cradle, std::int64_t j) {
  return certain([&] { return std::vector{cradle.collision(cradle.shape(), j).time}; })[0];
}

template struct Seen<Trio>;
template struct Seen<Cradle>;
template Result by_theorem(const Seen<Trio>&, std::optional<std::int64_t>);
template Result by_theorem(const Seen<Cradle>&, std::optional<std::int64_t>);
template void stream_by_theorem(const Seen<Trio>&, std::int64_t, const Sink&);
template void stream_by_theorem(const Seen<Cradle>&, std::int64_t, const Sink&);

}  // namespace magicmass::scenes
