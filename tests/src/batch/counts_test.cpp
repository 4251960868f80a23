// SPDX-License-Identifier: GPL-2.0-or-later
// The batch counts on every instruction set of this machine, against the exact function for one alpha.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/batch/exact_count.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

struct BatchCounts {
  std::vector<std::int64_t> N_A, N_B;

  friend bool operator==(const BatchCounts&, const BatchCounts&) = default;
};

BatchCounts one_by_one(std::span<const double> alpha) {
  BatchCounts result{std::vector<std::int64_t>(alpha.size()),
                     std::vector<std::int64_t>(alpha.size())};
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    batch::count_exactly(alpha[i], &result.N_A[i], &result.N_B[i]);
  }
  return result;
}

BatchCounts by_the_batch(std::span<const double> alpha, InstructionSet set) {
  BatchCounts result{std::vector<std::int64_t>(alpha.size()),
                     std::vector<std::int64_t>(alpha.size())};
  count_collisions(alpha, result.N_A, result.N_B, set);
  return result;
}

void require_exact(std::span<const double> alpha) {
  const BatchCounts expected = one_by_one(alpha);
  for (const InstructionSet set : testing::available_instruction_sets()) {
    const BatchCounts got = by_the_batch(alpha, set);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      INFO(to_text(set) << ", alpha = " << alpha[i]);
      REQUIRE(got.N_A[i] == expected.N_A[i]);
      REQUIRE(got.N_B[i] == expected.N_B[i]);
    }
  }
}

}  // namespace

TEST_CASE("batch counts are exact on everyday alpha", "[check]") {
  require_exact(testing::log_uniform(41, 200'000, 1e-6, 10.0));
}

TEST_CASE("batch counts are exact over the whole range of alpha", "[check]") {
  require_exact(testing::log_uniform(42, 20'000, 1e-26, 1.0));
  require_exact(testing::log_uniform(43, 200, 1e-38, 1e-26));
  require_exact(testing::log_uniform(44, 2'000, 1e-300, 1e300));
}

TEST_CASE("batch counts are exact next to every threshold up to the three-thousandth", "[check]") {
  std::vector<double> alpha;
  for (int total = 2; total <= 3000; ++total) {
    // total + 1 collisions begin below 1/cos(pi/(total+1)) - 1
    const double sine = std::sin(std::numbers::pi / (2 * (total + 1)));
    const double threshold = 2 * sine * sine / std::cos(std::numbers::pi / (total + 1));
    for (const double x : testing::neighbourhood(threshold, 4)) alpha.push_back(x);
  }
  require_exact(alpha);
}

TEST_CASE("tails of every length, at every offset, write their own rows alone", "[exam]") {
  const std::vector<double> alpha = testing::log_uniform(45, 200, 1e-6, 10.0);
  const BatchCounts expected = one_by_one(alpha);
  for (const InstructionSet set : testing::available_instruction_sets()) {
    for (std::size_t size = 0; size <= 33; ++size) {
      for (const std::size_t start : {0U, 1U, 2U, 3U, 7U, 130U}) {
        for (const std::size_t whole_blocks : {0U, 128U}) {
          const std::size_t rows = size + whole_blocks;
          if (start + rows > alpha.size()) continue;
          constexpr std::int64_t untouched = -7;
          std::vector<std::int64_t> N_A(rows + 3, untouched), N_B(rows + 5, untouched);
          count_collisions(std::span(alpha).subspan(start, rows), std::span(N_A).subspan(1, rows),
                           std::span(N_B).subspan(2, rows), set);
          REQUIRE((N_A.front() == untouched && N_A[rows + 1] == untouched));
          REQUIRE((N_B[1] == untouched && N_B[rows + 2] == untouched));
          for (std::size_t i = 0; i < rows; ++i) {
            REQUIRE(N_A[i + 1] == expected.N_A[start + i]);
            REQUIRE(N_B[i + 2] == expected.N_B[start + i]);
          }
        }
      }
    }
  }
}

TEST_CASE("spans that no double is aligned to are fine", "[exam]") {
  const std::vector<double> alpha = testing::log_uniform(46, 40, 1e-6, 10.0);
  for (const InstructionSet set : testing::available_instruction_sets()) {
    alignas(64) double room[50];
    for (std::size_t offset = 0; offset < 8; ++offset) {
      std::copy(alpha.begin(), alpha.end(), room + offset);
      CHECK(by_the_batch(std::span(room + offset, alpha.size()), set) == one_by_one(alpha));
    }
  }
}

TEST_CASE("alpha that is no mass ratio, or has no 64-bit count, gives -1 in its place alone",
          "[exam]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const double special[] = {0.0,
                            -0.0,
                            -0.1,
                            -1.0,
                            -2.0,
                            -infinity,
                            infinity,
                            nan,
                            -nan,
                            -5e-324,
                            5e-324,
                            1e-310,
                            5.7e-38,
                            5.9e-38,
                            1e-20,
                            0x1p-127,
                            0x1p-126,
                            0x1p-124,
                            0x1p127,
                            0x1p128,
                            0x1p129,
                            1.0,
                            1.001,
                            0.9999999999999999,
                            std::numeric_limits<double>::max(),
                            std::numeric_limits<double>::signaling_NaN()};
  for (const double x : special) {
    for (const std::size_t place : {0U, 5U, 16U, 18U}) {
      std::vector<double> alpha(19, 0.12);
      alpha[place] = x;
      require_exact(alpha);
    }
  }
  require_exact(special);
  CHECK(by_the_batch(std::vector<double>{nan}, InstructionSet::baseline).N_A[0] == -1);
  CHECK(by_the_batch(std::vector<double>{5.7e-38}, InstructionSet::baseline).N_B[0] == -1);
}

TEST_CASE("the doubles closest to a threshold go to the exact path and come out right", "[exam]") {
  std::vector<double> alpha;
  for (const double centre : {1.0, 0x1.1c7397cb68b7ep-18, 0x1.bc7fb47556f22p-29}) {
    for (const double x : testing::neighbourhood(centre, 3)) alpha.push_back(x);
  }
  require_exact(alpha);
}

TEST_CASE("single precision alone would be wrong near a threshold", "[exam]") {
  // the float next to a threshold is on its wrong side for one of the two neighbours that are doubles
  const double alpha = 0x1.1c7397cb68b7ep-18;
  CHECK(one_by_one(std::vector{std::nextafter(alpha, 0.0)}) !=
        one_by_one(std::vector{std::nextafter(alpha, 1.0)}));
  CHECK(static_cast<float>(std::nextafter(alpha, 0.0)) ==
        static_cast<float>(std::nextafter(alpha, 1.0)));
}
