// Doubles and exact rationals at the ends of the range, and errors between them; ties and all
// doubles in between are in what the report measures. Intervals hold the result, and hardly more.
// Then the oracle against the simulator in exact rationals, and against known values.
#include <cmath>
#include <random>

#include "catch.hpp"
#include "magicmass/oracle/certain.hpp"
#include "magicmass/simulator/three_bodies.hpp"

using namespace magicmass::oracle;
using Limits = std::numeric_limits<double>;
using Rationals = std::vector<cl_RA>;

namespace {

bool holds(const Interval& interval, const cl_RA& x) {
  return interval.low() <= x && x <= interval.high();
}

/// Within 2^(bits - p) at each end.
bool is_tight(const Interval& interval, const cl_RA& x, long bits) {
  const cl_RA step = cl_RA(cln::ash(cl_I(1), bits)) / cln::ash(cl_I(1), interval.precision());
  return x - interval.low() <= step && interval.high() - x <= step;
}

/// Velocities (a, b, c) after collisions: by powers of a cycle's maps, and as the simulator steps.
std::pair<Rationals, Rationals> ends_of(const Cycle<cl_RA>& cycle, const cl_RA& alpha, int most) {
  magicmass::simulator::ThreeBodies<cl_RA> bodies(alpha);
  int collisions = 0;
  while (collisions < most && bodies.step()) ++collisions;
  const Velocity<cl_RA> v = after_collisions(cycle, cl_I(collisions));
  const auto& [A, C, B] = bodies.bodies();
  return {{v(0), v(1), v(2)}, {A.velocity, B.velocity, C.velocity}};
}

/// Momentum and energy of every motion.
bool conserves(const Map<cl_RA>& map, const cl_RA& alpha) {
  const Velocity<cl_RA> masses(1, 1, alpha);
  const Map<cl_RA> M = masses.asDiagonal();
  const Map<cl_RA> energy = map.transpose() * M * map;
  const Velocity<cl_RA> momentum = map.transpose() * masses;
  return energy == M && momentum == masses;
}

}  // namespace

TEST_CASE("infinities, and what rounds to them", "[exam]") {
  CHECK_THROWS_AS(exact(Limits::infinity()), std::invalid_argument);
  CHECK_THROWS_AS(exact(Limits::quiet_NaN()), std::invalid_argument);
  const cl_RA tiny = exact(Limits::denorm_min());
  const cl_RA overflow = exact(Limits::max()) + exact(0x1p970);
  CHECK(nearest(overflow) == Limits::infinity());
  CHECK(nearest(overflow - tiny) == Limits::max());
  CHECK(nearest(-overflow * overflow) == -Limits::infinity());
}

TEST_CASE("the ulp is the spacing in the exact value's binade", "[exam]") {
  CHECK(ulp_error(1, exact(1 - 0x1p-53)) == 1);
  CHECK(ulp_error(1, exact(1 + 0x1p-52)) == 1);
  CHECK(ulp_error(0.5, cl_RA(1) / 3) == nearest((cl_RA(1) / 6) / exact(0x1p-54)));
  CHECK(ulp_error(Limits::denorm_min(), 0) == 1);
  CHECK(ulp_error(Limits::max(), 2 * exact(0x1p1023)) == 1);
  CHECK(std::isinf(ulp_error(Limits::infinity(), 1)));
  CHECK(std::isinf(ulp_error(Limits::quiet_NaN(), 1)));
}

TEST_CASE("an operation encloses the exact result", "[check]") {
  std::mt19937_64 random(2);
  const auto draw = [&] {
    const auto above = static_cast<long>(random() % 2001) - 1000;
    return cl_RA(above) / static_cast<long>(1 + random() % 97);
  };
  for (int i = 0; i < 500; ++i) {
    const cl_RA x = draw(), y = draw();
    const Interval u(x, 40), v(y, 60);
    CHECK((holds(u + v, x + y) && is_tight(u + v, x + y, 21)));
    CHECK((holds(u - v, x - y) && is_tight(u - v, x - y, 21)));
    CHECK((holds(u * v, x * y) && is_tight(u * v, x * y, 31)));
    if (v.sign() == Sign::positive || v.sign() == Sign::negative) CHECK(holds(u / v, x / y));
    const Interval wide(cln::min(x, y), cln::max(x, y), 10);
    const cl_RA z = draw(), w = draw();
    const Interval other(cln::min(z, w), cln::max(z, w), 12);
    for (const cl_RA& corner : {x, y}) {
      CHECK((holds(wide * other, corner * z) && holds(wide * other, corner * w)));
      CHECK((holds(wide - other, corner - z) && holds(wide - other, corner - w)));
    }
  }
}

TEST_CASE("signs are certain or open", "[exam]") {
  const cl_RA third = cl_RA(1) / 3;
  CHECK(Interval(third, 8).sign() == Sign::positive);
  CHECK(Interval(third / 1000, 8).sign() == Sign::open);
  CHECK(Interval(-third, 8).sign() == Sign::negative);
  CHECK(Interval(0).sign() == Sign::zero);
  CHECK_THROWS_AS(Interval(1) / Interval(0), Undecided);
  CHECK_THROWS_AS(Interval(1) / Interval(third / 1000, 8), Undecided);
  CHECK(holds(Interval(1) / Interval(-third, 8), -3));
}

TEST_CASE("powers of the collision map are what stepping gives", "[check]") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 60; ++i) {
    const cl_RA above = 1 + static_cast<long>(random() % 60);
    const cl_RA alpha = above / (1 + static_cast<long>(random() % 400));
    const Cycle<cl_RA> cycle = cycle_of(alpha);
    CHECK(conserves(cycle.with_A, alpha));
    CHECK(conserves(cycle.with_B, alpha));
    const auto [by_powers, by_steps] = ends_of(cycle, alpha, i);
    CHECK(by_powers == by_steps);
    const Rationals terminal = AtEnd(count_collisions(alpha))(alpha);
    const Rationals last = ends_of(cycle, alpha, 1000).second;
    CHECK(terminal == Rationals{last[0], last[1], last[2], last[1] * last[1]});
  }
}

TEST_CASE("the simulator in doubles counts right or says that it may not", "[check]") {
  std::mt19937_64 random(7);
  int wrong = 0, silent = 0;
  for (int i = 0; i < 300; ++i) {
    const auto k = static_cast<long>(2 + random() % 400);
    const MassRatio threshold = i % 2 == 0 ? magic(k) : deficient(k);
    const double beside = nearest(threshold.enclosed(200).low());
    const auto steps = static_cast<double>(random() % 9) - 4;
    const double alpha = beside * (1 + steps * 0x1p-52);
    magicmass::simulator::ThreeBodies<double> bodies(alpha);
    int collisions = 0;
    while (bodies.step()) ++collisions;
    const Counts counts = count_collisions(exact(alpha));
    const bool is_right = counts.N_A + counts.N_B == collisions;
    wrong += is_right ? 0 : 1;
    silent += is_right || bodies.near_ties() > 0 ? 0 : 1;
  }
  CHECK(wrong > 0);
  CHECK(silent == 0);
}

TEST_CASE("known velocities, and what is no mass ratio", "[exam]") {
  const Rationals start{1, 0, 0, 0};
  CHECK(OfCycle(0)(cl_RA(1) / 3) == start);
  CHECK(OfCycle(1)(cl_RA(1)) == Rationals{0, 1, 1, 0});
  const cl_RA third = cl_RA(1) / 3;
  CHECK(OfCycle(1)(third) ==
        Rationals{third * 3 / 2, third * 9 / 4, 3 * third * 3 / 2, -third * 9 / 4});
  CHECK(AtEnd({1, 1})(cl_RA(1)) == Rationals{0, 1, 0, 1});
  CHECK_THROWS_AS(ratio(0), std::invalid_argument);
  for (const int none : {0, -1}) CHECK_THROWS_AS(count_collisions(none), std::invalid_argument);
  CHECK(exact_length(cl_RA(1) / 7, 100) == 200);  // a denominator of 4 in each collision
}

TEST_CASE("long numbers are rounded as the exact ones are", "[check]") {
  const cl_RA alpha = exact(0x1.1c7397cb68b7ep-18);
  const OfCycle quantity(539);  // 123,000 bits: past what is rounded from the number itself
  const Rationals values = quantity(alpha);
  const auto doubles = certain(ratio(alpha), quantity, to_double());
  const auto within = certain(ratio(alpha), quantity, to_within(90));
  for (std::size_t k = 0; k < values.size(); ++k) {
    CHECK(doubles[k] == nearest(values[k]));
    CHECK(cln::abs(within[k] / values[k] - 1) < exact(0x1p-89));
  }
}

TEST_CASE("a rounding is certain up to a width", "[exam]") {
  const cl_RA step = exact(0x1p-10), tiny = exact(0x1p-200);
  CHECK(to_within(10).common(1, 1 + step - tiny) == cl_RA(1));
  CHECK_FALSE(to_within(10).common(1, 1 + step));
  CHECK_FALSE(to_within(10).common(-tiny, tiny));
  CHECK(to_within(10).common(0, 0) == cl_RA(0));
  CHECK(to_double().common(1, 1 + exact(0x1p-53)) == 1.0);
  CHECK_FALSE(to_double().common(1, 1 + exact(0x1p-53) + tiny));
}

TEST_CASE("a tie is settled on the number itself", "[exam]") {
  const cl_RA a = cl_RA(1) / 2 + exact(0x1p-54);  // while no enclosure of alpha is a point
  CHECK(certain(ratio((1 - a) / (1 + a)), OfCycle(1), to_double())[0] == 0.5);
}

TEST_CASE("ratios by name", "[exam]") {
  for (long precision = 1; precision < 200; ++precision)  // sqrt(5) - 2 and sqrt(2) - 1
    for (const auto& [alpha, less, square] : {std::tuple{magic(2), 2, 5}, {deficient(1), 1, 2}}) {
      const Interval root = alpha.enclosed(precision) + Interval(less);
      CHECK((cln::square(root.low()) <= square && square <= cln::square(root.high())));
    }
  CHECK(certain(magic(1), Itself(), to_double()) == std::vector{1.0});
  CHECK_THAT(certain(magic(1000000), Itself(), to_double())[0], WithinRel(1.2337e-12, 1e-5));
  // A and the ball end at rest: that is the nearest double, but no relative error shows it.
  CHECK(certain(magic(2), AtEnd({2, 2}), to_double()) == std::vector{0.0, 1.0, 0.0, 1.0});
  CHECK_THROWS_AS(certain(magic(2), AtEnd({2, 2}), to_within(60)), Undecided);
  const double b_1 = certain(magic(2), OfCycle(1), to_double())[1];
  const double alpha = std::sqrt(5.0) - 2;
  CHECK_THAT(b_1, WithinRel(4 * alpha / ((1 + alpha) * (1 + alpha)), 1e-14));
}

TEST_CASE("an envelope is what rounding alpha alone costs", "[exam]") {
  CHECK(envelopes(ratio(1), Itself()) == std::vector{0.5});
  // b_1 = 4 alpha/(1 + alpha)^2 and c'_1, whose condition is larger than 1
  const cl_RA alpha = cl_RA(9) / 10;
  const auto first = envelopes(ratio(alpha), OfCycle(1));
  CHECK(first[1] == 0.5);
  CHECK_THAT(first[3], WithinRel(std::fabs(-2 * 0.9 / 1.9 - 0.9 / 0.1) / 2, 1e-9));
  // For small alpha a_n is cos^2(n h), h = sqrt(2 alpha): cond = n h tan(n h).
  const double h = std::sqrt(2.0) * 0x1p-20;
  for (const int n : {1000, 500000, 1000000}) {
    const double expected = std::fmax(0.5, std::fabs(n * h * std::tan(n * h)) / 2);
    CHECK_THAT(envelopes(ratio(exact(0x1p-40)), OfCycle(n))[0], WithinRel(expected, 1e-4));
  }
  const auto at_zero = envelopes(ratio(1), OfCycle(1));  // a_1 = c'_1 = 0
  CHECK(at_zero[0] == std::numeric_limits<double>::infinity());
  CHECK(at_zero[1] == 0.5);
}
