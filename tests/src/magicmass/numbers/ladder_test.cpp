// The steps of the ladder by themselves: what each leaves open, and what MPFR's numbers say alone.
#include <future>

#include <mpfr.h>

#include "catch.hpp"
#include "magicmass/numbers/until_certain.hpp"
#include "src/magicmass/numbers/families.hpp"
#include "src/magicmass/numbers/tiers.hpp"

using namespace magicmass;
using namespace magicmass::testing;

TEST_CASE("what the last precision leaves open is Undecided, and says how many bits that was") {
  std::vector<long> tried;
  const auto never_certain = [&] {
    tried.push_back(numbers::MpfrFloat::bits);
    return 1.0;
  };
  CHECK_THROWS_WITH(numbers::until_certain("nothing", 0.5, false, never_certain),
                    "nothing at 0.5: still open at " + std::to_string(tried.back()) + " bits");
  CHECK(tried == std::vector<long>{182, 364, 728, 1456, 2912, 5824, 8192});
}
TEST_CASE("a thread that narrowed MPFR's exponents gets the same, and keeps them and its flags") {
  const double alpha = 1e300;
  const Velocities v = accurate::velocities(alpha, 1);
  const mpfr_exp_t least = mpfr_get_emin(), most = mpfr_get_emax();
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  mpfr_clear_flags();
  CHECK(accurate::velocities(alpha, 1) == v);
  CHECK(fast::terminal(0x1p100, 0x1p-201).value().counts == Counts{2, 1});
  CHECK(mpfr_get_emin() == -1073);
  CHECK(mpfr_get_emax() == 1024);
  CHECK(mpfr_flags_save() == 0);
  mpfr_set_emin(least);
  mpfr_set_emax(most);
}

TEST_CASE("every step gives the same rounded numbers, or leaves them open") {
  Random random(51);
  int open[4] = {0, 0, 0, 0};
  for (int row = 0; row < 500; ++row) {
    const double alpha = row % 2 == 0 ? families[7].alpha(random) : log_uniform(random, 1e-12, 1);
    const std::int64_t n = some_cycle(random, alpha);
    INFO("alpha = " << in_hex(alpha) << ", n = " << n);
    const Terminal terminal = terminal_by_oracle(alpha, *counts_by_oracle(alpha));
    for (const numbers::Tier tier : {numbers::accurate, numbers::slow, numbers::by_mpfr}) {
      Velocities v;
      Terminal t;
      if (n > 0 && numbers::kernels().velocities[tier](v, alpha, n))
        REQUIRE(v == velocities_by_oracle(alpha, n));
      if (numbers::kernels().terminal[tier](t, alpha)) {
        REQUIRE(t == terminal);
      } else {
        ++open[tier];
      }
    }
  }
  CHECK(open[numbers::accurate] > 10);
  CHECK(open[numbers::accurate] < 300);
  CHECK(open[numbers::slow] < open[numbers::accurate]);
  CHECK(open[numbers::by_mpfr] == 0);
}
TEST_CASE("one everyday row in a thousand needs more than Accurate, at most") {
  Random random(55);
  int open = 0;
  for (int row = 0; row < 100000; ++row) {
    Terminal t;
    open += !numbers::kernels().terminal[numbers::accurate](t, log_uniform(random, 1e-4, 1));
  }
  CHECK((open > 0 && open <= 100));
}
TEST_CASE("threads do not disturb each other, at any precision") {
  Random random(54);
  std::vector<double> alpha;
  std::vector<Velocities> alone;
  for (int row = 0; row < 200; ++row) {
    alpha.push_back(log_uniform(random, row % 2 == 0 ? 1e-37 : 1e-300, 1e-20));
    alone.push_back(accurate::velocities(alpha.back(), 3));
  }
  const auto wrong = [&] {
    int rows = 0;
    for (std::size_t i = 0; i < alpha.size(); ++i)
      rows += accurate::velocities(alpha[i], 3) == alone[i] ? 0 : 1;
    return rows;
  };
  std::vector<std::future<int>> threads;
  for (int k = 0; k < 4; ++k) threads.push_back(std::async(std::launch::async, wrong));
  for (auto& thread : threads) CHECK(thread.get() == 0);
}
TEST_CASE("no kernel answers past the last cycle, and all have the same last one") {
  Random random(52);
  for (int row = 0; row < 2000; ++row) {
    const double alpha = row % 2 == 0 ? families[0].alpha(random) : log_uniform(random, 1e-30, 1);
    const std::int64_t last = count_collisions(alpha)->N_A;
    for (const numbers::Kernels* table : all_kernels()) {
      INFO(table->name << ", alpha = " << in_hex(alpha));
      Counts counts;
      CHECK((table->counts(counts, alpha) ? counts.N_A == last : alpha < 1e-20));
      Velocities v;
      for (int tier = 0; tier < 3; ++tier) CHECK_FALSE(table->velocities[tier](v, alpha, last + 1));
      if (alpha > 1e-4 && alpha < 0.9) CHECK(table->velocities[0](v, alpha, last - 1));
    }
  }
}
TEST_CASE("each instruction set gives the same bits of a collision, and leaves the same open") {
  Random random(32);
  for (int row = 0; row < 3000; ++row) {
    const double alpha = families[row % 2 == 0 ? 0 : 7].alpha(random);
    const std::int64_t j = some_collision(random, alpha);
    for (const numbers::Kernels* table : all_kernels()) {
      INFO(table->name << ", alpha = " << in_hex(alpha) << ", j = " << j);
      for (int tier : {numbers::fast, numbers::accurate, numbers::slow}) {
        Collision got, expected;
        const bool is_certain = numbers::kernels().collision[tier](expected, alpha, j);
        REQUIRE(table->collision[tier](got, alpha, j) == is_certain);
        if (is_certain) REQUIRE(got == expected);
      }
    }
  }
}
