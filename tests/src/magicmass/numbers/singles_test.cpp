// Single numbers of both tiers against the oracle: the collision law, in rationals and intervals.
#include <map>

#include <cln/real.h>

#include "rows.hpp"
#include "src/magicmass/numbers/families.hpp"
#include "src/magicmass/numbers/tiers.hpp"

using namespace magicmass;
using namespace magicmass::testing;

namespace {
using Numbers = std::vector<double>;
Numbers values_of(const Velocities& v) { return {v.a, v.b, v.c, v.c_prime}; }
Numbers values_of(const Terminal& t) { return {t.a_t, t.b_t, t.c_t, t.rho}; }
Numbers values_of(const Collision& c) { return {c.t, c.s}; }

/// The largest |got - exact|/envelope; a zero has no envelope and is to be met.
double in_envelopes(const Numbers& got, double alpha, const auto& quantity) {
  const oracle::MassRatio ratio = oracle::ratio(oracle::exact(alpha));
  const auto exact = oracle::certain(ratio, quantity, oracle::to_within(120));
  const Numbers envelopes = oracle::envelopes(ratio, quantity, exact);
  double most = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double error = oracle::ulp_error(got[i], exact[i]);
    if (error > 0) most = std::max(most, std::isinf(envelopes[i]) ? 1e300 : error / envelopes[i]);
  }
  return most;
}

// What both tiers say against the oracle: accurate is rounded right; fast's worst in envelopes.
double velocities(double alpha, std::int64_t n) {
  const oracle::OfCycle exact(whole(n));
  REQUIRE(values_of(accurate::velocities(alpha, n)) == nearest_doubles(alpha, exact));
  return in_envelopes(values_of(fast::velocities(alpha, n)), alpha, exact);
}
double collision(double alpha, std::int64_t j) {
  const oracle::AtCollision exact(whole(j));
  REQUIRE(values_of(accurate::collision(alpha, j)) == nearest_doubles(alpha, exact));
  return in_envelopes(values_of(fast::collision(alpha, j)), alpha, exact);
}
double terminal(double alpha, std::int64_t) {
  const std::optional<Counts> counts = counts_by_oracle(alpha);
  REQUIRE(count_collisions(alpha) == counts);
  for (const Calls& tier : tiers) {
    const std::optional<Terminal> t = tier.terminal(alpha);
    REQUIRE(t.has_value() == counts.has_value());
    if (t) REQUIRE(t->counts == *counts);
  }
  if (!counts) return 0;
  REQUIRE(values_of(*accurate::terminal(alpha)) == nearest_doubles(alpha, at_end(*counts)));
  return in_envelopes(values_of(*fast::terminal(alpha)), alpha, at_end(*counts));
}
/// In ulp.
double off(double got, double exact) {
  return std::fabs(got - exact) / (std::nextafter(exact, HUGE_VAL) - exact);
}
/// psi = 2 atan(sqrt(alpha (2 + alpha))), from floats of 300 digits.
double angle(double alpha, std::int64_t) {
  const cln::cl_R x = cln::cl_float(oracle::exact(alpha), cln::float_format(300));
  const double exact = oracle::nearest(cln::rational(2 * cln::atan(cln::sqrt(x * (x + 2)))));
  REQUIRE(accurate::angle(alpha) == exact);
  return off(fast::angle(alpha), exact);
}
double ratios(double, std::int64_t k) {
  const auto rounded = [](const oracle::MassRatio& ratio) {
    return oracle::certain(ratio, oracle::Itself(), oracle::to_double())[0];
  };
  const Ratios exact{rounded(oracle::magic(whole(k))), rounded(oracle::deficient(whole(k)))};
  REQUIRE(accurate::ratios(k) == exact);
  const Ratios near = fast::ratios(k);
  return std::max(off(near.magic, exact.magic), off(near.deficient, exact.deficient));
}
/// What is held, and up to which error of fast.
const std::map<std::string, std::pair<double (*)(double alpha, std::int64_t index), double>>
    quantities{{"velocities", {velocities, 3}},
               {"terminal", {terminal, 3}},
               {"collision", {collision, 3}},
               {"ratios", {ratios, 1}},
               {"angle", {angle, 1}}};

/// Errors of fast are at most 2^-50 of its body's fastest: the ball's midway, B's at the end.
void check_shares(double alpha, std::int64_t n) {
  const std::optional<Terminal> got = fast::terminal(alpha);
  if (!got) return;
  const Velocities v = fast::velocities(alpha, n), exact = velocities_by_oracle(alpha, n);
  const Terminal end = terminal_by_oracle(alpha, got->counts);
  const double ball = velocities_by_oracle(alpha, (got->counts.N_A + 1) / 2).c;
  for (const double error : {v.a - exact.a, (v.b - exact.b) / end.b_t, (v.c - exact.c) / ball,
                             (v.c_prime - exact.c_prime) / ball, got->a_t - end.a_t,
                             (got->b_t - end.b_t) / end.b_t, (got->c_t - end.c_t) / ball})
    CHECK(std::fabs(error) <= 0x1p-50 - 0x1p-53);  // less the oracle's rounding
}

/// (x - alpha)/alpha.
struct Distance {
  cln::cl_RA x;
  cln::cl_I j = 0;
  std::vector<cln::cl_RA> operator()(const cln::cl_RA& alpha) const {
    return {(x - alpha) / alpha};
  }
  std::vector<oracle::Interval> operator()(const oracle::Interval& alpha) const {
    return {(oracle::Interval(x, alpha.precision()) - alpha) / alpha};
  }
};
/// Of alpha from alpha_1, beta_1, alpha_2, beta_2, ..., which become smaller.
double distance_by_oracle(double alpha, std::int64_t place) {
  const cln::cl_I k = whole(place / 2 + 1);
  const oracle::MassRatio threshold = place % 2 == 0 ? oracle::magic(k) : oracle::deficient(k);
  return oracle::certain(threshold, Distance{oracle::exact(alpha)}, oracle::to_double())[0];
}
void check_threshold(double alpha) {
  const std::optional<Threshold> t = nearest_threshold(alpha);
  REQUIRE(t.has_value() == counts_by_oracle(alpha).has_value());
  if (!t) return;
  const std::int64_t place = 2 * t->k - (t->is_magic ? 2 : 1);
  REQUIRE(t->distance == distance_by_oracle(alpha, place));
  for (const std::int64_t beside : {std::max(place - 1, std::int64_t{0}), place + 1})
    CHECK(std::fabs(distance_by_oracle(alpha, beside)) >= std::fabs(t->distance));
}
}  // namespace

TEST_CASE("of every family accurate is rounded right, fast close, and counts are exact") {
  Random random(21);
  for (const Family& family : families)
    for (int row = 0; row < 10; ++row) {
      const double alpha = family.alpha(random);
      const std::int64_t n = some_cycle(random, alpha), j = some_collision(random, alpha);
      INFO(family.name << ", alpha = " << in_hex(alpha) << ", n = " << n << ", j = " << j);
      CHECK(velocities(alpha, n) <= 3);
      CHECK(terminal(alpha, 0) <= 3);
      CHECK(collision(alpha, j) <= 4);
      CHECK(angle(alpha, 0) <= 1);
      if (row % 2 == 0) check_shares(alpha, n);
      if (row % 3 == 0) check_threshold(alpha);
    }
}
TEST_CASE("pinned inputs: where the first edition's single numbers, arrays and stream were worst") {
  const auto pins = rows_of("generated/worst_inputs.tsv", 3);
  CHECK(pins.size() == 114);
  for (const auto& pin : pins) {
    const std::string& quantity = pin[0];
    INFO(quantity << " at " << pin[1] << ", " << pin[2]);
    Table row(1);
    const double alpha = row.alpha[0] = std::strtod(pin[1].c_str(), nullptr);
    const std::int64_t n = row.n[0] = std::stoll(pin[2]);
    const auto& [held, most] = quantities.at(quantity);
    CHECK(held(alpha, n) <= most);
    for (const Calls& tier : tiers) {
      row.fill(tier);
      if (quantity == "velocities") CHECK(row.velocities(0) == tier.velocities(alpha, n));
      if (quantity == "terminal") CHECK(row.terminal(0) == tier.terminal(alpha));
    }
  }
}
TEST_CASE("ratios are rounded right") {
  Random random(31);
  CHECK(accurate::ratios(1).magic == 1);
  for (int row = 0; row < 150; ++row)
    CHECK(ratios(0, row < 20 ? row + 1 : some_whole(random, row % 2 == 0 ? 1e6 : 0x1p62)) <= 1);
  for (const std::int64_t k : {(std::int64_t{1} << 50) + 1, INT64_MAX}) CHECK(ratios(0, k) <= 1);
}
TEST_CASE("collisions at rational alpha, all of them") {
  for (double alpha : {1 / 2.0, 3 / 8.0, 1 / 4.0, 3 / 64.0, 5 / 1024.0, 1 / 4096.0})
    for (std::int64_t j = 0; j < number_of_collisions(alpha); ++j) CHECK(collision(alpha, j) <= 4);
}
TEST_CASE("doubles and ties: 1 + alpha a power of 2, the first collisions, leading orders") {
  for (int j = 1; j <= 53; ++j) {
    INFO("alpha = 2^" << j << " - 1");
    velocities(std::ldexp(1.0, j) - 1, 1);
    terminal(std::ldexp(1.0, j) - 1, 0);
  }
  for (double alpha : {0x1p-1074, 0x1p-400, 0x1p-53, 3 * 0x1p-53, 0.5, 1.0, neighbour(1, -1), 3.0,
                       0x1p53 + 2, 0x1p400, 0x1.fffffffffffffp1023})
    for (std::int64_t j : {0, 1}) CHECK(collision(alpha, j) <= 4);
  for (double alpha : {0x1p-1074, 0x1.5acd9597016aap-968, 0x1p-400, 0x1p-130})
    for (std::int64_t j : {2L, 3L, 7L, (1L << 53) - 1, (1L << 54) - 1, (1L << 54) + 1, INT64_MAX})
      CHECK(collision(alpha, j) <= 4);
}
TEST_CASE("n ends at N_A, j before N_A + N_B, on both sides of a threshold") {
  Random random(24);
  for (int row = 0; row < 60; ++row) {
    const double threshold =
        row < 3 ? std::array{0x1.1c7397cb68b7ep-18, 0x1.bc7fb47556f22p-29, 1.0}[std::size_t(row)]
                : accurate::ratios(some_whole(random, 0x1p55) + 1).magic;
    for (std::int64_t step = -2; step <= 2; ++step) {
      const double alpha = neighbour(threshold, step);
      const Counts counts = counts_by_oracle(alpha).value();
      INFO("alpha = " << in_hex(alpha));
      if (row < 23) check_threshold(alpha);
      const std::int64_t last = counts.N_A, number = last + counts.N_B;
      for (std::int64_t j : {number - 2, number - 1}) CHECK(collision(alpha, j) <= 4);
      for (const Calls& tier : tiers) {
        CHECK_NOTHROW(tier.velocities(alpha, last));
        CHECK_THROWS_AS(tier.velocities(alpha, last + 1), InvalidInput);
        CHECK_THROWS_AS(tier.collision(alpha, number), InvalidInput);
      }
    }
  }
}
TEST_CASE("what has no answer is refused") {
  for (const Calls& tier : tiers) {
    for (double alpha : {0.0, -0.0, -1.0, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
      CHECK_THROWS_AS(tier.velocities(alpha, 0), InvalidInput);
      CHECK_THROWS_AS(tier.terminal(alpha), InvalidInput);
      CHECK_THROWS_AS(tier.collision(alpha, 0), InvalidInput);
      CHECK_THROWS_AS(tier.angle(alpha), InvalidInput);
      CHECK_THROWS_AS(count_collisions(alpha), InvalidInput);
      CHECK_THROWS_AS(nearest_threshold(alpha), InvalidInput);
    }
    CHECK_THROWS_AS(tier.ratios(0), InvalidInput);
    CHECK_THROWS_WITH(tier.velocities(0.5, 3), "n must be from 0 to N_A = 2, got 3");
    CHECK_THROWS_WITH(tier.velocities(1.0, 2), "n must be from 0 to N_A = 1, got 2");
    CHECK_THROWS_WITH(tier.collision(1.0, 2), "j must be from 0 to N_A + N_B - 1 = 1, got 2");
    CHECK_THROWS_WITH(tier.collision(0.5, 3), "j must be from 0 to N_A + N_B - 1 = 2, got 3");
    CHECK_THROWS_AS(tier.collision(1e300, INT64_MAX), InvalidInput);
    for (const std::int64_t below : {std::int64_t{-1}, INT64_MIN}) {
      CHECK_THROWS_AS(tier.velocities(0.5, below), InvalidInput);
      CHECK_THROWS_AS(tier.collision(0.5, below), InvalidInput);
    }
  }
}
TEST_CASE("counts end where their sum is 2^63") {
  double countable = 1e-37, beyond = 1e-38;
  while (neighbour(beyond, 1) < countable) {
    const double middle = neighbour(
        beyond, (std::bit_cast<std::int64_t>(countable) - std::bit_cast<std::int64_t>(beyond)) / 2);
    (count_collisions(middle) ? countable : beyond) = middle;
  }
  CHECK(counts_by_oracle(countable) == count_collisions(countable));
  CHECK_FALSE(counts_by_oracle(beyond));
  CHECK_THAT(countable, WithinRel(5.8e-38, 0.01));
  // N_A alone still fits there.
  const auto last = cln::cl_I_to_long(oracle::count_collisions(oracle::exact(beyond)).N_A);
  CHECK_NOTHROW(accurate::velocities(beyond, last));
  CHECK_THROWS_AS(accurate::velocities(beyond, last + 1), InvalidInput);
  CHECK_NOTHROW(accurate::velocities(1.4e-38, INT64_MAX));
}
TEST_CASE("errors in units in the last place are seen") {
  Numbers v = values_of(accurate::velocities(0.01, 3));
  const oracle::OfCycle exact(3);
  CHECK(in_envelopes(v, 0.01, exact) <= 1);
  v[2] = neighbour(v[2], 1);
  CHECK(v != nearest_doubles(0.01, exact));
  v[2] = neighbour(v[2], 999);
  CHECK(in_envelopes(v, 0.01, exact) > 4);
}
