// SPDX-License-Identifier: GPL-2.0-or-later
// Answers from theorems against the oracle, which knows the collision law alone.
#include "answers/motion.hpp"

#include "answers/errors.hpp"
#include "catch.hpp"
#include "magicmass/oracle/certain.hpp"
#include "magicmass/oracle/quantities.hpp"

using namespace answers;
namespace oracle = magicmass::oracle;

namespace {
oracle::MassRatio same(const notation::Alpha& alpha) {
  if (const auto* at = std::get_if<notation::Threshold>(&alpha))
    return at->is_magic ? oracle::magic(at->k) : oracle::deficient(at->k);
  if (const auto* value = std::get_if<double>(&alpha)) return oracle::ratio(balls::exact(*value));
  return oracle::ratio(std::get<cln::cl_RA>(alpha));
}
}  // namespace

TEST_CASE("counts are the oracle's, at any size and beside thresholds") {
  for (const char* text :
       {"1", "2", "1e300", "0.5", "1/7", "0.12", "1e-9", "1e-60", "1e-300", "5e-324", "1/3",
        "0x1.1c7397cb68b7ep-18", "0x1.bc7fb47556f22p-29", "0x1.fffffffffffffp-1"}) {
    INFO(text);
    const notation::Alpha alpha = alpha_of(text);
    const LargeCounts counts = count_collisions(alpha);
    const oracle::Counts expected = oracle::count_collisions(*same(alpha).rational);
    CHECK(counts.N_A == expected.N_A);
    CHECK(counts.N_B == expected.N_B);
  }
  CHECK_THROWS_AS(alpha_of("1e-19/3e7"), InvalidInput);
}

TEST_CASE("velocities are the doubles nearest to the oracle's") {
  const std::pair<const char*, int> rows[] = {
      {"1/7", 0},   {"1/7", 3},     {"0.12", 2},    {"1e-9", 30000},    {"5", 1},
      {"1", 1},     {"magic:3", 3}, {"magic:3", 2}, {"deficient:2", 3}, {"magic:1000", 700},
      {"1e-300", 5}};
  for (const auto& row : rows) {
    INFO(row.first << " " << row.second);
    const notation::Alpha alpha = alpha_of(row.first);
    const int n = row.second;
    const auto got = rounded([&] { return velocities(alpha, n); });
    const auto expected = oracle::certain(same(alpha), oracle::OfCycle(n), oracle::to_double());
    for (std::size_t i = 0; i < 4; ++i) CHECK(got[i].text == real_cell(expected[i]).text);
  }
}

TEST_CASE("what no digits can show is undecided, never a guess") {
  // a_2 = 0 at magic:2 by theorem; without it no precision tells 0.
  const notation::Alpha alpha = alpha_of("magic:2");
  CHECK(rounded([&] { return velocities(alpha, 2); }, 5)[0].text == "0");
  const auto close_to_0 = [&] { return Balls{velocities(alpha, 2)[1] - Ball(1)}; };
  CHECK_THROWS_AS(rounded(close_to_0, 5), Undecided);
}
