// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/theorem.hpp"

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {
const char* const too_close = "more digits would be needed than are allowed";

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
} catch (const Undecided&) {
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
      too_close);
  return *numbers;
}
Ball energy(const std::vector<Ball>& masses, const std::vector<Ball>& velocities) {
  Ball sum = 0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    sum = sum + masses[i] * velocities[i] * velocities[i];
  return sum / Ball(2);
}
}  // namespace

Result by_theorem(const Trio& trio, std::optional<std::int64_t> collisions) {
  Result result;
  result.events = collisions.value_or(0);
  const std::size_t bodies = trio.masses().size();
  result.counts.resize(bodies + 1);
  result.counts[trio.gap(0)] = (result.events + 1) / 2;
  result.counts[trio.gap(1)] = result.events / 2;
  result.status = collisions ? Status::complete : Status::collapse;
  const std::vector<double> numbers = certain([&] {
    const Trio::Shape s = trio.shape();
    const std::vector<Ball> masses = trio.masses();
    std::vector<Ball> all;
    std::vector<Ball> at_end;
    if (collisions) {
      at_end = trio.velocities(s, *collisions);
    } else {
      const Trio::Collapse end = trio.collapse(s);
      at_end.assign(bodies, end.velocity);
      all = {end.time, end.position};
    }
    const Ball before = energy(masses, trio.first_velocities());
    const Ball of_last = energy({masses.back()}, {at_end.back()});
    all.insert(all.end(), {before, energy(masses, at_end), of_last / before});
    all.insert(all.end(), at_end.begin(), at_end.end());
    return all;
  });
  std::size_t next = 0;
  if (!collisions) {
    result.collapse_time = numbers[next++];
    result.collapse_position = numbers[next++];
  }
  result.energy_before = numbers[next++];
  result.energy = numbers[next++];
  result.transmitted = numbers[next++];
  for (; next < numbers.size(); ++next) result.terminal.emplace_back(numbers[next]);
  return result;
}

void stream_by_theorem(const Trio& trio, std::int64_t collisions, const Sink& sink) {
  constexpr int enough_bits = 192;
  Ball::set_bits(enough_bits);
  Trio::Shape shape = trio.shape();
  const auto row = [&](const Trio::Shape& s, std::int64_t j) {
    const Trio::Collision c = trio.collision(s, j);
    return std::vector<Ball>{c.time, c.position, c.v_left, c.v_right};
  };
  for (std::int64_t j = 0; j < collisions; ++j) {
    auto numbers = rounded([&] { return row(shape, j); });
    if (!numbers) {
      numbers = certain([&] { return row(trio.shape(), j); });
      Ball::set_bits(enough_bits);
      shape = trio.shape();
    }
    const std::vector<double>& n = *numbers;
    sink({j + 1, trio.gap(j), n[0], n[1], n[2], n[3]});
  }
}

}  // namespace magicmass::scenes
