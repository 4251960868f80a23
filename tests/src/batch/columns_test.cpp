// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/batch/columns.hpp"

#include <array>
#include <cstdint>
#include <span>

#include <catch2/catch.hpp>

#include "magicmass/batch.hpp"
#include "magicmass/errors.hpp"

using namespace magicmass;

TEST_CASE("spans of different sizes are refused, and nothing is written", "[exam]") {
  const std::array<double, 4> alpha{1.0, 1.0, 1.0, 1.0};
  std::array<std::int64_t, 4> N_A{}, N_B{};
  CHECK_THROWS_WITH(count_collisions(alpha, N_A, std::span(N_B).first(3)),
                    "all spans must have the same size, but N_B has 3 elements and alpha has 4");
  CHECK_THROWS_AS(count_collisions(std::span(alpha).first(2), N_A, N_B), InvalidInput);
  CHECK(N_A == std::array<std::int64_t, 4>{});
}

TEST_CASE("outputs that overlap anything are refused", "[exam]") {
  alignas(8) std::array<std::byte, 8 * 40> bytes{};
  const std::span<double> alpha(reinterpret_cast<double*>(bytes.data()), 20);
  const std::span<std::int64_t> counts(reinterpret_cast<std::int64_t*>(bytes.data()), 40);
  std::array<std::int64_t, 10> apart{};
  const auto call = [](auto in, auto A, auto B) {
    count_collisions(in, std::span<std::int64_t>(A), std::span<std::int64_t>(B));
  };
  CHECK_THROWS_WITH(call(alpha.first(10), counts.subspan(9, 10), apart),
                    "an output must not overlap another span, but alpha and N_A share elements");
  CHECK_THROWS_AS(call(alpha.first(10), counts.first(10), apart), InvalidInput);
  CHECK_THROWS_WITH(call(alpha.first(10), counts.subspan(20, 10), counts.subspan(29, 10)),
                    "an output must not overlap another span, but N_A and N_B share elements");
}

TEST_CASE("spans that touch, share an input or are empty pass", "[exam]") {
  using batch::input;
  using batch::output;
  std::array<double, 30> numbers{};
  const std::span<double> all(numbers);
  const std::span<const double> given(numbers);
  CHECK_NOTHROW(batch::require_separate_columns(
      {input("x", given.first(10)), input("y", given.first(10)), output("z", all.subspan(10, 10)),
       output("w", all.subspan(20, 10))}));
  CHECK_NOTHROW(batch::require_separate_columns(
      {input("x", given.first(0)), output("y", all.first(0)), output("z", std::span<double>())}));
}
