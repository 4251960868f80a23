// SPDX-License-Identifier: GPL-2.0-or-later
// Ratios of consecutive k on every instruction set of this machine, against the functions for one k.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/fast.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

struct Range {
  std::vector<double> magic, deficient;
};

Range fast_range(std::int64_t first_k, std::size_t size, InstructionSet set) {
  Range result{std::vector<double>(size), std::vector<double>(size)};
  fast::ratios(first_k, result.magic, result.deficient, set);
  return result;
}

void require_nearest(std::int64_t first_k, std::size_t size) {
  for (const InstructionSet set : testing::available_instruction_sets()) {
    Range got{std::vector<double>(size), std::vector<double>(size)};
    accurate::ratios(first_k, got.magic, got.deficient, set);
    for (std::size_t i = 0; i < size; ++i) {
      const auto k = first_k + static_cast<std::int64_t>(i);
      const auto one = accurate::ratios(k);
      INFO(to_text(set) << ", k = " << k);
      REQUIRE(got.magic[i] == one.magic);
      REQUIRE(got.deficient[i] == one.deficient);
    }
  }
}

}  // namespace

TEST_CASE("accurate ranges of ratios are those of one k, for tails of every length", "[exam]") {
  for (std::size_t size = 0; size <= 33; ++size) require_nearest(1, size);
  require_nearest(1, 300);
}

TEST_CASE("accurate ranges of ratios at random k", "[check]") {
  testing::Generator generator(71);
  for (int i = 0; i < 60; ++i) {
    require_nearest(static_cast<std::int64_t>(testing::log_uniform(generator, 1.0, 4e18)), 40);
  }
}

TEST_CASE("fast ranges of ratios are within an ulp, and the same bits everywhere", "[check]") {
  testing::Generator generator(72);
  for (int i = 0; i < 40; ++i) {
    const auto first_k =
        i == 0 ? 1 : static_cast<std::int64_t>(testing::log_uniform(generator, 1.0, 1e18));
    const Range expected = fast_range(first_k, 150, InstructionSet::baseline);
    for (const InstructionSet set : testing::available_instruction_sets()) {
      const Range got = fast_range(first_k, 150, set);
      CHECK(got.magic == expected.magic);
      CHECK(got.deficient == expected.deficient);
    }
    for (std::size_t row = 0; row < 150; ++row) {
      const auto nearest = accurate::ratios(first_k + static_cast<std::int64_t>(row));
      const double next = std::nextafter(nearest.magic, 2.0);
      const double ulp = next - nearest.magic;
      REQUIRE(std::fabs(expected.magic[row] - nearest.magic) <= ulp);
      REQUIRE(std::fabs(expected.deficient[row] - nearest.deficient) <= ulp);
    }
  }
}

TEST_CASE("there is no ratio below k = 1 nor past the largest k", "[exam]") {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  for (const InstructionSet set : testing::available_instruction_sets()) {
    const Range first = fast_range(-2, 5, set);
    CHECK((std::isnan(first.magic[0]) && std::isnan(first.deficient[2])));
    CHECK(first.magic[3] == 1.0);
    const Range last = fast_range(largest - 1, 4, set);
    CHECK((last.magic[1] > 0.0 && std::isnan(last.magic[2]) && std::isnan(last.deficient[3])));
  }
}

TEST_CASE("ranges of different sizes are refused", "[exam]") {
  std::vector<double> magic(4), deficient(3);
  CHECK_THROWS_WITH(
      fast::ratios(1, magic, deficient),
      "all spans must have the same size, but deficient has 3 elements and magic has 4");
}
