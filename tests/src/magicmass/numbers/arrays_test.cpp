// Arrays: a row alone is the row among others, whatever their number, place and instruction set.
// The steps of the ladder by themselves: what each leaves open, and what MPFR's numbers say alone.
#include <cfenv>
#include <functional>
#include <future>

#include <mpfr.h>

#include "catch.hpp"
#include "magicmass/arithmetic/simd.hpp"
#include "magicmass/numbers/until_certain.hpp"
#include "src/magicmass/numbers/families.hpp"
#include "src/magicmass/numbers/tiers.hpp"

using namespace magicmass;
using namespace magicmass::testing;

namespace {
bool is_same(double x, double y) {
  return std::bit_cast<std::int64_t>(x) == std::bit_cast<std::int64_t>(y) ||
         (std::isnan(x) && std::isnan(y));
}

/// Rows with what is special at places 0, 5, 16, 18.
Table rows_of(std::size_t size, Random& random) {
  const std::vector<double> special{NAN,   -1.0,  0.0,     1.0,      0x1p-1074,
                                    1e308, 1e-35, 0x1p-54, INFINITY, 3.0};
  Table rows(size);
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_special = i == 0 || i == 5 || i == 16 || i == 18;
    rows.alpha[i] = is_special ? pick(random, special) : families[random() % 2].alpha(random);
    rows.n[i] = random() % 9 == 0 ? std::int64_t(random()) : std::int64_t(random() % 4);
  }
  return rows;
}
/// Rows of a larger table, which keeps what is around them.
void check_rows(const Calls& calls, std::size_t size, std::size_t offset, Random& random) {
  const Table rows = rows_of(size, random);
  Table out(size + 16);
  for (auto& column : out.values) column.assign(size + 16, -77);
  const Table before = out;
  INFO(size << " rows from " << offset);
  const auto o = [&](std::size_t c) { return std::span(out.values[c]).subspan(offset, size); };
  const auto N = [&](std::size_t c) { return std::span(out.counts[c]).subspan(offset, size); };
  calls.velocity_rows(rows.alpha, rows.n, {o(0), o(1), o(2), o(3)});
  calls.terminal_rows(rows.alpha, {N(0), N(1), o(4), o(5), o(6), o(7)});
  for (std::size_t i = 0; i < size; ++i) {
    INFO("row " << i << ", alpha = " << in_hex(rows.alpha[i]) << ", n = " << rows.n[i]);
    Velocities v{NAN, NAN, NAN, NAN};
    Terminal t{{-1, -1}, NAN, NAN, NAN, NAN};  // what single numbers refuse
    try {
      t = calls.terminal(rows.alpha[i]).value_or(t);
      v = calls.velocities(rows.alpha[i], rows.n[i]);
    } catch (const InvalidInput&) {
    }
    const double alone[] = {v.a, v.b, v.c, v.c_prime, t.a_t, t.b_t, t.c_t, t.rho};
    for (std::size_t c = 0; c < 8; ++c) REQUIRE(is_same(o(c)[i], alone[c]));
    REQUIRE((N(0)[i] == t.counts.N_A && N(1)[i] == t.counts.N_B));
  }
  for (std::size_t c = 0; c < 8; ++c) std::ranges::fill(o(c), -77);
  for (std::size_t c = 0; c < 2; ++c) std::ranges::fill(N(c), 0);
  REQUIRE((out.values == before.values && out.counts == before.counts));
}
}  // namespace

TEST_CASE("rows are single numbers, for all tails and offsets, across blocks") {
  Random random(41);
  for (const Calls& calls : tiers) {
    for (std::size_t size = 0; size <= 33; ++size) check_rows(calls, size, size % 8, random);
    for (std::size_t offset = 0; offset < 8; ++offset) check_rows(calls, 19, offset, random);
    for (const int size : {255, 256, 257, 300, 515})
      check_rows(calls, std::size_t(size), 1, random);
  }
}
TEST_CASE("all instruction sets give the same bits, and leave the same rows open") {
  Random random(42);
  const std::size_t size = numbers::longest_block;
  const Table rows = rows_of(size, random);
  CHECK(all_kernels().back() == &numbers::kernels());
  for (const numbers::Kernels* table : all_kernels()) {
    INFO(table->name);
    for (int tier : {0, 1}) {
      const auto open_rows = [&](const numbers::Kernels& of, Table& t) {
        numbers::Open first, second;
        const std::size_t left = of.velocity_rows[tier](size, t.velocities_from(0), first);
        const std::size_t still = of.terminal_rows[tier](size, t.terminal_from(0), second);
        CHECK(std::max(left, still) < size / 2);
        return std::pair(std::vector(first, first + left), std::vector(second, second + still));
      };
      Table best = rows, other = rows;
      CHECK(open_rows(numbers::kernels(), best) == open_rows(*table, other));
      for (std::size_t c = 0; c < 8; ++c)
        CHECK(std::ranges::equal(best.values[c], other.values[c], is_same));
      CHECK(best.counts == other.counts);
    }
  }
}
TEST_CASE("compilers and processors give the same bits") {
  CHECK(fingerprint() == pinned_fingerprint);
}
TEST_CASE("columns not wanted are left out, others have as many rows and their own place") {
  const std::vector<double> alpha(40, 0.01);
  const std::vector<std::int64_t> n(40, 3);
  std::vector<double> out(40), wrong(39);
  std::vector<std::int64_t> counts(40);
  accurate::velocities(alpha, n, {.b = out});
  CHECK(out[39] == accurate::velocities(0.01, 3).b);
  accurate::velocities(alpha, n, {});
  accurate::terminal(alpha, {.rho = out});
  CHECK(out[0] == accurate::terminal(0.01)->rho);
  count_collisions(alpha, counts, {});
  CHECK(counts[39] == count_collisions(0.01)->N_A);
  CHECK_THROWS_WITH(fast::velocities(alpha, n, {.c = wrong}), "c has 39 rows, alpha has 40");
  CHECK_THROWS_WITH(fast::velocities(wrong, n, {}), "n has 40 rows, alpha has 39");
  CHECK_THROWS_AS(accurate::terminal(alpha, {.rho = wrong}), InvalidInput);
  CHECK_THROWS_WITH(accurate::terminal(out, {.b_t = out}), "b_t overlaps alpha");
  CHECK_THROWS_WITH(count_collisions(alpha, counts, counts), "N_B overlaps N_A");
  const std::span<double> last = std::span(out).last(20), first = std::span(out).first(20);
  CHECK_NOTHROW(fast::velocities(last, std::span(n).first(20), {.a = first}));
  CHECK_NOTHROW(accurate::velocities(alpha, n, {.a = out, .b = first.subspan(1, 0)}));
}
/// In roundings that are not to nearest, and where subnormals are flushed to zero.
void check_refused(const std::function<void()>& call) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string said = refusal<NotIeee>(call);
    std::fesetround(FE_TONEAREST);
    CHECK(said == "this thread does not round to nearest");
  }
#if defined(__SSE2__)
  for (const unsigned bit : {0x8000U, 0x0040U}) {  // results, operands flushed to zero
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | bit);
    const std::string said = refusal<NotIeee>(call);
    _mm_setcsr(before);
    CHECK(said == "this thread flushes subnormal numbers to zero");
  }
#endif
  CHECK(refusal<NotIeee>(call) == "not refused");
}
TEST_CASE("array calls refuse another rounding mode or lost subnormal numbers, and say which") {
  Table t(3);
  t.alpha.assign(3, 0.1);
  check_refused([&] { count_collisions(t.alpha, t.counts[0], {}); });
  for (const Calls& tier : tiers) {
    check_refused([&] { tier.velocity_rows(t.alpha, t.n, t.velocities()); });
    check_refused([&] { tier.terminal_rows(t.alpha, t.terminal()); });
#ifndef NDEBUG
    check_refused([&] { tier.velocities(0.1, 2); });
    check_refused([&] { tier.terminal(0.1); });
    check_refused([&] { tier.collision(0.1, 2); });
    check_refused([&] { tier.angle(0.1); });
    check_refused([&] { tier.ratios(1); });
#endif
  }
}

TEST_CASE("what the last precision leaves open is Undecided, and says how many bits that was") {
  std::vector<long> tried;
  const auto never_certain = [&] {
    tried.push_back(numbers::MpfrFloat::bits);
    return 1.0;
  };
  CHECK_THROWS_WITH(numbers::until_certain("nothing", 0.5, false, never_certain),
                    "nothing at 0.5: still open at " + std::to_string(tried.back()) + " bits");
  CHECK(tried == std::vector<long>{176, 352, 704, 1408, 2816, 5632, 8192});
}
TEST_CASE("MPFR's tests at their edges: 2^-61 and 2^-59 ulp from a tie or 0, error 2^-60") {
  numbers::MpfrFloat::bits = 176;
  for (const double d : {-0x1p-61, 0x1p-61, -0x1.1p-59, 0x1.1p-59})
    for (const double start : {1.0, 0x1p-1074}) {
      const double ulp = std::max(0x1p-52 * start, 0x1p-1074);
      const numbers::MpfrFloat from_0 = d, x = scaled(from_0 + 0.5, ulp) + start;
      const auto [value, doubt] = rounding_test(x, std::ldexp(ulp, 176 - 60));
      CHECK((doubt == 0.0) == (std::fabs(d) > 0x1p-60));
      CHECK((doubt != 0.0 || (value == start + ulp) == (d > 0.0)));
      CHECK((doubt_of_sign(from_0, 0x1p116) == 0.0) == (d > 0x1p-60));
    }
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
