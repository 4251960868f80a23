// SPDX-License-Identifier: GPL-2.0-or-later
// Single numbers against the oracle: the collision law alone, in rationals and intervals.
#include <cfenv>
#include <limits>

#include "src/magicmass/numbers/checks.hpp"

using namespace magicmass;
using namespace magicmass::testing;

TEST_CASE("every family is rounded right, and counted right") {
  Random random(21);
  for_families(random, 25, [&](double alpha) {
    const std::optional<Counts> counts = counts_by_oracle(alpha);
    REQUIRE(count_collisions(alpha) == counts);
    const std::optional<Terminal> terminal = accurate::terminal(alpha);
    REQUIRE(terminal.has_value() == counts.has_value());
    if (terminal) REQUIRE(*terminal == terminal_by_oracle(alpha, *counts));
    const std::int64_t n = some_cycle(random, alpha);
    INFO("n = " << n);
    REQUIRE(accurate::velocities(alpha, n) == velocities_by_oracle(alpha, n));
  });
}
TEST_CASE("errors of fast: at most 3 envelopes, and 2^-50 of its body's fastest; counts exact") {
  Random random(22);
  for_families(random, 12, [&](double alpha) {
    const std::int64_t n = some_cycle(random, alpha);
    INFO("n = " << n);
    const Velocities v = fast::velocities(alpha, n);
    CHECK(envelopes_of(v, alpha, n) <= 3);
    const std::optional<Terminal> terminal = fast::terminal(alpha);
    if (!terminal) return;
    REQUIRE(terminal->counts == counts_by_oracle(alpha));
    CHECK(envelopes_of(*terminal, alpha) <= 3);
    // The ball is fastest in the middle, B at the end.
    const double ball = velocities_by_oracle(alpha, (terminal->counts.N_A + 1) / 2).c;
    const Terminal end = terminal_by_oracle(alpha, terminal->counts);
    const Velocities exact = velocities_by_oracle(alpha, n);
    for (const double off : {v.a - exact.a, (v.b - exact.b) / end.b_t, (v.c - exact.c) / ball,
                             (v.c_prime - exact.c_prime) / ball, terminal->a_t - end.a_t,
                             (terminal->b_t - end.b_t) / end.b_t, (terminal->c_t - end.c_t) / ball})
      CHECK(std::fabs(off) <= 0x1p-50 - 0x1p-53);  // less the oracle's rounding
  });
}
TEST_CASE("doubles and ties where 1 + alpha is a power of 2") {
  for (int j = 1; j <= 53; ++j) {
    const double alpha = std::ldexp(1.0, j) - 1;
    INFO("alpha = 2^" << j << " - 1");
    REQUIRE(accurate::velocities(alpha, 1) == velocities_by_oracle(alpha, 1));
    REQUIRE(*accurate::terminal(alpha) == terminal_by_oracle(alpha, {1, 1}));
  }
  CHECK(accurate::velocities(1, 1) == Velocities{0, 1, 1, 0});
  CHECK(*accurate::terminal(1) == Terminal{{1, 1}, 0, 1, 0, 1});
  CHECK(accurate::velocities(0.3, 0) == Velocities{1, 0, 0, 0});
  CHECK(accurate::velocities(1e308, 0) == Velocities{1, 0, 0, 0});
  CHECK(accurate::velocities(0x1p-1074, 0) == Velocities{1, 0, 0, 0});
}
TEST_CASE("single numbers refuse what has no answer") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (double alpha : {0.0, -0.0, -1.0, infinity, -infinity, std::nan("")}) {
    CHECK_THROWS_AS(accurate::velocities(alpha, 0), InvalidInput);
    CHECK_THROWS_AS(fast::velocities(alpha, 1), InvalidInput);
    CHECK_THROWS_AS(accurate::terminal(alpha), InvalidInput);
    CHECK_THROWS_AS(accurate::angle(alpha), InvalidInput);
    CHECK_THROWS_AS(count_collisions(alpha), InvalidInput);
    CHECK_THROWS_AS(nearest_threshold(alpha), InvalidInput);
  }
  CHECK_THROWS_AS(accurate::ratios(0), InvalidInput);
  CHECK_THROWS_WITH(accurate::velocities(0.5, 3), "n must be from 0 to N_A = 2, got 3");
  CHECK_THROWS_WITH(fast::velocities(1.0, 2), "n must be from 0 to N_A = 1, got 2");
  CHECK_THROWS_AS(accurate::velocities(0.5, -1), InvalidInput);
  CHECK_THROWS_AS(fast::velocities(0.5, INT64_MIN), InvalidInput);
}
TEST_CASE("n ends at N_A on both sides of a magic mass ratio") {
  Random random(24);
  for (int row = 0; row < 200; ++row) {
    const std::int64_t k = some_whole(random, 0x1p55) + 1;
    const double alpha = neighbour(accurate::ratios(k).magic, std::int64_t(random() % 5) - 2);
    const std::int64_t last = counts_by_oracle(alpha)->N_A;
    INFO("alpha = " << in_hex(alpha) << ", k = " << k);
    CHECK_NOTHROW(accurate::velocities(alpha, last));
    CHECK_NOTHROW(fast::velocities(alpha, last));
    CHECK_THROWS_AS(accurate::velocities(alpha, last + 1), InvalidInput);
    CHECK_THROWS_AS(fast::velocities(alpha, last + 1), InvalidInput);
  }
}
TEST_CASE("counts end where their sum is 2^63") {
  double countable = 1e-37;
  double beyond = 1e-38;
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
  CHECK_FALSE(accurate::terminal(0x1p-1074));
}
