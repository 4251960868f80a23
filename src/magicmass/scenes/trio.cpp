// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/trio.hpp"

#include <algorithm>

#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/errors.hpp"
#include "magicmass/plain/closed.hpp"
#include "magicmass/plain/restitution.hpp"
#include "magicmass/simulator/engine.hpp"

namespace magicmass::scenes {
namespace {
using cln::cl_I;
using cln::cl_RA;

Ball ball_of(const Value& value) {
  const auto number = [](const cl_I& k) -> std::int64_t { return cln::cl_I_to_long(k); };
  if (const auto* magic = std::get_if<notation::Magic>(&value.number))
    return generated::magic_closed<Ball>(number(magic->k)).alpha_;
  if (const auto* deficient = std::get_if<notation::Deficient>(&value.number))
    return generated::deficient_closed<Ball>(number(deficient->k)).beta_;
  return ball_of(*value.exact());
}
[[noreturn]] void too_many() {
  throw Undecided("there are more than 2^62 collisions; possible: masses that are less far apart");
}
Ball turn(std::int64_t j) { return j % 2 == 0 ? 1 : -1; }
/// sqrt(e)^j
Ball power_of(const Trio::Shape& s, std::int64_t j) {
  if (s.e.low() == 1) return 1;
  return j % 2 == 0 ? power(s.e, j / 2) : power(s.e, j / 2) * sqrt(s.e);
}
}  // namespace

Ball ball_of(const Quadratic& x) {
  const Ball a(x.rational_part());
  return x.radicand() == 1 ? a : a + Ball(x.root_part()) * sqrt(Ball(cl_RA(x.radicand())));
}

std::optional<Trio> Trio::of(const Places& places) {
  const auto& [masses, line] = places;
  const std::vector<Quadratic>&x = line.positions, &v = line.velocities;
  const auto& wall = line.right_wall;
  if (masses.size() + (wall ? 1 : 0) != 3 || line.left_wall) return {};
  Trio t;
  t.V_ = v[0] - v[1];
  if (!(v[1] == (wall ? Quadratic(0) : v[2])) || !(Quadratic(0) < t.V_)) return {};
  t.L_ = (wall ? *wall : x[2]) - x[1];
  t.drift_ = v[1];
  t.start_ = (x[1] - x[0]) / t.V_;
  t.place_ = x[1];
  t.e_ = line.restitution;
  t.A_ = masses[0];
  t.C_ = masses[1];
  if (!wall) t.B_ = masses[2];
  t.is_paper_ = t.B_ && t.A_.is(1) && t.B_->is(1) && t.e_ == 1;
  return t;
}
Trio Trio::equal_blocks(const Value& alpha, const Quadratic& e) {
  const Value block = value_of(1);
  return *of({{block, alpha, block}, {{}, {0, 0, 1}, {1, 0, 0}, {}, {}, e}});
}

std::optional<Quadratic> Trio::exact_q_e() const {
  if (!A_.exact() || !C_.exact() || (B_ && !B_->exact())) return {};
  try {
    const Quadratic per_B = B_ ? Quadratic(1) / *B_->exact() : Quadratic(0);
    return generated::shape_exact(*A_.exact(), per_B, *C_.exact(), e_).q_e;
  } catch (const std::domain_error&) {
    return {};
  }
}
Trio::Shape Trio::shape() const {
  const Ball C = ball_of(C_);
  Shape s{ball_of(A_) / C, B_ ? C / ball_of(*B_) : Ball(0), 1, ball_of(e_), 0};
  const auto q_e = exact_q_e();
  s.q_e = q_e ? ball_of(*q_e) : generated::shape_exact(s.A, s.per_B, s.C, s.e).q_e;
  if (s.q_e > 0) s.h_e = generated::angle_restitution(s.A, s.per_B, s.C, s.e, s.q_e).h_e;
  return s;
}
/// At the paper's thresholds (magic.counts, deficient.counts).
std::optional<std::int64_t> Trio::by_theorem() const {
  if (!is_paper_) return {};
  const auto* magic = std::get_if<notation::Magic>(&C_.number);
  const auto* deficient = std::get_if<notation::Deficient>(&C_.number);
  if (magic != nullptr) return 2 * cln::cl_I_to_long(magic->k);
  if (deficient != nullptr) return 2 * cln::cl_I_to_long(deficient->k) + 1;
  return {};
}
std::optional<std::int64_t> Trio::count() const {
  if (const auto known = by_theorem()) return known;
  const cl_I most = cln::ash(cl_I(1), 62);
  if (const auto q_e = exact_q_e()) {
    if (!(Quadratic(0) < *q_e)) return {};
    // The angle is below pi sqrt(q_e)/2, so there are more than 2/sqrt(q_e) - 1 collisions.
    if (*q_e < Quadratic(cl_RA(1) / cln::square(most))) too_many();
    // A tie of pi/h_e with a whole number is decided collision by collision.
    simulator::Line<Quadratic> line{{*A_.exact(), *C_.exact()}, {0, 0}, {1, 0}, {}, {}, e_};
    if (B_) {
      line.masses.push_back(*B_->exact());
      line.positions.emplace_back(1);
      line.velocities.emplace_back(0);
    } else {
      line.right_wall = 1;
    }
    simulator::Engine<Quadratic> engine(line);
    std::int64_t N = 0;
    for (; N <= largest_tie && engine.next(); ++N) engine.step();
    if (N <= largest_tie) return N;
  }
  const auto computed = [&]() -> cl_RA {
    const Shape s = shape();
    if (s.q_e <= 0) return 0;
    return generated::count_restitution(s.A, s.per_B, s.C, s.e, s.q_e, s.h_e).N_e.low();
  };
  const cl_RA N = with_bits(17, computed, " to tell how many collisions there are");
  if (N == 0) return {};
  if (N > most) too_many();
  return cln::cl_I_to_long(cln::numerator(N));
}

Trio::Stepping Trio::begin(const Shape& s) const {
  const Ball M[]{s.A, s.C, B_ ? s.C / s.per_B : Ball(0)};
  Stepping now;
  for (std::size_t i = 0; i + 1 < bodies(); ++i) {
    for (const int u : {1, 0}) {
      simulator::Body<Ball> left{M[i], 0, u}, right{M[i + 1], 0, 1 - u};
      simulator::collide(left, right, s.e);
      now.law[i][u == 1 ? 0 : 1] = {left.velocity, right.velocity};
    }
  }
  return now;
}
Trio::Collision Trio::step(const Shape& s, Stepping& now) const {
  const std::size_t right = gap(now.j), left = right - 1;
  const bool is_at_wall = right == bodies();
  auto& [v, law, t, x, open, j] = now;
  if (j++ > 0) {
    const Ball wait = open / (v[left] - v[right]);
    open = (left == 0 ? v[2] - v[1] : v[1] - v[0]) * wait;
    x = x + v[1] * wait;
    t = t + wait;
  }
  if (is_at_wall) {
    v[left] = -s.e * v[left];
  } else {
    const auto& [of_left, of_right] = law[left];
    const Ball u = v[left], w = v[right];
    v[left] = of_left[0] * u + of_right[0] * w;
    v[right] = of_left[1] * u + of_right[1] * w;
  }
  const Ball time = ball_of(start_) + ball_of(L_ / V_) * now.time;
  const Ball drift = ball_of(drift_), V = ball_of(V_);
  return {time, is_at_wall ? ball_of(place_ + L_) : place_of(time, x), drift + V * v[left],
          is_at_wall ? Ball(0) : drift + V * v[right]};
}
Ball Trio::place_of(const Ball& time, const Ball& from_C) const {
  return ball_of(place_) + ball_of(drift_) * time + ball_of(L_) * from_C;
}
std::vector<Ball> Trio::velocities(const Shape& s, std::int64_t collisions) const {
  std::vector<Ball> all{1, 0, 0};
  if (collisions > 0 && s.q_e <= 0) {
    Stepping now = begin(s);
    while (now.j < collisions) step(s, now);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = now.velocities[i];
  } else if (const std::int64_t j = collisions - 1; j >= 0) {
    const auto v = generated::after_restitution(s.A, s.per_B, s.C, s.e, s.q_e, s.h_e, j, turn(j),
                                                power_of(s, j));
    all = {v.A_next, v.C_next, j == 0 ? Ball(0) : v.B_next};  // B was not met
  }
  const auto N = by_theorem();
  if (N && *N % 2 == 0) {  // magic.velocities
    if (collisions >= *N - 1) all[0] = 0;
    if (collisions == *N) all = {0, 0, 1};
  }
  if (!B_) all.pop_back();
  for (Ball& u : all) u = ball_of(drift_) + ball_of(V_) * u;
  return all;
}
std::optional<Quadratic> Trio::exact_time(std::int64_t j) const {
  if (j == 0) return start_;
  const auto N = by_theorem();
  if (N && *N == 2 * j) return start_ + L_ / V_;  // t_j = L/V sin(jh)/sin((j+1)h), (2j+1)h = pi
  return {};
}
Trio::Collision Trio::collision(const Shape& s, std::int64_t j) const {
  if (s.q_e <= 0) {
    Stepping now = begin(s);
    while (now.j < j) step(s, now);
    return step(s, now);
  }
  const std::vector<Ball> v = velocities(s, j + 1);
  const std::size_t right = gap(j);
  const bool is_at_wall = right == v.size();
  const Ball v_right = is_at_wall ? Ball(0) : v[right];
  if (j == 0) return {ball_of(start_), ball_of(place_ + drift_ * start_), v[0], v_right};
  const auto at =
      generated::at_restitution(s.A, s.per_B, s.C, s.e, s.q_e, s.h_e, j, turn(j), power_of(s, j));
  const Ball time = ball_of(start_) + ball_of(L_ / V_) * at.moment;
  return {time, is_at_wall ? ball_of(place_ + L_) : place_of(time, at.place), v[right - 1],
          v_right};
}
Trio::Collapse Trio::collapse(const Shape& s) const {
  const auto end = generated::collapse_restitution(s.A, s.per_B, s.C, s.e, s.q_e);
  const Ball time = ball_of(start_) + ball_of(L_ / V_) * end.t_end;
  if (!B_) return {time, ball_of(place_ + L_), 0};
  return {time, place_of(time, end.x_end), ball_of(drift_) + ball_of(V_) * end.v_end};
}
std::vector<Ball> Trio::masses(const Shape& /*s*/) const {
  if (!B_) return {ball_of(A_), ball_of(C_)};
  return {ball_of(A_), ball_of(C_), ball_of(*B_)};
}
std::vector<std::int64_t> Trio::counts(std::int64_t collisions) const {
  std::vector<std::int64_t> all{0, (collisions + 1) / 2, collisions / 2};
  if (B_) all.push_back(0);
  return all;
}

}  // namespace magicmass::scenes
