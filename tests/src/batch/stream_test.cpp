// SPDX-License-Identifier: GPL-2.0-or-later
// The stream's rows: which have an answer, and the same bits whatever the instruction set, length or place in memory.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

constexpr double filler = -77.0;

/// Rows of a, b, c and c' one after the other, with `offset` doubles before and after each that stay as they are.
std::vector<double> stream(double alpha, std::int64_t first_n, std::size_t size, InstructionSet set,
                           std::size_t offset = 0) {
  std::vector<double> room(4 * (size + 2 * offset), filler);
  const auto column = [&](std::size_t v) {
    return std::span(room).subspan(v * (size + 2 * offset) + offset, size);
  };
  velocity_stream(alpha, first_n, column(0), column(1), column(2), column(3), set);
  std::vector<double> rows;
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t i = 0; i < offset; ++i) {
      CHECK(*(column(v).data() - 1 - i) == filler);
      CHECK(*(column(v).data() + size + i) == filler);
    }
    rows.insert(rows.end(), column(v).begin(), column(v).end());
  }
  return rows;
}

bool same_bits(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size()) return false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::bit_cast<std::uint64_t>(x[i]) != std::bit_cast<std::uint64_t>(y[i])) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("streams of every length have the same bits with every instruction set", "[exam]") {
  for (const double alpha : {0.3, 1e-3, 2.3e-7, 1e-20, 1e-310}) {
    const std::vector<double> longest = stream(alpha, 1, 600, InstructionSet::baseline);
    for (const InstructionSet set : testing::available_instruction_sets()) {
      for (std::size_t size = 0; size <= 600;
           size += size <= 33 || (size > 250 && size < 262) ? 1 : 13) {
        std::vector<double> expected;
        for (std::size_t v = 0; v < 4; ++v) {
          const auto from = longest.begin() + static_cast<std::ptrdiff_t>(600 * v);
          expected.insert(expected.end(), from, from + static_cast<std::ptrdiff_t>(size));
        }
        INFO(to_text(set) << ", alpha = " << alpha << ", size " << size);
        REQUIRE(same_bits(stream(alpha, 1, size, set, size % 9), expected));
      }
    }
  }
}

TEST_CASE("random windows have the same bits with every instruction set", "[check]") {
  testing::Generator generator(51);
  for (int i = 0; i < 200; ++i) {
    const double alpha = testing::log_uniform(generator, i % 4 == 0 ? 1e-300 : 1e-26, 1.0);
    const auto counts = count_collisions(alpha);
    const std::int64_t first_n = testing::whole(
        generator, 0, counts ? counts->N_A : std::numeric_limits<std::int64_t>::max());
    const std::vector<double> expected = stream(alpha, first_n, 700, InstructionSet::baseline);
    for (const InstructionSet set : testing::available_instruction_sets()) {
      INFO(to_text(set) << ", alpha = " << alpha << ", n = " << first_n);
      REQUIRE(same_bits(stream(alpha, first_n, 700, set), expected));
    }
  }
}

TEST_CASE("rows without an answer are NaN, all others are not", "[exam]") {
  for (const InstructionSet set : testing::available_instruction_sets()) {
    for (const double alpha : {0.12, 1e-4, 1.0, 3.0, 1e300}) {
      const std::int64_t N_A = count_collisions(alpha)->N_A;
      const std::int64_t size = N_A + 300;
      for (const std::int64_t first_n : {std::int64_t{-5}, std::int64_t{0}, N_A, N_A + 1}) {
        const auto rows = stream(alpha, first_n, static_cast<std::size_t>(size), set);
        for (std::int64_t i = 0; i < 4 * size; ++i) {
          const std::int64_t n = first_n + i % size;
          REQUIRE(std::isnan(rows[static_cast<std::size_t>(i)]) == (n < 0 || n > N_A));
        }
      }
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double alpha : {0.0, -0.0, -1.0, infinity, -infinity, std::nan("")}) {
      for (const double x : stream(alpha, 0, 40, set)) CHECK(std::isnan(x));
    }
    constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
    for (const double x : stream(0.1, least, 40, set)) CHECK(std::isnan(x));
    for (const double x : stream(0.1, std::numeric_limits<std::int64_t>::max(), 40, set)) {
      CHECK(std::isnan(x));
    }
    for (const double x : stream(1e-300, std::numeric_limits<std::int64_t>::max() - 9, 10, set)) {
      CHECK(std::isfinite(x));
    }
  }
}

TEST_CASE("a stream begins with the initial values, and alpha = 1 has one cycle", "[exam]") {
  for (const InstructionSet set : testing::available_instruction_sets()) {
    CHECK(stream(0.01, 0, 1, set) == std::vector{1.0, 0.0, 0.0, 0.0});
    // A stops, C goes on with 1 and stops in turn, B goes on
    CHECK(stream(1.0, 0, 2, set) == std::vector{1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0});
  }
}

TEST_CASE("streams of different sizes or that overlap are refused", "[exam]") {
  std::vector<double> room(40);
  const std::span all(room);
  CHECK_THROWS_AS(velocity_stream(0.1, 0, all.first(9), all.subspan(10, 10), all.subspan(20, 10),
                                  all.subspan(30, 10)),
                  InvalidInput);
  CHECK_THROWS_WITH(velocity_stream(0.1, 0, all.first(10), all.subspan(9, 10), all.subspan(20, 10),
                                    all.subspan(30, 10)),
                    "an output must not overlap another span, but a and b share elements");
}
