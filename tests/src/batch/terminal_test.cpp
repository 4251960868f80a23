// SPDX-License-Identifier: GPL-2.0-or-later
// Batches of terminal velocities on every instruction set of this machine: the same bits, and in tier accurate those of one
// input; counts always.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

using Run = void (*)(std::span<const double>, std::span<std::int64_t>, std::span<std::int64_t>,
                     std::span<double>, std::span<double>, std::span<double>, InstructionSet);
constexpr Run tiers[] = {fast::terminal, accurate::terminal};
constexpr double untouched = -77.0;

struct Rows {
  std::vector<std::int64_t> N_A, N_B;
  std::vector<double> a, b, c;

  bool is_like(const Rows& other, std::size_t i, std::size_t of_other) const {
    const auto bits = [](double x) { return std::isnan(x) ? 1 : std::bit_cast<std::int64_t>(x); };
    return N_A[i] == other.N_A[of_other] && N_B[i] == other.N_B[of_other] &&
           bits(a[i]) == bits(other.a[of_other]) && bits(b[i]) == bits(other.b[of_other]) &&
           bits(c[i]) == bits(other.c[of_other]);
  }
};

/// Columns begin `offset` elements into rooms that stay untouched elsewhere.
Rows rows(Run run, std::span<const double> alpha, InstructionSet set, std::size_t offset = 0) {
  const std::size_t size = alpha.size(), room = size + offset + 1;
  Rows all{std::vector<std::int64_t>(room, -77), std::vector<std::int64_t>(room, -77),
           std::vector<double>(room, untouched), std::vector<double>(room, untouched),
           std::vector<double>(room, untouched)};
  run(alpha, std::span(all.N_A).subspan(offset, size), std::span(all.N_B).subspan(offset, size),
      std::span(all.a).subspan(offset, size), std::span(all.b).subspan(offset, size),
      std::span(all.c).subspan(offset, size), set);
  const auto cut = [&](auto& column) {
    for (std::size_t i = 0; i < offset; ++i) CHECK(column[i] == -77);
    CHECK(column.back() == -77);
    column.pop_back();
    column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(offset));
  };
  cut(all.N_A);
  cut(all.N_B);
  cut(all.a);
  cut(all.b);
  cut(all.c);
  return all;
}

Rows require_same(Run run, std::span<const double> alpha) {
  const Rows expected = rows(run, alpha, InstructionSet::baseline);
  for (const InstructionSet set : testing::available_instruction_sets()) {
    const Rows got = rows(run, alpha, set);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      INFO(to_text(set) << ", alpha = " << alpha[i]);
      REQUIRE(got.is_like(expected, i, i));
    }
  }
  return expected;
}

void require_those_of_one(std::span<const double> alpha) {
  const Rows got = require_same(accurate::terminal, alpha);
  const Rows fast = require_same(fast::terminal, alpha);
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const auto one = accurate::terminal(alpha[i]);
    INFO("alpha = " << alpha[i]);
    REQUIRE((fast.N_A[i] == got.N_A[i] && fast.N_B[i] == got.N_B[i]));
    if (!one) {
      REQUIRE((got.N_A[i] == -1 && got.N_B[i] == -1 && std::isnan(got.a[i]) &&
               std::isnan(got.b[i]) && std::isnan(got.c[i]) && std::isnan(fast.a[i])));
      continue;
    }
    REQUIRE((got.N_A[i] == one->counts.N_A && got.N_B[i] == one->counts.N_B));
    REQUIRE((got.a[i] == one->a_t && got.b[i] == one->b_t && got.c[i] == one->c_t));
    // no body ends faster than A began, so this is 4 eps of the largest velocity or less
    constexpr double allowed = 4 * std::numeric_limits<double>::epsilon();
    REQUIRE(std::fabs(fast.a[i] - got.a[i]) <= allowed);
    REQUIRE(std::fabs(fast.b[i] - got.b[i]) <= allowed);
  }
}

/// Rows that need the function for one input, scattered over rows that do not.
std::vector<double> mixed(std::uint64_t seed, std::size_t size) {
  testing::Generator generator(seed);
  std::vector<double> alpha = testing::log_uniform(seed, size, 1e-6, 10.0);
  const double others[] = {1.0,
                           0x1.1c7397cb68b7ep-18,
                           0x1.bc7fb47556f22p-29,
                           5e-324,
                           1e308,
                           1e-37,
                           0x1p-120,
                           0x1p60,
                           3e-38,
                           std::nextafter(1.0, 0.0),
                           1e-30,
                           1e-100};
  for (double& x : alpha)
    if (testing::whole(generator, 0, 5) == 0) x = others[testing::whole(generator, 0, 11)];
  return alpha;
}

}  // namespace

TEST_CASE("accurate batches of terminal velocities are those of one input, the same everywhere",
          "[check]") {
  require_those_of_one(testing::log_uniform(121, 50'000, 1e-6, 10.0));
  require_those_of_one(testing::log_uniform(122, 2'000, 1e-26, 1.0));
  require_those_of_one(testing::log_uniform(123, 500, 1e-320, 1e308));
  require_those_of_one(mixed(124, 3'000));
}

TEST_CASE("blocks of two collisions each, some out of the kernels' domain", "[check]") {
  std::vector<double> alpha = testing::log_uniform(126, 2'000, 1.0, 0x1p60);
  require_those_of_one(alpha);
  for (std::size_t i = 0; i < alpha.size(); i += 331) alpha[i] = 1e300;
  require_those_of_one(alpha);
  for (std::size_t i = 0; i < alpha.size(); i += 200) alpha[i] = 0.5;  // one that has more
  require_those_of_one(alpha);
}

TEST_CASE("a_t and c_t of fast arrays are within 3.5 envelopes up to alpha = 1, where both vanish",
          "[check]") {
  constexpr std::size_t size = 200'000;
  for (const double least : {0.05, 0.9, 0.99}) {
    std::vector<double> alpha = testing::log_uniform(127, size, least, 1 - 0x1p-12);
    // what a search found, of sums in place of products: 4.0 and 4.3 envelopes
    alpha[0] = 0x1.fe0362ab207dbp-1;
    alpha[1] = 0x1.ffc1f9d1bbf52p-1;
    const auto moved = [&](double factor) {
      std::vector<double> all = alpha;
      for (double& x : all) x *= factor;
      return all;
    };
    // conditions from differences, of inputs with the same counts
    const std::vector<double> below = moved(1 - 0x1p-18), above = moved(1 + 0x1p-18);
    const auto of = [](Run run, std::span<const double> x) {
      return rows(run, x, InstructionSet::baseline);
    };
    const Rows got = of(fast::terminal, alpha), nearest = of(accurate::terminal, alpha);
    const Rows less = of(accurate::terminal, below), more = of(accurate::terminal, above);
    double worst = 0.0;
    const auto compare = [&](double x, double y, double low, double high) {
      const double ulp = std::nextafter(std::fabs(y), HUGE_VAL) - std::fabs(y);
      const double condition = std::fabs((high - low) / y) * 0x1p17;
      const double envelope = std::max(0.5, condition / 2) * ulp;
      worst = std::max(worst, (std::fabs(x - y) - 0.5 * ulp) / envelope);
    };
    std::size_t compared = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (less.N_A[i] != more.N_A[i] || less.N_B[i] != more.N_B[i]) continue;
      ++compared;
      compare(got.a[i], nearest.a[i], less.a[i], more.a[i]);
      compare(got.c[i], nearest.c[i], less.c[i], more.c[i]);
    }
    INFO(least << ": " << worst << " envelopes in " << compared);
    CHECK(compared > size * 9 / 10);
    CHECK(worst < 3.5);
    CHECK(worst > 1.0);
  }
}

TEST_CASE("terminal velocities next to thresholds are those of one input", "[check]") {
  std::vector<double> alpha;
  for (std::int64_t k = 1; k <= 300; ++k) {
    const auto ratios = accurate::ratios(k);
    for (const double threshold : {ratios.magic, ratios.deficient})
      for (const double x : testing::neighbourhood(threshold, 2)) alpha.push_back(x);
  }
  require_those_of_one(alpha);
}

TEST_CASE("terminal velocities of tails of every length, at every offset", "[exam]") {
  const std::vector<double> alpha = mixed(125, 300);
  for (const Run run : tiers) {
    const Rows all = rows(run, alpha, InstructionSet::baseline);
    for (const InstructionSet set : testing::available_instruction_sets()) {
      for (std::size_t size = 0; size <= 33; ++size) {
        for (const std::size_t whole_blocks : {0U, 128U}) {
          const std::size_t length = size + whole_blocks, first = size % 11;
          const Rows got = rows(run, std::span(alpha).subspan(first, length), set, size % 8);
          for (std::size_t i = 0; i < length; ++i) {
            INFO(to_text(set) << ", size " << length << ", row " << i);
            REQUIRE(got.is_like(all, i, first + i));
          }
        }
      }
    }
  }
}

TEST_CASE("alpha that is no mass ratio gets -1 and NaN in its place alone", "[exam]") {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  for (const Run run : tiers) {
    for (const InstructionSet set : testing::available_instruction_sets()) {
      for (const double wrong : {0.0, -0.0, -1.0, infinity, -infinity, nan, -nan, -5e-324}) {
        std::vector<double> alpha = testing::log_uniform(126, 20, 0.01, 3.0);
        const Rows before = rows(run, alpha, set);
        alpha[7] = wrong;
        const Rows got = rows(run, alpha, set);
        INFO(to_text(set) << ", alpha = " << wrong);
        CHECK((got.N_A[7] == -1 && got.N_B[7] == -1));
        CHECK((std::isnan(got.a[7]) && std::isnan(got.b[7]) && std::isnan(got.c[7])));
        for (std::size_t i = 0; i < 20; ++i)
          if (i != 7) CHECK(got.is_like(before, i, i));
      }
    }
  }
}

TEST_CASE("terminal: other sizes or spans that overlap are refused, and nothing is written",
          "[exam]") {
  const std::vector<double> alpha(4, 0.1);
  std::vector<std::int64_t> counts(12, -77);
  std::vector<double> room(20, untouched);
  const auto at = [&](std::size_t first, std::size_t size = 4) {
    return std::span(room).subspan(first, size);
  };
  const auto N_A = std::span(counts).first(4), N_B = std::span(counts).subspan(4, 4);
  for (const Run run : tiers) {
    const auto set = InstructionSet::baseline;
    CHECK_THROWS_WITH(run(alpha, N_A, std::span(counts).subspan(4, 5), at(0), at(4), at(8), set),
                      "all spans must have the same size, but N_B has 5 elements and alpha has 4");
    CHECK_THROWS_WITH(run(alpha, N_A, N_A, at(0), at(4), at(8), set),
                      "an output must not overlap another span, but N_A and N_B share elements");
    CHECK_THROWS_WITH(run(alpha, N_A, N_B, at(0), at(4), at(7), set),
                      "an output must not overlap another span, but b_t and c_t share elements");
    CHECK_THROWS_AS(run(at(0), N_A, N_B, at(3), at(8), at(12), set), InvalidInput);
  }
  CHECK(counts == std::vector<std::int64_t>(12, -77));
  CHECK(room == std::vector<double>(20, untouched));
}
