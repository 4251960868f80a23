// SPDX-License-Identifier: GPL-2.0-or-later
// Times and distances of single collisions against the oracle, which moves the three bodies.
#include "magicmass/numbers/kernels.hpp"
#include "src/magicmass/numbers/checks.hpp"

using namespace magicmass;
using namespace magicmass::testing;

namespace {
/// N_A + N_B, or INT64_MAX.
std::int64_t number_of_collisions(double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  return counts ? counts->N_A + counts->N_B : INT64_MAX;
}
std::int64_t some_collision(Random& random, double alpha) {
  return some_index(random, number_of_collisions(alpha) - 1);
}
}  // namespace

TEST_CASE("collisions of every family are rounded right, and fast within 4 envelopes") {
  Random random(31);
  for_families(random, 25,
               [&](double alpha) { check_collision(alpha, some_collision(random, alpha)); });
}
TEST_CASE("collisions at rational alpha, all of them") {
  for (double alpha : {1 / 2.0, 3 / 8.0, 1 / 4.0, 3 / 64.0, 5 / 1024.0, 1 / 4096.0}) {
    for (std::int64_t j = 0; j < number_of_collisions(alpha); ++j) check_collision(alpha, j);
  }
}
TEST_CASE("the first two collisions are exact, their ties rounded to even") {
  for (double alpha : {0x1p-1074, 0x1p-400, 0x1p-53, 3 * 0x1p-53, 0.5, 1.0, neighbour(1, -1), 3.0,
                       0x1p53 + 2, 0x1p400, 0x1.fffffffffffffp1023}) {
    check_collision(alpha, 1);
    CHECK(accurate::collision(alpha, 0) == Collision{0, 1});
    CHECK(fast::collision(alpha, 0) == Collision{0, 1});
  }
  CHECK(accurate::collision(0x1p-53, 1) == Collision{0.5, 0.5});
  CHECK(accurate::collision(3 * 0x1p-53, 1).s == 0.5 + 0x1p-52);
}
TEST_CASE("collisions next to a threshold, with as many as there are") {
  for (double closest : {0x1.1c7397cb68b7ep-18, 0x1.bc7fb47556f22p-29, 1.0}) {
    for (std::int64_t step = -2; step <= 2; ++step) {
      const double alpha = neighbour(closest, step);
      const std::int64_t number = number_of_collisions(alpha);
      check_collision(alpha, number - 1);
      check_collision(alpha, number - 2);
      CHECK_THROWS_AS(accurate::collision(alpha, number), InvalidInput);
      CHECK_THROWS_AS(fast::collision(alpha, number), InvalidInput);
    }
  }
}
TEST_CASE("tiny alpha, where the leading order is a double or the middle of two") {
  for (double alpha : {0x1p-1074, 0x1.5acd9597016aap-968, 0x1p-400, 0x1p-130}) {
    for (std::int64_t j : {2L, 3L, 7L, (1L << 53) - 1, (1L << 54) - 1, (1L << 54) + 1, INT64_MAX}) {
      INFO("alpha = " << in_hex(alpha) << ", j = " << j);
      CHECK(accurate::collision(alpha, j) == collision_by_oracle(alpha, j));
    }
  }
}
TEST_CASE("each instruction set gives the same bits of a collision, and leaves the same open") {
  Random random(32);
  const numbers::Kernels& baseline = *numbers::kernels_named("baseline");
  for (const char* name : {"avx2", "avx512"}) {
    const numbers::Kernels* table = numbers::kernels_named(name);
    if (table == nullptr) continue;
    for (int row = 0; row < 3000; ++row) {
      const double alpha = families[row % 2 == 0 ? 0 : 7].alpha(random);
      const std::int64_t j = some_collision(random, alpha);
      INFO(name << ", alpha = " << in_hex(alpha) << ", j = " << j);
      for (int tier : {numbers::fast, numbers::accurate, numbers::slow}) {
        Collision got, expected;
        const bool is_certain = baseline.collision[tier](expected, alpha, j);
        REQUIRE(table->collision[tier](got, alpha, j) == is_certain);
        if (is_certain) REQUIRE(got == expected);
      }
    }
  }
}
TEST_CASE("collisions that do not take place are refused") {
  for (double alpha : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    CHECK_THROWS_AS(accurate::collision(alpha, 0), InvalidInput);
    CHECK_THROWS_AS(fast::collision(alpha, 1), InvalidInput);
  }
  CHECK_THROWS_WITH(accurate::collision(1.0, 2), "j must be from 0 to N_A + N_B - 1 = 1, got 2");
  CHECK_THROWS_WITH(fast::collision(0.5, 3), "j must be from 0 to N_A + N_B - 1 = 2, got 3");
  CHECK_THROWS_AS(accurate::collision(0.5, -1), InvalidInput);
  CHECK_THROWS_AS(fast::collision(1e300, INT64_MAX), InvalidInput);
  CHECK_THROWS_AS(accurate::collision(1e300, INT64_MIN), InvalidInput);
}
