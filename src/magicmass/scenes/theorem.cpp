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
Result Seen<Motion>::after(std::optional<std::int64_t> collisions) const {
  Result result;
  result.events = collisions.value_or(0);
  result.counts = motion.counts(result.events);
  if (is_mirrored) std::reverse(result.counts.begin(), result.counts.end());
  result.status = collisions ? Status::complete : Status::collapse;
  const std::size_t bodies = motion.bodies(), last = is_mirrored ? 0 : bodies - 1;
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
    const Ball of_last = energy({masses[last]}, {all[last]});
    if (is_mirrored) turn(all);
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

template <class Motion>
void Seen<Motion>::stream(std::int64_t collisions, const Sink& sink) const {
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
    if (is_mirrored)
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

}  // namespace magicmass::scenes
