// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/cradle.hpp"

#include <algorithm>

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {

constexpr std::int64_t most_of_way = std::int64_t(1) << 60;

/// Does B reach this place only after the last collision of its trio?
bool has_room(const Trio& trio, std::int64_t k, const Quadratic& place) try {
  return with_bits(
      17, [&] { return trio.collision(trio.shape(), 2 * k - 1).position < ball_of(place); });
} catch (const Undecided&) {
  return false;
}

}  // namespace

std::optional<Cradle> Cradle::of(const Places& places) {
  const auto& [masses, line, unit_V, unit_L] = places;
  if (!unit_V.is(1) || !unit_L.is(1)) return {};
  const std::vector<Quadratic>&x = line.positions, &v = line.velocities;
  const std::size_t bodies = masses.size();
  if (bodies < 3 || bodies % 2 == 0) return {};
  if (std::any_of(v.begin() + 1, v.end(), [](const Quadratic& u) { return !(u == 0); })) return {};
  Cradle cradle;
  cradle.x_ = x[0];
  cradle.V_ = v[0];
  cradle.ahead_ = line.right_wall;
  cradle.behind_ = line.left_wall;
  for (std::size_t ball = 1; ball < bodies; ball += 2) {
    const auto trio =
        Trio::of({{masses[ball - 1], masses[ball], masses[ball + 1]},
                  {{}, {x[0], x[ball], x[ball + 1]}, {v[0], 0, 0}, {}, {}, line.restitution}});
    const std::int64_t N = trio ? trio->at_threshold().value_or(1) : 1, k = N / 2;
    const Quadratic L = x[ball + 1] - x[ball];
    if (N % 2 != 0 || !(Quadratic(0) < L)) return {};
    const auto next = ball + 2 < bodies ? std::optional(x[ball + 2]) : line.right_wall;
    if (next && *next - x[ball + 1] < L && !has_room(*trio, k, *next)) return {};  // cradle.room
    cradle.pairs_.push_back({*trio, k, cradle.way_});
    cradle.way_ += 2 * k;  // cradle.number
    if (cradle.way_ > most_of_way) return {};
  }
  return cradle;
}

std::optional<std::int64_t> Cradle::count() const {
  if (ahead_ && behind_) return {};
  return ahead_ ? 2 * way_ + 1 : way_;
}

Cradle::Shape Cradle::shape() const {
  Shape all;
  for (const Pair& pair : pairs_)
    if (all.count(pair.k) == 0) all.emplace(pair.k, pair.trio.shape());
  return all;
}

/// Where collision j is: in which round trip, on the way out or back, and which one of a pair.
struct Cradle::Moment {
  std::int64_t round;
  bool is_back;         ///< or at the wall behind
  const Pair* pair;     ///< nothing for a wall
  std::int64_t number;  ///< on the way out
};
Cradle::Moment Cradle::moment(std::int64_t j) const {
  const std::int64_t of_round = j % period(), round = j / period();
  const bool is_back = of_round > way_;
  if (of_round % (way_ + 1) == way_) return {round, is_back, nullptr, 0};
  const std::int64_t of_way = is_back ? 2 * way_ - of_round : of_round;
  const auto after = std::ranges::upper_bound(pairs_, of_way, {}, &Pair::before);
  const Pair& pair = *(after - 1);
  return {round, is_back, &pair, of_way - pair.before};
}
/// On the way back motion runs backwards.
Quadratic Cradle::time_of(const Moment& m, const Quadratic& on_first_way) const {
  Quadratic from = 0;
  if (ahead_ && behind_)
    from = Quadratic(2 * cln::cl_I(static_cast<long long>(m.round))) *
           (time_at(*ahead_) - time_at(*behind_));
  return m.is_back ? from + 2 * time_at(*ahead_) - on_first_way : from + on_first_way;
}
std::optional<Quadratic> Cradle::exact_time(std::int64_t j) const {
  const Moment m = moment(j);
  const auto on_first_way =
      m.pair ? m.pair->trio.exact_time(m.number) : time_at(m.is_back ? *behind_ : *ahead_);
  return on_first_way ? std::optional(time_of(m, *on_first_way)) : std::nullopt;
}
Trio::Collision Cradle::collision(const Shape& s, std::int64_t j) const {
  const Moment m = moment(j);
  Trio::Collision c{0, 0, 0, 0};
  if (m.pair) {
    const Trio& trio = m.pair->trio;
    const Trio::Shape& of_pair = s.at(m.pair->k);
    c = trio.collision(of_pair, m.number);
    if (m.is_back) {
      const std::vector<Ball> earlier = trio.velocities(of_pair, m.number);
      const std::size_t right = trio.gap(m.number);
      c.v_left = -earlier[right - 1];
      c.v_right = -earlier[right];
    }
  } else {
    const Quadratic& wall = m.is_back ? *behind_ : *ahead_;
    c = {ball_of(time_at(wall)), ball_of(wall), 0, 0};
    (m.is_back ? c.v_right : c.v_left) = ball_of(m.is_back ? V_ : Quadratic(0) - V_);
  }
  c.time = ball_of(time_of(m, 0)) + (m.is_back ? -c.time : c.time);
  return c;
}
std::size_t Cradle::gap(std::int64_t j) const {
  const Moment m = moment(j);
  if (!m.pair) return m.is_back ? 0 : bodies();
  return first_of(*m.pair) + m.pair->trio.gap(m.number);
}
std::vector<Ball> Cradle::velocities(const Shape& s, std::int64_t collisions) const {
  const bool is_back = collisions % period() > way_;
  const Moment m = moment(is_back ? collisions - 1 : collisions);
  std::vector<Ball> all(bodies());
  if (m.pair) {
    const std::vector<Ball> v = m.pair->trio.velocities(s.at(m.pair->k), m.number);
    std::copy(v.begin(), v.end(), all.begin() + static_cast<std::ptrdiff_t>(first_of(*m.pair)));
  } else {
    all.back() = ball_of(V_);
  }
  if (is_back)
    for (Ball& u : all) u = -u;
  return all;
}
std::vector<Ball> Cradle::places(const Shape& s, const Ball& time, std::int64_t collisions) const {
  const std::int64_t of_round = collisions % period();
  const bool is_back = of_round > way_;
  const Ball from = ball_of(time_of({collisions / period(), is_back, nullptr, 0}, 0));
  const Ball on_first_way = is_back ? from - time : time - from;
  const std::int64_t before = is_back ? 2 * way_ + 1 - of_round : of_round;
  std::vector<Ball> all(bodies());
  for (const Pair& pair : pairs_) {
    const std::int64_t N = std::clamp(before - pair.before, std::int64_t(0), 2 * pair.k);
    const std::vector<Ball> x = pair.trio.places(s.at(pair.k), on_first_way, N);
    const std::size_t first = first_of(pair);
    if (before >= pair.before) all[first] = x[0];  // else it waits for what comes
    all[first + 1] = x[1];
    all[first + 2] = x[2];
  }
  return all;
}
std::vector<Ball> Cradle::masses(const Shape& s) const {
  std::vector<Ball> all(bodies(), 1);
  for (std::size_t i = 0; i < pairs_.size(); ++i) all[2 * i + 1] = s.at(pairs_[i].k).per_B;
  return all;
}
std::vector<std::int64_t> Cradle::counts(std::int64_t collisions) const {
  const std::int64_t of_round = collisions % period(), round = collisions / period();
  const std::int64_t out = std::min(of_round, way_), back = std::max(of_round - way_ - 1, {});
  std::vector<std::int64_t> all(bodies() + 1);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const std::int64_t N = 2 * pairs_[i].k, before = pairs_[i].before;
    const std::int64_t there = std::clamp(out - before, std::int64_t(0), N);
    const std::int64_t here = std::clamp(back - (way_ - before - N), std::int64_t(0), N);
    all[2 * i + 1] = round * N + (there + 1) / 2 + here / 2;  // out, the left gap is first
    all[2 * i + 2] = round * N + there / 2 + (here + 1) / 2;
  }
  all.front() = round;
  all.back() = round + (of_round > way_ ? 1 : 0);
  return all;
}

}  // namespace magicmass::scenes
