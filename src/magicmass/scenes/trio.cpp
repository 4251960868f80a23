// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/trio.hpp"

#include "magicmass/exact/exact.hpp"
#include "magicmass/plain/restitution.hpp"

namespace magicmass::scenes {
namespace {
using cln::cl_I;
using cln::cl_RA;
/// A number for which no guard of a restitution form refuses anything.
struct Unguarded : Ball {
  using Ball::Ball;
  Unguarded(const Ball& x) : Ball(x) {}
  friend bool operator<(const Unguarded&, const Unguarded&) { return true; }
  friend bool operator>(const Unguarded&, const Unguarded&) { return true; }
  friend bool operator<=(const Unguarded&, const Unguarded&) { return true; }
  friend bool operator>=(const Unguarded&, const Unguarded&) { return true; }
};
/// A restitution form of the motion. Its guards are ranges of doubles' exponents, which balls do
/// not have. What its theorems ask for is seen to elsewhere: masses above 0 and 0 < e <= 1 by
/// simulator::fault(), the sign of q_e by who calls, no more collisions than there are by count(),
/// and no divisor that may be 0 by Ball.
template <class Form, class... More>
auto value_of_form(const Form& form, const Trio::Shape& s, const More&... more) {
  return form(s.A, s.per_B, 1, s.e, s.q_e, more...);
}
[[noreturn]] void too_many() {
  throw Undecided("there are more than 2^62 collisions; possible: masses that are less far apart");
}
Ball turn(std::int64_t j) { return j % 2 == 0 ? 1 : -1; }
auto end_of(const Trio::Shape& s, const Trio::Stepping::Start& at_0) {
  const auto& [V, W, d_A, d_B] = at_0;
  return value_of_form(generated::collapse_restitution<Unguarded>, s, V, W, d_A, d_B);
}
/// sqrt(e)^j
Ball power_of(const Trio::Shape& s, std::int64_t j) {
  if (s.e.low() == 1) return 1;
  return j % 2 == 0 ? power(s.e, j / 2) : power(s.e, j / 2) * sqrt(s.e);
}
}  // namespace

std::optional<Trio> Trio::of(const Start& start) try {
  const auto& [masses, e, V, r, d_A, d_B, place, drift, sign] = start;
  const auto part = d_B.is(0) ? std::nullopt : quotient(d_A, d_B);
  const bool is_first = !(Quadratic(0) < r) || (part && r * *part < 1);
  if (!is_first || (V.exact() && !(Quadratic(0) < *V.exact()))) return {};
  Trio t;
  t.from_ = start;
  if (t.bodies() == 3 && masses[0].is(1) && masses[2].is(1) && e == 1 && t.is_at_rest())
    t.at_threshold_ = t.count_at_threshold();
  if (r < 0 && !t.has_told_end()) return {};
  return t;
} catch (const std::domain_error&) {  // numbers of two fields
  return {};
}
std::optional<Trio> Trio::of(const Scene& scene, bool is_mirrored) {
  const auto &wall = is_mirrored ? scene.left_wall : scene.right_wall,
             &behind = is_mirrored ? scene.right_wall : scene.left_wall;
  const auto* const e = scene.restitution.exact();
  if (scene.masses.size() + (wall ? 1 : 0) != 3 || behind || !e) return {};
  std::vector<Value> masses = scene.masses, x = scene.positions, v = scene.velocities;
  if (is_mirrored)
    for (auto* const values : {&masses, &x, &v}) std::ranges::reverse(*values);
  x.push_back(wall.value_or(value_of(0)));
  v.push_back(value_of(0));
  const auto over = [&](const Value& left, const Value& right) {
    return is_mirrored ? difference(left, right) : difference(right, left);
  };
  const auto V = over(v[1], v[0]), U = over(v[2], v[0]);
  const auto d_A = over(x[0], x[1]), d_B = over(x[1], x[2]);
  if (!V || !U || !d_A || !d_B) return {};
  const auto U_per_V = quotient(*U, *V);
  if (!U_per_V) return {};
  return of({masses, *e, *V, *U_per_V - 1, *d_A, *d_B, x[2], v[2], is_mirrored ? -1 : 1});
}
Trio Trio::equal_blocks(const Value& alpha, const Quadratic& e) {
  return *of(Start{{value_of(1), alpha, value_of(1)}, e});
}

std::optional<std::array<Quadratic, 3>> Trio::exact_masses() const {
  const std::vector<Value>& m = from_.masses;
  for (const Value& mass : m)
    if (!mass.exact()) return {};
  return {
      {*m[0].exact(), *m[1].exact(), bodies() == 3 ? Quadratic(1) / *m[2].exact() : Quadratic(0)}};
}
std::optional<Quadratic> Trio::exact_q_e() const try {
  const auto exact = exact_masses();
  if (!exact) return {};
  const auto& [A, C, per_B] = *exact;
  return generated::shape_exact(A, per_B, C, from_.e).q_e;
} catch (const std::domain_error&) {
  return {};
}
Trio::Shape Trio::shape() const {
  const std::vector<Value>& m = from_.masses;
  const Ball C = ball_of(m[1]);
  Shape s{C, ball_of(m[0]) / C, bodies() == 3 ? C / ball_of(m[2]) : Ball(0), ball_of(from_.e), 0};
  const auto q_e = exact_q_e();
  s.q_e = q_e ? ball_of(*q_e) : generated::shape_exact<Ball>(s.A, s.per_B, 1, s.e).q_e;
  if (s.q_e > 0) s.h_e = value_of_form(generated::angle_restitution<Unguarded>, s).h_e;
  return s;
}
/// magic.counts, deficient.counts
std::optional<std::int64_t> Trio::count_at_threshold() const {
  if (const auto* const ratio = from_.masses[1].ratio())
    return cln::cl_I_to_long(2 * ratio->k + (ratio->is_magic ? 0 : 1));
  const auto end = first_collisions();
  return end.velocities[0] == 0 && end.velocities[1] == 0 ? std::optional(end.collisions)
                                                          : std::nullopt;
}
simulator::InTurn<Quadratic> Trio::first_collisions() const {
  const auto [A, C, per_B] = *exact_masses();
  const Quadratic one(1), none(0);
  simulator::InTurn<Quadratic> now(A, C, per_B, from_.e, {one, from_.W_per_V, none, one});
  const auto& v = now.velocities;
  const auto approach = [&] { return now.collisions % 2 == 0 ? v[1] < v[0] : v[2] < v[1]; };
  while (now.collisions <= largest_tie && approach()) now.step();
  return now;
}
std::optional<std::int64_t> Trio::count() const {
  if (at_threshold_) return at_threshold_;
  const cl_I most = cln::ash(cl_I(1), 62);
  if (const auto q_e = exact_q_e()) {
    if (!(Quadratic(0) < *q_e)) return {};
    // The angle is below pi sqrt(q_e)/2, so there are more than 2/sqrt(q_e) - 1 collisions.
    if (is_at_rest() && *q_e < Quadratic(cl_RA(1) / cln::square(most))) too_many();
    // A tie of pi/h_e with a whole number is decided collision by collision.
    try {
      const std::int64_t few = first_collisions().collisions;
      if (few <= largest_tie) return few;
    } catch (const std::domain_error&) {  // masses and velocities of two fields
    }
  }
  const auto computed = [&]() -> cl_RA {
    const Shape s = shape();
    if (s.q_e <= 0) return 0;
    const Stepping::Start at_0 = start();
    return value_of_form(generated::count_restitution<Unguarded>, s, s.h_e, at_0.V, at_0.W)
        .N_any.low();
  };
  const cl_RA N = with_bits(17, computed, " to tell how many collisions there are");
  if (N == 0) return {};
  if (N > most) too_many();
  return cln::cl_I_to_long(cln::numerator(N));
}

Trio::Stepping::Start Trio::start() const {
  const Ball V = ball_of(from_.V);
  return {V, ball_of(from_.W_per_V) * V, ball_of(from_.d_A), ball_of(from_.d_B)};
}
bool Trio::has_told_end() const try {
  return with_bits(17, [&] {
    const Shape s = shape();
    return s.q_e > 0 || Ball(end_of(s, start()).end_speed) > 0;
  });
} catch (const Undecided&) {
  return false;
}
Trio::Stepping Trio::stepped(const Shape& s, std::int64_t collisions) const {
  Stepping now(s.A, 1, s.per_B, s.e, start());
  while (now.collisions < collisions) now.step();
  return now;
}
Trio::Collision Trio::collision(const Stepping& now) const {
  return in_scene(now.collisions - 1, now.time, now.place, now.velocities);
}
Ball Trio::place_of(const Ball& time, const Ball& place) const {
  return from_.sign * (ball_of(from_.drift) * time + ball_of(from_.place)) + place;
}
Ball Trio::velocity_of(const Ball& u) const { return from_.sign * ball_of(from_.drift) + u; }
Trio::Collision Trio::in_scene(std::int64_t j, const Ball& moment, const Ball& place,
                               const Velocities& u) const {
  const std::size_t right = j % 2 == 0 ? 1 : 2;
  const Ball position = place_of(moment, right == bodies() ? Ball(0) : place);
  return {j + 1, right, moment, position, velocity_of(u[right - 1]), velocity_of(u[right])};
}
Trio::Velocities Trio::places_seen(const Shape& s, const Stepping::Start& from, const Ball& moment,
                                   std::int64_t collisions) const {
  const auto& [V, W, d_A, d_B] = from;
  const std::int64_t j = collisions - 1;
  const auto at = value_of_form(generated::at_restitution<Unguarded>, s, s.h_e, V, W, d_A, d_B,
                                moment, j, turn(j), power_of(s, j));
  return {at.A_at, at.C_at, j == 0 ? Ball(0) : Ball(at.B_at)};  // B was not met
}
Trio::Velocities Trio::seen(const Shape& s, std::int64_t collisions) const {
  const auto [V, W, d_A, d_B] = start();
  if (collisions == 0) return {V + W, W, 0};
  Velocities all = places_seen(s, {V, W, 0, 0}, 1, collisions);  // any_start.linear
  const auto& N = at_threshold_;
  if (N && *N % 2 == 0) {  // magic.velocities
    if (collisions >= *N - 1) all[0] = 0;
    if (collisions == *N) all = {0, 0, V};
  }
  return all;
}
std::vector<Ball> Trio::velocities(const Shape& s, std::int64_t collisions) const {
  const Velocities u = s.q_e > 0 ? seen(s, collisions) : stepped(s, collisions).velocities;
  std::vector<Ball> all;
  for (std::size_t i = 0; i < bodies(); ++i) all.push_back(velocity_of(u[i]));
  return all;
}
std::optional<Quadratic> Trio::exact_time(std::int64_t j) const {
  const auto met = quotient(from_.d_A, from_.V), later = quotient(from_.d_B, from_.V);
  const bool is_at_once = from_.d_B.is(0) && (is_at_rest() || from_.d_A.is(0));
  if (j == 0 || is_at_once) return met;
  // L/V sin(jh)/sin((j+1)h) later, (2j+1)h = pi
  if (met && later && at_threshold_ && *at_threshold_ == 2 * j) return *met + *later;
  return {};
}
Trio::Collision Trio::collision(const Shape& s, std::int64_t j) const {
  if (s.q_e <= 0) return collision(stepped(s, j + 1));
  if (j == 0) {
    const Stepping first = stepped(s, 0);
    return in_scene(0, first.time, first.place, seen(s, 1));
  }
  const auto [V, W, d_A, d_B] = start();
  const auto exact = exact_time(j);
  const Ball moment =
      exact ? ball_of(*exact)
            : value_of_form(generated::time_restitution<Unguarded>, s, s.h_e, V, W, d_A, d_B, j)
                  .moment;
  return in_scene(j, moment, places_seen(s, {V, W, d_A, d_B}, moment, j + 1)[1], seen(s, j + 1));
}
std::vector<Ball> Trio::places(const Shape& s, const Ball& time, std::int64_t N) const {
  const std::vector<Ball> v = velocities(s, N);
  const std::int64_t last_of[]{N - 1 - (N - 1) % 2, N - 1, N - 1 - N % 2};  // of A, C, B
  std::vector<Ball> all;
  for (std::size_t i = 0; i < bodies(); ++i) {
    const Collision c = collision(s, std::max<std::int64_t>(last_of[i], 0));
    const bool was_met = i < 2 || N > 1;
    all.push_back(was_met ? c.position + v[i] * (time - c.time) : place_of(time, 0));
  }
  return all;
}
Trio::Collision Trio::collapse(const Shape& s) const {
  const auto end = end_of(s, start());
  const Ball time = end.t_any, v = velocity_of(end.v_any);
  return {0, 0, time, place_of(time, end.x_any), v, v};
}
std::vector<Ball> Trio::masses(const Shape& s) const {
  std::vector<Ball> all{ball_of(from_.masses[0]), s.C};
  if (bodies() == 3) all.push_back(ball_of(from_.masses[2]));
  return all;
}

}  // namespace magicmass::scenes
