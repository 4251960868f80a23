#include "magicmass/scenes/trio.hpp"

#include "magicmass/exact/exact.hpp"
#include "magicmass/plain/restitution.hpp"

namespace magicmass::scenes {
namespace {
using cln::cl_I, cln::cl_RA;
const std::string unknown = "differences or ratios of its numbers are not known exactly";
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
/// not have. What its theorems ask for is seen to elsewhere: masses > 0 and 0 < e <= 1 by fault(),
/// the sign of q_e by who calls, no more collisions than there are by count(), divisors by Ball.
auto value_of_form(const auto& form, const Trio::Shape& s, const auto&... more) {
  return form(s.A, s.per_B, 1, s.e, more...);
}
[[noreturn]] void too_many() {
  throw Undecided("there are more than 2^62 collisions; possible: masses that are less far apart");
}
auto end_of(const Trio::Shape& s, const Trio::FromB& at_0) {
  const auto& [V, W, d_A, d_B] = at_0;
  return value_of_form(generated::collapse_restitution<Unguarded>, s, s.q_e, V, W, d_A, d_B);
}
/// U_j and U_last in a unit, and sqrt(e)^j over it.
struct Swing {
  std::int64_t j;
  Ball unit, now, last, per_unit;
};
Swing swing_of(const Trio::Shape& s, std::int64_t j) {
  if (s.q_e > 0) {
    const auto [now, last] =
        value_of_form(generated::sines_restitution<Unguarded>, s, s.q_e, s.h_e, s.step_sine, j);
    const Ball pair = power(s.e, j / 2);
    return {j, s.step_sine, now, last, (j % 2 == 0 ? pair : pair * sqrt(s.e)) / s.step_sine};
  }
  const Ball unit = power(s.y_e, j), per_unit = power(sqrt(s.e) / s.y_e, j);
  if (s.q_e < 0) {
    const auto [last, now] =
        value_of_form(generated::rise_restitution<Unguarded>, s, s.q_e, s.y_e, j, unit);
    return {j, unit, now, last, per_unit};
  }
  const auto [last, now] = value_of_form(generated::even_restitution<Unguarded>, s, s.q_e, unit, j);
  return {j, unit, now, last, per_unit};
}
/// Whether it takes place, and when.
auto time_of(const Trio::Shape& s, const Swing& c, const Trio::FromB& from) {
  const auto& [V, W, d_A, d_B] = from;
  return value_of_form(generated::time_restitution<Unguarded>, s, c.unit, c.j, c.now, c.last, V, W,
                       d_A, d_B);
}
/// Places at a time after it, of A, C and B, as seen from B before it is met.
std::array<Ball, 3> places_seen(const Trio::Shape& s, const Swing& c, const Trio::FromB& from,
                                const Ball& time) {
  const auto& [V, W, d_A, d_B] = from;
  const Ball turn = c.j % 2 == 0 ? 1 : -1;
  const auto at = value_of_form(generated::at_restitution<Unguarded>, s, c.unit, c.j, c.now, c.last,
                                c.per_unit, V, W, d_A, d_B, time, turn);
  return {at.A_at, at.C_at, c.j == 0 ? Ball(0) : Ball(at.B_at)};  // B was not met
}
/// Of five speeds, or how a later one follows from two before it, as first_speeds() says.
Surd factor_of(const Trio::Speeds& s) { return s[2] == 0 ? 0 : (s[0] + s[4]) / s[2]; }
/// That of collision j + 4 instead of that of j; false where it is too long.
bool go_on(Trio::Speeds& s, const Surd& factor, std::int64_t j) {
  Surd& one = s[std::size_t(j % 4)];
  one = factor * s[std::size_t((j + 2) % 4)] - one;
  return one.bits() < Trio::longest_tie;
}
}  // namespace

Found<Trio> Trio::of(const Start& start) try {
  const auto& [masses, e, V, r, d_A, d_B, place, drift] = start;
  Trio t;
  t.from_ = start;
  const auto A = quotient(masses[0], masses[1]);
  const auto per_B = t.bodies() == 3 ? quotient(masses[1], masses[2]) : Surd(0);
  if (const Surd* loss = e.exact(); loss != nullptr && A && per_B)
    t.exact_ = Exact{*A, *per_B, *loss, generated::shape_exact<Surd>(*A, *per_B, 1, *loss).q_e};
  const auto part = d_B.is(0) ? std::nullopt : quotient(d_A, d_B);
  t.is_at_once_ = part ? r * *part == 1 : d_B.is(0) && (r == 0 || d_A.is(0));
  const bool is_first = !(0 < r) || (t.is_at_once_ ? r < 1 : part && r * *part < 1);
  if (!V.is_positive()) return "";
  if (!is_first) return t.is_at_once_ && r == 1 ? "all three meet at once, at equal speeds" : "";
  if (t.bodies() == 3 && masses[0].is(1) && masses[2].is(1) && e.is(1))
    t.at_threshold_ = t.count_at_threshold();
  if (r < 0)
    t.end_sign_ = with_bits(17, [&] {
      const Shape s = t.shape();
      if (s.q_e > 0) return 1;
      if (const auto exactly = t.end_sign(1, start.W_per_V)) return *exactly;
      return Ball(end_of(s, t.start()).end_speed) > 0 ? 1 : -1;
    });
  return t;
} catch (const Undecided&) {
  return unknown;
}
Found<Trio> Trio::of(const Scene& scene) {
  if (scene.masses.size() + (scene.right_wall ? 1 : 0) != 3 || scene.left_wall) return "";
  std::vector<Value> x = scene.positions, v = scene.velocities;
  x.push_back(scene.right_wall.value_or(value_of(0)));
  v.push_back(value_of(0));
  const auto V = difference(v[0], v[1]), U = difference(v[0], v[2]);
  const auto d_A = difference(x[1], x[0]), d_B = difference(x[2], x[1]);
  if (!V || !U || !d_A || !d_B) return unknown;
  if (V->is(0)) return "";
  const auto U_per_V = quotient(*U, *V);
  if (!U_per_V) return unknown;
  return of({scene.masses, scene.restitution, *V, *U_per_V - 1, *d_A, *d_B, x[2], v[2]});
}
Trio Trio::equal_blocks(const Value& alpha, const Value& e) {
  return *of(Start{{value_of(1), alpha, value_of(1)}, e});
}

Trio::Shape Trio::shape() const {
  const std::vector<Value>& m = from_.masses;
  const Ball C = ball_of(m[1]);
  Shape s{C, ball_of(m[0]) / C, bodies() == 3 ? C / ball_of(m[2]) : Ball(0), ball_of(from_.e), 0};
  s.q_e = exact_ ? ball_of(exact_->q_e) : generated::shape_exact<Ball>(s.A, s.per_B, 1, s.e).q_e;
  if (s.q_e > 0) {
    const auto angle = value_of_form(generated::angle_restitution<Unguarded>, s, s.q_e);
    s.h_e = angle.h_e;
    s.step_sine = angle.step_sine;
  } else if (s.q_e < 0) {
    s.y_e = end_of(s, {}).y_e;
  }
  return s;
}
/// magic.counts, deficient.counts. After the 2 k of rest U_(2 k) = U_k^2 - U_(k-1)^2 is 0
/// (chebyshev.double): of bodies that begin with W = -V the next two are side by side after k.
std::optional<std::int64_t> Trio::count_at_threshold() const {
  const auto& ratio = from_.masses[1].ratio;
  if (ratio && ratio->is_magic && from_.W_per_V == -1) return cln::cl_I_to_long(ratio->k);
  if (!is_at_rest()) return {};
  if (ratio) return cln::cl_I_to_long(2 * ratio->k + (ratio->is_magic ? 0 : 1));
  static const Value surds[]{read_value("magic:1"), read_value("magic:2")};
  for (std::int64_t k : {1, 2})
    if (from_.masses[1].is(surds[k - 1].number)) return 2 * k;
  return {};
}
/// By any_start.speed each second approach speed, over e each time, is a sum of each second
/// U_j(kappa): each follows from the two before by one factor, which the first three tell
/// (chebyshev.two_steps), and evenly where kappa is 1 (chebyshev.steps).
std::optional<Trio::Speeds> Trio::first_speeds(const Surd& V, const Surd& W) const {
  if (!exact_) return {};
  simulator::InTurn<Surd> now(exact_->A, 1, exact_->per_B, exact_->e, V, W);
  Speeds speeds;
  Surd loss = 1;
  for (std::size_t j = 0; j < 5; now.step(), ++j) {
    speeds[j] = now.approach() / loss;
    if (j % 2 == 1) loss = loss * exact_->e;
  }
  return speeds;
}
/// Where kappa is above 1 each second speed is a q^i + b/q^i, q > 1, and a is end_speed but for a
/// positive factor: s_0 s_4 - s_2^2 has the sign of a b. Where it is 1 they follow evenly.
std::optional<int> Trio::end_sign(const Surd& V, const Surd& W) const {
  const auto sign = [](const Surd& x) { return 0 < x ? 1 : x == 0 ? 0 : -1; };
  if (V == 0) return sign(W);
  const auto s = first_speeds(1, W / V);
  if (!s) return {};
  const auto& [s_0, s_1, s_2, s_3, s_4] = *s;
  return sign(V) * (s_0 < s_2 ? 1 : sign(s_0 * s_4 - s_2 * s_2));
}
std::optional<Surd> Trio::speed(Speeds s, const Surd& factor, std::int64_t j) const {
  const std::size_t i = j % 2 == 0 ? 0 : 1;
  if (exact_->q_e == 0) return s[i] + Surd(cl_I(static_cast<long long>(j / 2))) * (s[i + 2] - s[i]);
  for (std::int64_t k = 0; k < j; ++k)
    if (!go_on(s, factor, k)) return {};
  return s[std::size_t(j % 4)];
}
std::optional<std::int64_t> Trio::exact_count(std::int64_t most) const {
  auto speeds = first_speeds(1, from_.W_per_V);
  if (!speeds) return {};
  const Surd factor = factor_of(*speeds);
  const auto comes = [&](std::int64_t j) { return 0 < *speed(*speeds, factor, j); };
  if (exact_->q_e == 0) return count_of(std::int64_t(1) << 62U, comes);
  for (std::int64_t j = 0; j <= most; ++j) {
    if (!(0 < (*speeds)[std::size_t(j % 4)])) return j;
    if (!go_on(*speeds, factor, j) && j > largest_tie) return {};
  }
  return {};
}
std::optional<std::int64_t> Trio::count() const {
  if (at_threshold_) return at_threshold_;
  const cl_I most = cln::ash(cl_I(1), 62);
  if (exact_ && 0 < exact_->q_e) {
    // The angle is below pi sqrt(q_e)/2, so there are more than 2/sqrt(q_e) - 1 collisions.
    if (is_at_rest() && exact_->q_e < Surd(cl_RA(1) / cln::square(most))) too_many();
    // A tie of pi/h_e with a whole number is decided collision by collision, of long numbers last.
    if (exact_->q_e.bits() < 128)
      if (const auto N = exact_count(largest_tie)) return N;
  }
  const auto computed = [&]() -> cl_RA {
    const Shape s = shape();
    const FromB at_0 = start();
    if (s.q_e > 0)
      return value_of_form(generated::count_restitution<Unguarded>, s, s.q_e, s.h_e, s.step_sine,
                           at_0.V, at_0.W)
          .N_any.low();
    if (end_sign_ >= 0) return 0;
    const auto takes_place = [&](std::int64_t j) {
      return Ball(time_of(s, swing_of(s, j), at_0).reach) > 0;
    };
    return static_cast<long long>(count_of(std::int64_t(1) << 62U, takes_place));  // any_start.once
  };
  try {
    const cl_RA N = with_bits(17, computed, " to tell how many collisions there are");
    if (N == 0) return {};
    if (N >= most) too_many();
    return cln::cl_I_to_long(cln::numerator(N));
  } catch (const Undecided&) {
    if (const auto N = exact_count(INT64_MAX)) return N;
    throw;
  }
}

Trio::FromB Trio::start() const {
  const Ball V = ball_of(from_.V);
  return {V, ball_of(from_.W_per_V) * V, ball_of(from_.d_A), ball_of(from_.d_B)};
}
Ball Trio::place_of(const Ball& time, const Ball& place) const {
  return ball_of(from_.drift) * time + ball_of(from_.place) + place;
}
Ball Trio::velocity_of(const Ball& u) const { return ball_of(from_.drift) + u; }
Trio::Velocities Trio::seen(const Shape& s, std::int64_t collisions) const {
  const auto [V, W, d_A, d_B] = start();
  if (collisions == 0) return {V + W, W, 0};
  const auto& N = at_threshold_;
  const bool is_magic = N && *N % 2 == 0 && is_at_rest();  // magic.velocities
  if (is_magic && collisions == *N) return {0, 0, V};
  Velocities all = places_seen(s, swing_of(s, collisions - 1), {V, W, 0, 0}, 1);
  if (is_magic && collisions == *N - 1) all[0] = 0;
  return all;  // any_start.linear
}
std::vector<Ball> Trio::velocities(const Shape& s, std::int64_t collisions) const {
  const Velocities u = seen(s, collisions);
  std::vector<Ball> all;
  for (std::size_t i = 0; i < bodies(); ++i) all.push_back(velocity_of(u[i]));
  return all;
}
std::optional<Surd> Trio::exact_time(std::int64_t j, bool is_hard) const {
  const auto met = quotient(from_.d_A, from_.V), later = quotient(from_.d_B, from_.V);
  if (j == 0 || is_at_once_) return met;
  if (!met || !later) return {};
  // L/V sin(jh)/sin((j+1)h) later, (2j+1)h = pi
  if (is_at_rest() && at_threshold_ == 2 * j) return *met + *later;
  const auto speeds = first_speeds(1, from_.W_per_V), gaps = first_speeds(*met, *later);
  if (!is_hard || !speeds || !gaps) return {};
  const Surd factor = factor_of(*speeds);
  const auto gap = speed(*gaps, factor, j), nearing = speed(*speeds, factor, j);
  return gap && nearing ? std::optional(*gap / *nearing) : std::nullopt;  // any_start.instant
}
Trio::Collision Trio::collision(const Shape& s, std::int64_t j) const {
  const FromB from = start();
  const auto& [V, W, d_A, d_B] = from;
  const Swing c = swing_of(s, j);
  const auto exact = exact_time(j, false);
  const Ball time = exact ? ball_of(*exact) : j == 0 ? d_A / V : Ball(time_of(s, c, from).moment);
  const std::size_t right = j % 2 == 0 ? 1 : 2;
  Ball place = j == 0 ? W * time - d_B : places_seen(s, c, from, time)[1];
  if (right == bodies()) place = 0;
  const Velocities u = seen(s, j + 1);
  return {
      j + 1, right, time, place_of(time, place), velocity_of(u[right - 1]), velocity_of(u[right])};
}
std::vector<Ball> Trio::places(const Shape& s, const Ball& time, std::int64_t N) const {
  const FromB from = start();
  const auto& [V, W, d_A, d_B] = from;
  Velocities x{(V + W) * time - d_A - d_B, W * time - d_B, 0};
  if (N > 0) x = places_seen(s, swing_of(s, N - 1), from, time);
  std::vector<Ball> all;
  for (std::size_t i = 0; i < bodies(); ++i) all.push_back(place_of(time, x[i]));
  return all;
}
/// Where (V t - d_A) + (W t - d_B) r_e y_e, as in end_speed, is 0 or more (bodies.t_any).
bool Trio::has_collapsed(const Value& time) const {
  const auto met = quotient(from_.d_A, from_.V), later = quotient(from_.d_B, from_.V);
  if (met && later && time.exact()) {
    const Surd& t = *time.exact();
    if (const auto sign = end_sign(t - *met, from_.W_per_V * t - *later)) return *sign >= 0;
  }
  return collapse(shape()).time <= ball_of(time);
}
Trio::Collision Trio::collapse(const Shape& s) const {
  const auto end = end_of(s, start());
  const Ball time = end.t_any, v = velocity_of(end.v_any);
  return {0, 0, time, place_of(time, end.x_any), v, v};
}

}  // namespace magicmass::scenes
