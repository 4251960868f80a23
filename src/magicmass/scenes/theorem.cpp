// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/theorem.hpp"

#include <array>
#include <concepts>

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
  std::optional<std::vector<double>> numbers;
  with_bits(
      17,
      [&] {
        numbers = rounded(balls);
        return numbers.has_value();
      },
      "");
  return *numbers;
}
Ball energy(const std::vector<Ball>& masses, const std::vector<Ball>& velocities) {
  Ball sum = 0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    sum = sum + masses[i] * velocities[i] * velocities[i];
  return sum / Ball(2);
}
}  // namespace

template <class Motion>
Result by_theorem(const Motion& motion, std::optional<std::int64_t> collisions) {
  Result result;
  result.events = collisions.value_or(0);
  result.counts = motion.counts(result.events);
  result.status = collisions ? Status::complete : Status::collapse;
  const std::vector<double> numbers = certain([&] {
    const auto s = motion.shape();
    const std::vector<Ball> masses = motion.masses(s);
    std::vector<Ball> all;
    std::vector<Ball> at_end = motion.velocities(s, result.events);
    if constexpr (std::same_as<Motion, Trio>) {
      if (!collisions) {
        const Trio::Collapse end = motion.collapse(s);
        at_end.assign(masses.size(), end.velocity);
        all = {end.time, end.position};
      }
    }
    const Ball before = energy(masses, motion.velocities(s, 0));
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
void stream_by_theorem(const Motion& motion, std::int64_t collisions, const Sink& sink) {
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
    sink({j + 1, motion.gap(j), n[0], of_place[0], of_place[1], of_place[2]});
  }
}

double time_by_theorem(const Cradle& cradle, std::int64_t j) {
  return certain([&] { return std::vector{cradle.collision(cradle.shape(), j).time}; })[0];
}

template Result by_theorem(const Trio&, std::optional<std::int64_t>);
template Result by_theorem(const Cradle&, std::optional<std::int64_t>);
template void stream_by_theorem(const Trio&, std::int64_t, const Sink&);
template void stream_by_theorem(const Cradle&, std::int64_t, const Sink&);

}  // namespace magicmass::scenes
