// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/trio_end.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

#include <cln/float.h>
#include <cln/real.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_R;
using cln::cl_RA;

/// What a cycle makes of the two approach speeds (A to C, C to B), by columns, with B taken to be at rest.
template <class Scalar>
struct SpeedMap {
  Scalar k11, k21, k12, k22;

  explicit SpeedMap(const LinearMap<Scalar>& cycle) {
    const auto first = apply(cycle, BodyVelocities<Scalar>{Scalar(1), Scalar(0), Scalar(0)});
    const auto second = apply(cycle, BodyVelocities<Scalar>{Scalar(1), Scalar(0), Scalar(1)});
    k11 = first.a - first.c;
    k21 = first.c - first.b;
    k12 = second.a - second.c;
    k22 = second.c - second.b;
  }
  /// Of its characteristic polynomial.
  Scalar discriminant() const {
    const Scalar difference = k11 - k22;
    const Scalar off = k12 * k21;
    return difference * difference + (off + off) + (off + off);
  }
};

/// How many halvings or doublings x > 0 is away from 1.
long magnitude(const cl_RA& x) {
  return std::labs(static_cast<long>(cln::integer_length(cln::numerator(x))) -
                   static_cast<long>(cln::integer_length(cln::denominator(x))));
}

Interval at(const ExactValue& value, long precision) { return enclosure(value)(precision); }

Line<Interval> enclosed_line(const ExactLine& line, long precision) {
  Line<Interval> intervals = converted<Interval>(
      line.geometry(), [&](const FieldNumber& x) { return x.enclosed(precision); });
  for (const ExactValue& mass : line.masses) intervals.masses.push_back(at(mass, precision));
  return intervals;
}

}  // namespace

bool is_theorems_start(const ExactLine& line) {
  const bool trio = line.bodies() == 3 && !line.left_wall && !line.right_wall;
  const bool wall = line.bodies() == 2 && !line.left_wall && line.right_wall;
  if (!trio && !wall) return false;
  const FieldNumber target = wall ? FieldNumber(0) : line.velocity(2);
  const FieldNumber ahead = wall ? *line.right_wall : line.position(2);
  return line.velocity(1) == target && line.velocity(1) < line.velocity(0) &&
         line.position(1) < ahead;
}

TrioEnd::TrioEnd(const ExactLine& line, const std::optional<cl_I>& known, long further_bits)
    : line_(line), further_bits_(further_bits) {
  if (line.one_field) {
    const Line<FieldNumber> exactly = line.together();
    exact_.emplace(exactly);
    for (const FieldNumber& mass : exactly.masses)
      bits_ = std::max(bits_, 2 * mass.bits() * static_cast<long>(mass.coefficients().size()));
    bits_ += 2 * exactly.restitution.bits();
  }
  find_collapse();
  if (collapse_) return;
  contacts_ = known ? *known
                    : first_below(
                          1, {},
                          [](const TrioState<Interval>& s, const cl_I& j) {
                            return TrioPowers<Interval>::approach(s, j).speed;
                          },
                          [](const TrioState<FieldNumber>& s, const cl_I& j) {
                            return TrioPowers<FieldNumber>::approach(s, j).speed;
                          });
}

bool TrioEnd::stays_short(const cl_I& j) const { return exact_ && j * bits_ < 20000; }

TrioPowers<Interval> TrioEnd::enclosed(long precision) const {
  return TrioPowers<Interval>(enclosed_line(line_, precision));
}

cl_I TrioEnd::first_below(int least, const std::optional<cl_I>& most, const OfInterval& at,
                          const OfExact& exactly) const {
  struct Open {};
  const auto search = [&](const TrioPowers<Interval>& powers) {
    const auto holds = [&](const TrioState<Interval>& state, const cl_I& j) {
      if (most && j >= *most) return false;
      const Sign sign = at(state, j).sign();
      if (sign != Sign::open)
        return (sign == Sign::positive ? 1 : sign == Sign::negative ? -1 : 0) >= least;
      if (!stays_short(j)) throw Open{};
      return exactly(exact_->after(j), j).sign() >= least;
    };
    const auto moved = [](const LinearMap<Interval>& map, const TrioState<Interval>& state) {
      return TrioState<Interval>{apply(map, state.v), apply(map, state.x)};
    };
    TrioState<Interval> state = powers.start();
    if (!holds(state, 0)) return cl_I(0);
    std::vector<LinearMap<Interval>> squares{powers.cycle()};
    while (
        holds(moved(squares.back(), state), cln::ash(cl_I(1), static_cast<long>(squares.size()))))
      squares.push_back(compose(squares.back(), squares.back()));
    cl_I cycles = 0;
    for (std::size_t i = squares.size(); i-- > 0;) {
      const TrioState<Interval> further = moved(squares[i], state);
      const cl_I there = cycles + cln::ash(cl_I(1), static_cast<long>(i));
      if (!holds(further, 2 * there)) continue;
      state = further;
      cycles = there;
    }
    const cl_I j = 2 * cycles + 1;
    return holds(powers.once_more(state), j) ? cl_I(j + 1) : j;
  };
  const long start = 64 + 2 * bits_;
  for (long precision = start; precision <= start + further_bits_; precision *= 2) {
    try {
      return search(enclosed(precision));
    } catch (const Open&) {
    } catch (const Undecided&) {  // a division reaches 0: more precision
    }
  }
  throw Undecided("whether two bodies approach is closer than " +
                  std::to_string(start + further_bits_) + " bits can tell");
}

std::vector<double> TrioEnd::nearest_doubles(const cl_I& j, const Enclosures& at) const {
  const auto rounded =
      [](const std::vector<Interval>& values) -> std::optional<std::vector<double>> {
    std::vector<double> nearest_to;
    for (const Interval& value : values) {
      const auto low = nearest<double>(value.low()), high = nearest<double>(value.high());
      if (low != high) return std::nullopt;
      nearest_to.push_back(low + 0.0);  // no -0
    }
    return nearest_to;
  };
  const long start = 128 + 2 * bits_ + 4 * static_cast<long>(cln::integer_length(j));
  for (long precision = start; precision <= start + further_bits_; precision *= 2)
    if (const auto values = rounded(at(enclosed(precision), precision))) return *values;
  throw Undecided("between which two doubles a value lies is closer than " +
                  std::to_string(start + further_bits_) + " bits can tell");
}

std::optional<BodyVelocities<FieldNumber>> TrioEnd::exact_velocities(const cl_I& j) const {
  if (!stays_short(j)) return std::nullopt;
  return exact_->velocities_after(j);
}

BodyVelocities<double> TrioEnd::velocities(const cl_I& j) const {
  if (const auto exactly = exact_velocities(j))
    return {nearest_double(exactly->a), nearest_double(exactly->b), nearest_double(exactly->c)};
  const auto v = nearest_doubles(j, [&](const TrioPowers<Interval>& powers, long) {
    const BodyVelocities<Interval> after = powers.velocities_after(j);
    return std::vector{after.a, after.b, after.c};
  });
  return {v[0], v[1], v[2]};
}

TrioEnd::Contact TrioEnd::contact(const cl_I& j) const {
  const BodyVelocities<double> v = velocities(j + 1);
  if (stays_short(j)) {
    const auto next = exact_->approach(j);
    const FieldNumber time = next.gap / next.speed;
    const TrioState<FieldNumber> s = exact_->after(j);
    return {nearest_double(time), nearest_double(s.x.c + s.v.c * time), v};
  }
  const auto met = nearest_doubles(j, [&](const TrioPowers<Interval>& powers, long) {
    const TrioState<Interval> s = powers.after(j);
    const auto next = TrioPowers<Interval>::approach(s, j);
    const Interval time = next.gap / next.speed;
    return std::vector{time, s.x.c + s.v.c * time};
  });
  return {met[0], met[1], v};
}

BodyPositions<double> TrioEnd::positions(const FieldNumber& time) const {
  if (collapse_)
    throw Undecided("positions at given times are not offered where there is a collapse");
  // Contact j, the first being 0, has happened where gap <= speed * time; positions are continuous there.
  const cl_I j = first_below(
      0, contacts_,
      [&](const TrioState<Interval>& s, const cl_I& i) {
        const auto next = TrioPowers<Interval>::approach(s, i);
        return next.speed * time.enclosed(s.v.a.precision()) - next.gap;
      },
      [&](const TrioState<FieldNumber>& s, const cl_I& i) {
        const auto next = TrioPowers<FieldNumber>::approach(s, i);
        return next.speed * time - next.gap;
      });
  if (stays_short(j)) {
    const TrioState<FieldNumber> s = exact_->after(j);
    return {nearest_double(s.x.a + s.v.a * time), nearest_double(s.x.b + s.v.b * time),
            nearest_double(s.x.c + s.v.c * time)};
  }
  const auto x = nearest_doubles(j, [&](const TrioPowers<Interval>& powers, long precision) {
    const TrioState<Interval> s = powers.after(j);
    const Interval then = time.enclosed(precision);
    return std::vector{s.x.a + s.v.a * then, s.x.b + s.v.b * then, s.x.c + s.v.c * then};
  });
  return {x[0], x[1], x[2]};
}

void TrioEnd::find_collapse() {
  if (line_.restitution == FieldNumber(1)) return;
  std::optional<int> sign;
  if (exact_) sign = SpeedMap<FieldNumber>(exact_->cycle()).discriminant().sign();
  long precision = 256;
  for (; !sign && precision <= further_bits_; precision *= 2) {
    const Sign seen = SpeedMap<Interval>(enclosed(precision).cycle()).discriminant().sign();
    if (seen != Sign::open) sign = seen == Sign::negative ? -1 : 1;
  }
  if (!sign) throw Undecided("the scene is too close to the threshold of inelastic collapse");
  if (*sign < 0) return;
  // Numbers with some 200 digits to spare, and those that differences lose to masses and a restitution far from 1: the
  // answer is rounded to a double.
  long bits = 2048;
  if (line_.restitution.is_rational()) bits += 4 * magnitude(line_.restitution.rational());
  for (const ExactValue& mass : line_.masses)
    if (mass.is_rational()) bits += 4 * magnitude(mass.rational);
  const auto middle = [](const Interval& x) { return (x.low() + x.high()) / 2; };
  const TrioPowers<Interval> powers = enclosed(bits);
  const SpeedMap<Interval> map(powers.cycle());
  const auto& x = powers.start().x;
  const auto& v = powers.start().v;
  const cl_RA k11 = middle(map.k11), k21 = middle(map.k21), k22 = middle(map.k22);
  const cl_RA inner = *sign == 0 ? cl_RA(0) : middle(map.discriminant());
  const cl_R root =
      cln::sqrt(cln::cl_float(inner, cln::float_format(static_cast<unsigned long>(bits / 3))));
  const cl_R weight =
      (k22 - k11 + root) / 2;  // the larger eigenvalue, less k11; the other weight is k21
  const cl_R gaps = k21 * middle(x.c - x.a) + weight * middle(x.b - x.c);
  const cl_R speeds = k21 * middle(v.a - v.c) + weight * middle(v.c - v.b);
  const cl_RA time = cln::rational(gaps / speeds);
  // All meet in one place: the wall, or the centre of mass, which moves uniformly.
  cl_RA place = middle(x.b);
  if (!line_.right_wall) {
    const Line<Interval> line = enclosed_line(line_, bits);
    cl_RA mass = 0, moment = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const cl_RA m = middle(line.masses[i]);
      mass = mass + m;
      moment = moment + m * (middle(line.positions[i]) + middle(line.velocities[i]) * time);
    }
    place = moment / mass;
  }
  collapse_ = Collapse{nearest<double>(time), nearest<double>(place)};
  if (!std::isfinite(collapse_->time) || !std::isfinite(collapse_->position))
    throw Undecided("the time or place of the collapse does not fit a double; choose other units");
}

}  // namespace magicmass::reference
