// SPDX-License-Identifier: GPL-2.0-or-later
// Batches of velocities on every instruction set of this machine: the same bits, and in tier accurate those of one input.
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
#include "magicmass/fast.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

using Run = void (*)(std::span<const double>, std::span<const std::int64_t>, std::span<double>,
                     std::span<double>, std::span<double>, std::span<double>, InstructionSet);
constexpr Run tiers[] = {fast::velocities, accurate::velocities};
constexpr double untouched = -77.0;

struct Inputs {
  std::vector<double> alpha;
  std::vector<std::int64_t> n;

  void add(double a, std::int64_t index) {
    alpha.push_back(a);
    n.push_back(index);
  }
};

/// a, b, c and c' one after the other; columns begin `offset` doubles into rooms that stay untouched elsewhere.
std::vector<double> rows(Run run, const Inputs& in, std::size_t first, std::size_t size,
                         InstructionSet set, std::size_t offset = 0) {
  const std::size_t room = size + offset + 1;
  std::vector<double> all(4 * room, untouched);
  const auto column = [&](std::size_t v) {
    return std::span(all).subspan(v * room + offset, size);
  };
  run(std::span(in.alpha).subspan(first, size), std::span(in.n).subspan(first, size), column(0),
      column(1), column(2), column(3), set);
  std::vector<double> results;
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t i = 0; i < offset; ++i) CHECK(all[v * room + i] == untouched);
    CHECK(all[v * room + offset + size] == untouched);
    results.insert(results.end(), column(v).begin(), column(v).end());
  }
  return results;
}

bool alike(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) ||
         (std::isnan(x) && std::isnan(y));
}

/// The rows have the same bits on every instruction set; returns them.
std::vector<double> require_same(Run run, const Inputs& in) {
  const auto expected = rows(run, in, 0, in.n.size(), InstructionSet::baseline);
  for (const InstructionSet set : testing::available_instruction_sets()) {
    const auto got = rows(run, in, 0, in.n.size(), set);
    for (std::size_t i = 0; i < got.size(); ++i) {
      const std::size_t row = i % in.n.size();
      INFO(to_text(set) << ", alpha = " << in.alpha[row] << ", n = " << in.n[row]);
      REQUIRE(alike(got[i], expected[i]));
    }
  }
  return expected;
}

void require_those_of_one(const Inputs& in) {
  const auto got = require_same(accurate::velocities, in);
  const std::size_t size = in.n.size();
  for (std::size_t i = 0; i < size; ++i) {
    const auto one = accurate::velocities(in.alpha[i], in.n[i]);
    INFO("alpha = " << in.alpha[i] << ", n = " << in.n[i]);
    REQUIRE((got[i] == one.a && got[size + i] == one.b && got[2 * size + i] == one.c &&
             got[3 * size + i] == one.c_prime));
  }
}

Inputs random_inputs(std::uint64_t seed, std::size_t size, double low, double high) {
  testing::Generator generator(seed);
  Inputs in;
  while (in.n.size() < size) {
    const double alpha = testing::log_uniform(generator, low, high);
    in.add(alpha, testing::whole(generator, 0, count_collisions(alpha)->N_A));
  }
  return in;
}

/// What the kernels do not take, and what is hard, among rows that they take.
Inputs mixed(std::uint64_t seed, std::size_t size) {
  testing::Generator generator(seed);
  Inputs in = random_inputs(seed, size, 1e-6, 10.0);
  const double ends[] = {5e-324, 0x1p-1022, 0x1p-120, 0x1p60, 1e308, 1.0, 0x1p-121, 0x1p61};
  constexpr std::int64_t two_51 = std::int64_t{1} << 51U;
  for (std::size_t i = 0; i < size; ++i) {
    const auto kind = testing::whole(generator, 0, 9);
    if (kind == 0) {
      in.alpha[i] = ends[testing::whole(generator, 0, 7)];
      in.n[i] = testing::whole(generator, 0, 1);
    }
    if (kind == 1) {
      in.alpha[i] = testing::log_uniform(generator, 1e-37, 1e-32);
      in.n[i] = testing::whole(generator, two_51 - 2, two_51 + 2);
    }
    if (kind == 2) in.n[i] = 0;
    if (kind == 3) in.n[i] = count_collisions(in.alpha[i])->N_A;
  }
  return in;
}

}  // namespace

TEST_CASE("accurate batches of velocities are those of one input, the same everywhere", "[check]") {
  require_those_of_one(random_inputs(101, 50'000, 1e-6, 10.0));
  require_those_of_one(random_inputs(102, 10'000, 1e-26, 1.0));
  require_those_of_one(random_inputs(103, 3'000, 1.0, 1e18));
  require_those_of_one(mixed(104, 3'000));
}

TEST_CASE("fast batches of velocities are the same bits everywhere, and near the nearest doubles",
          "[check]") {
  for (const Inputs& in : {random_inputs(105, 50'000, 1e-6, 10.0), mixed(106, 3'000),
                           random_inputs(107, 5'000, 1e-26, 1e18)}) {
    const auto got = require_same(fast::velocities, in);
    const auto nearest = require_same(accurate::velocities, in);
    const std::size_t size = in.n.size();
    for (std::size_t i = 0; i < size; ++i) {
      // 4 eps of the largest velocity of each body, tier fast's other promise; A's is 1
      INFO("alpha = " << in.alpha[i] << ", n = " << in.n[i]);
      REQUIRE(std::fabs(got[i] - nearest[i]) <= 4 * std::numeric_limits<double>::epsilon());
    }
  }
}

TEST_CASE("n from 2^51 on, where a double no longer takes its double", "[check]") {
  testing::Generator generator(108);
  Inputs in;
  for (int i = 0; i < 600; ++i)
    in.add(testing::log_uniform(generator, 6e-38, 1e-36),
           testing::whole(generator, (std::int64_t{1} << 51U) - 20, std::int64_t{1} << 61U));
  require_those_of_one(in);
  const auto fast = require_same(fast::velocities, in);
  for (std::size_t i = 0; i < in.n.size(); ++i)
    CHECK(fast[i] == fast::velocities(in.alpha[i], in.n[i]).a);
}

TEST_CASE("velocities of tails of every length, at every offset", "[exam]") {
  const Inputs in = mixed(109, 300);
  for (const Run run : tiers) {
    const auto all = rows(run, in, 0, 300, InstructionSet::baseline);
    for (const InstructionSet set : testing::available_instruction_sets()) {
      for (std::size_t size = 0; size <= 33; ++size) {
        for (const std::size_t whole_blocks : {0U, 128U}) {
          const std::size_t length = size + whole_blocks, first = size % 11;
          const auto got = rows(run, in, first, length, set, size % 8);
          for (std::size_t i = 0; i < got.size(); ++i) {
            INFO(to_text(set) << ", size " << length << ", place " << i);
            REQUIRE(alike(got[i], all[i / length * 300 + first + i % length]));
          }
        }
      }
    }
  }
}

TEST_CASE("rows without an answer are NaN in their place alone", "[exam]") {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  for (const Run run : tiers) {
    for (const InstructionSet set : testing::available_instruction_sets()) {
      for (const auto& [alpha, n] :
           std::initializer_list<std::pair<double, std::int64_t>>{{0.0, 1},
                                                                  {-0.0, 0},
                                                                  {-1.0, 1},
                                                                  {-0.1, 0},
                                                                  {infinity, 1},
                                                                  {-infinity, 0},
                                                                  {nan, 1},
                                                                  {-nan, 1},
                                                                  {-5e-324, 3},
                                                                  {0.1, -1},
                                                                  {0.1, least},
                                                                  {2.0, least},
                                                                  {2.0, -1}}) {
        Inputs in = random_inputs(110, 20, 0.01, 3.0);
        const auto before = rows(run, in, 0, 20, set);
        in.alpha[7] = alpha;
        in.n[7] = n;
        const auto got = rows(run, in, 0, 20, set);
        for (std::size_t i = 0; i < got.size(); ++i) {
          INFO(to_text(set) << ", alpha = " << alpha << ", n = " << n << ", place " << i);
          if (i % 20 == 7)
            CHECK(std::isnan(got[i]));
          else
            CHECK(alike(got[i], before[i]));
        }
      }
    }
  }
}

TEST_CASE("past the last collision accurate rows go on, and never stop the others", "[exam]") {
  Inputs in = random_inputs(111, 40, 0.01, 0.9);
  for (std::size_t i = 0; i < 40; i += 3) in.n[i] += 5 * (1 + in.n[i]);
  require_those_of_one(in);
  require_same(fast::velocities, in);
  in.add(2.0, 7);
  in.add(1.0, std::numeric_limits<std::int64_t>::max());
  require_those_of_one(in);
}

TEST_CASE("velocities: other sizes or spans that overlap are refused, and nothing is written",
          "[exam]") {
  const std::vector<double> alpha(4, 0.1);
  const std::vector<std::int64_t> n(4, 1);
  std::vector<double> room(40, untouched);
  const auto at = [&](std::size_t first, std::size_t size = 4) {
    return std::span(room).subspan(first, size);
  };
  for (const Run run : tiers) {
    const auto set = InstructionSet::baseline;
    CHECK_THROWS_WITH(
        run(alpha, n, at(0), at(4), at(8), at(12, 5), set),
        "all spans must have the same size, but c_prime has 5 elements and alpha has 4");
    CHECK_THROWS_AS(run(alpha, std::span(n).first(3), at(0), at(4), at(8), at(12), set),
                    InvalidInput);
    CHECK_THROWS_WITH(run(alpha, n, at(0), at(3), at(8), at(12), set),
                      "an output must not overlap another span, but a and b share elements");
    CHECK_THROWS_WITH(run(at(2), n, at(0), at(8), at(12), at(16), set),
                      "an output must not overlap another span, but alpha and a share elements");
    CHECK_THROWS_AS(run(alpha, n, at(0), at(4), at(4), at(12), set), InvalidInput);
  }
  CHECK(room == std::vector<double>(40, untouched));
}
