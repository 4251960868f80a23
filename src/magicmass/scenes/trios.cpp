#include "magicmass/scenes/trio.hpp"

namespace magicmass::scenes {
namespace {

constexpr std::int64_t most_of_way = std::int64_t(1) << 60;
const std::string none_comes = "no block meets the ball";
const std::string ends = "not a cradle, which begins and ends with a block, one of them in motion";

/// Does B reach this place only after the last collision of its trio?
bool has_room(const Trio& trio, std::int64_t k, const Surd& place) try {
  return with_bits(
      17, [&] { return trio.collision(trio.shape(), 2 * k - 1).position < ball_of(place); });
} catch (const Undecided&) {
  return false;
}

}  // namespace

Trios Trios::of_one(const Trio& trio) {
  Trios all;
  all.is_cradle_ = false;
  all.way_ = INT64_MAX / 2 - 1;
  all.pairs_ = {{trio, all.way_ / 2, 0, 0}};
  return all;
}

Found<Trios> Trios::of(const Scene& scene) {
  auto one = as_it_is(scene);
  if (one) return one;
  auto image = as_it_is(mirrored(scene));
  if (image) image->is_mirrored_ = true;
  const auto rank = [](const std::string& why) {
    return std::pair(why == ends ? 0 : why == none_comes ? 1 : 2, why);
  };
  return image || rank(one.why) < rank(image.why) ? image : one;
}

Found<Trios> Trios::as_it_is(const Scene& scene) {
  const auto trio = Trio::of(scene);
  if (trio) return of_one(*trio);
  if (!trio.why.empty()) return trio.why;
  if (scene.masses.size() == 3 && !scene.left_wall && !scene.right_wall) return none_comes;
  Scene exact = scene;  // but for the masses
  exact.masses.assign(scene.masses.size(), value_of(1));
  exact.times.clear();
  exact.until.reset();
  if (!has_exact_numbers(exact)) return "its numbers are not known exactly";
  const auto line = line_of<Surd>(exact);
  return scene.masses.size() == 2 ? off_wall(scene.masses, line) : cradle(scene.masses, line);
}

Found<Trios> Trios::cradle(const std::vector<Value>& masses, const simulator::Line<Surd>& line) {
  Trios all;
  const std::vector<Surd>&x = line.positions, &v = line.velocities;
  const std::size_t bodies = masses.size();
  const auto moves = [](const Surd& u) { return !(u == 0); };
  if (bodies == 1) return "only one body";
  if (bodies % 2 == 0 || std::any_of(v.begin() + 1, v.end(), moves)) return ends;
  all.x_ = x[0];
  all.V_ = v[0];
  all.ahead_ = line.right_wall;
  all.behind_ = line.left_wall;
  for (std::size_t ball = 1; ball < bodies; ball += 2) {
    const Surd L = x[ball + 1] - x[ball];
    const auto trio = Trio::of({.masses{masses[ball - 1], masses[ball], masses[ball + 1]},
                                .e{"", line.restitution},
                                .V{"", v[0]},
                                .d_A{"", x[ball] - x[0]},
                                .d_B{"", L},
                                .place{"", x[ball + 1]}});
    if (!trio) return none_comes;
    const std::int64_t N = trio->at_threshold().value_or(1), k = N / 2;
    if (N % 2 != 0)
      return "not a cradle, which has blocks of mass 1, balls of magic ratios and no loss";
    if (!(0 < L)) return "not a cradle: a ball touches the next block";
    const auto next = ball + 2 < bodies ? std::optional(x[ball + 2]) : line.right_wall;
    if (next && *next - x[ball + 1] < L && !has_room(*trio, k, *next))
      return "not a cradle: a block meets what is behind it before its ball rests";  // cradle.room
    all.pairs_.push_back({*trio, k, all.way_, std::ssize(all.pairs_) * 2});
    all.way_ += N;  // cradle.number
    if (all.way_ > most_of_way) return "a cradle of more than 2^60 collisions";
  }
  return all;
}

Found<Trios> Trios::off_wall(const std::vector<Value>& masses, const simulator::Line<Surd>& line) {
  if (line.right_wall && line.left_wall) return "a ball or a block between two walls";
  if (!line.right_wall) return line.left_wall ? none_comes : "only two bodies";
  const Surd wall = *line.right_wall, e = line.restitution;
  const Surd W = line.velocities[1], V = line.velocities[0] - W;
  const Surd d_A = line.positions[1] - line.positions[0], d_B = wall - line.positions[1];
  const bool is_first = V < W ? !(W * d_A < V * d_B) : V * d_B < W * d_A;
  const Surd faster = V + W + e * W;
  if (!(0 < W) || (0 < V && !is_first) || !(0 < faster)) return none_comes;
  const auto trio = Trio::of({.masses = masses,
                              .e{"", e},
                              .V{"", faster},
                              .W_per_V = -e * W / faster,
                              .d_A{"", d_A + d_B + e * d_B},
                              .d_B{"", -e * d_B},
                              .place{"", wall}});
  if (!trio) return trio.why.empty() ? none_comes : trio.why;
  Trios all = of_one(*trio);
  all.thrown_ = line;
  return all;
}

std::optional<std::int64_t> Trios::count() const {
  if (alone()) {
    const auto N = alone()->count();
    return N ? std::optional(*N + thrown()) : N;
  }
  if (ahead_ && behind_) return {};
  return ahead_ ? 2 * way_ + 1 : way_;
}

const Trio::Shape& Trios::shape_of(const Pair& pair) const {
  const std::pair key(Ball::bits, pair.k);
  if (!shapes_.contains(key)) shapes_.emplace(key, pair.trio.shape());
  return shapes_.at(key);
}

/// Where collision j is: on the way out, or back, where motion runs backwards; which one of a pair.
struct Trios::Moment {
  bool is_back;         ///< or at the wall behind
  const Pair* pair;     ///< nothing for a wall
  std::int64_t number;  ///< on the way out
  Surd from;            ///< the time from which that on the first way counts
};
Trios::Moment Trios::moment(std::int64_t j) const {
  j -= thrown();
  const std::int64_t of_round = j % period();
  Moment m{of_round > way_, nullptr, 0, 0};
  if (ahead_ && behind_)
    m.from = Surd(2 * cln::cl_I(static_cast<long long>(j / period()))) *
             (time_at(*ahead_) - time_at(*behind_));
  if (m.is_back) m.from = m.from + 2 * time_at(*ahead_);
  if (of_round % (way_ + 1) == way_) return m;
  m.number = m.is_back ? 2 * way_ - of_round : of_round;
  m.pair = &*(std::ranges::upper_bound(pairs_, m.number, {}, &Pair::before) - 1);
  m.number -= m.pair->before;
  return m;
}
std::optional<Surd> Trios::exact_time(std::int64_t j, bool is_hard) const {
  if (j < thrown()) return (*thrown_->right_wall - thrown_->positions[1]) / thrown_->velocities[1];
  const Moment m = moment(j);
  const auto on_first_way =
      m.pair ? m.pair->trio.exact_time(m.number, is_hard) : time_at(m.is_back ? *behind_ : *ahead_);
  if (!on_first_way) return {};
  return m.is_back ? m.from - *on_first_way : m.from + *on_first_way;
}
std::vector<Ball> Trios::seen(std::vector<Ball> all) const {
  if (!is_mirrored_) return all;
  std::ranges::reverse(all);
  for (Ball& x : all) x = -x;
  return all;
}
Trio::Collision Trios::seen(const Trio::Collision& c) const {
  if (!is_mirrored_) return c;
  return {c.number, bodies() - c.gap, c.time, -c.position, -c.v_right, -c.v_left};
}
Trio::Collision Trios::collision(std::int64_t j) const {
  if (j < thrown()) {
    const Ball wall = ball_of(*thrown_->right_wall), W = ball_of(thrown_->velocities[1]);
    return seen(Trio::Collision{1, 2, ball_of(*exact_time(j, false)), wall,
                                -ball_of(thrown_->restitution) * W, 0});
  }
  const Moment m = moment(j);
  Trio::Collision c{};
  if (m.pair) {
    const Trio& trio = m.pair->trio;
    const Trio::Shape& of_pair = shape_of(*m.pair);
    c = trio.collision(of_pair, m.number);
    if (m.is_back) {
      const std::vector<Ball> earlier = trio.velocities(of_pair, m.number);
      c.v_left = -earlier[c.gap - 1];
      c.v_right = -earlier[c.gap];
    }
    c.gap += static_cast<std::size_t>(m.pair->first);
  } else {
    const Surd& wall = m.is_back ? *behind_ : *ahead_;
    c = {0, m.is_back ? 0 : bodies(), ball_of(time_at(wall)), ball_of(wall), 0, 0};
    (m.is_back ? c.v_right : c.v_left) = ball_of(m.is_back ? V_ : -V_);
  }
  c.number = j + 1;
  c.time = ball_of(m.from) + (m.is_back ? -c.time : c.time);
  return seen(c);
}
std::vector<Ball> Trios::velocities(std::int64_t collisions) const {
  if (collisions < thrown()) {
    const auto& v = thrown_->velocities;
    return seen(std::vector{ball_of(v[0]), ball_of(v[1])});
  }
  const bool is_back = moment(collisions).is_back;
  const Moment m = moment(is_back ? collisions - 1 : collisions);
  std::vector<Ball> all(bodies());
  if (m.pair)
    std::ranges::copy(m.pair->trio.velocities(shape_of(*m.pair), m.number),
                      all.begin() + m.pair->first);
  else
    all.back() = ball_of(V_);
  if (is_back)
    for (Ball& u : all) u = -u;
  return seen(std::move(all));
}
std::vector<Ball> Trios::places(const Ball& time, std::int64_t collisions) const {
  if (collisions < thrown()) {
    const auto &x = thrown_->positions, &v = thrown_->velocities;
    return seen(
        std::vector{ball_of(x[0]) + ball_of(v[0]) * time, ball_of(x[1]) + ball_of(v[1]) * time});
  }
  const Moment m = moment(collisions);
  const Ball from = ball_of(m.from), on_first_way = m.is_back ? from - time : time - from;
  const std::int64_t of_round = (collisions - thrown()) % period();
  const std::int64_t before = m.is_back ? 2 * way_ + 1 - of_round : of_round;
  std::vector<Ball> all(bodies());
  for (const Pair& pair : pairs_) {
    const std::int64_t N = std::clamp(before - pair.before, std::int64_t(0), 2 * pair.k);
    const std::vector<Ball> x = pair.trio.places(shape_of(pair), on_first_way, N);
    const int waiting = before < pair.before ? 1 : 0;  // for what comes
    std::copy(x.begin() + waiting, x.end(), all.begin() + pair.first + waiting);
  }
  return seen(std::move(all));
}
std::vector<std::int64_t> Trios::counts(std::int64_t collisions) const {
  const std::int64_t at_wall = std::min(collisions, thrown());
  collisions -= at_wall;
  const std::int64_t of_round = collisions % period(), round = collisions / period();
  const std::int64_t out = std::min(of_round, way_), back = std::max(of_round - way_ - 1, {});
  std::vector<std::int64_t> all(bodies() + 1);
  for (const Pair& pair : pairs_) {
    const std::int64_t N = 2 * pair.k, before = pair.before;
    const std::int64_t there = std::clamp(out - before, std::int64_t(0), N);
    const std::int64_t here = std::clamp(back - (way_ - before - N), std::int64_t(0), N);
    const auto left = static_cast<std::size_t>(pair.first) + 1;
    all[left] = round * N + (there + 1) / 2 + here / 2;  // out, the left gap is first
    all[left + 1] = round * N + there / 2 + (here + 1) / 2;
  }
  all.front() += round;
  all.back() += round + (of_round > way_ ? 1 : 0) + at_wall;
  if (is_mirrored_) std::ranges::reverse(all);
  return all;
}

}  // namespace magicmass::scenes
