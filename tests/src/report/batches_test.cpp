// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/batches.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "report/portable_random.hpp"

using namespace magicmass::report;

namespace {

TimeRow row(const std::string& name, double ratio, double ns = 10.0) {
  TimeRow one;
  one.contestant = name;
  one.precision = "double";
  one.quantity = "numbers";
  one.family = "small";
  one.ratio = ratio;
  one.ratio_low = one.ratio_high = std::numeric_limits<double>::quiet_NaN();
  one.ns_median = one.ns_minimum = one.latency_ns = one.slowest_call_ns = ns;
  one.slowest = {ns, 0};
  one.cycles = 2 * ns;
  one.rounds = 6;
  return one;
}

std::vector<std::vector<TimeRow>> batches_of(const std::vector<double>& ratios) {
  std::vector<std::vector<TimeRow>> all;
  for (const double ratio : ratios) all.push_back({row("new", ratio)});
  return all;
}

}  // namespace

TEST_CASE("rounds are split among batches that give an interval, none is lost", "[exam]") {
  CHECK(batch_plan(51).batches == 9);
  CHECK(batch_plan(51).rounds == 6);
  for (const std::size_t rounds : {6U, 7U, 17U, 30U, 44U, 51U, 100U, 1001U}) {
    const BatchPlan plan = batch_plan(rounds);
    CHECK(plan.batches >= 6);
    CHECK(plan.batches * plan.rounds >= rounds);
    CHECK(plan.batches * (plan.rounds - 1) < rounds);
  }
}

TEST_CASE("of nine batches the interval leaves out the least and the largest", "[exam]") {
  const std::vector<TimeRow> rows =
      combined(batches_of({2.00, 2.01, 2.02, 2.03, 2.04, 2.05, 2.06, 2.07, 9.0}));
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].ratio == 2.04);
  CHECK(rows[0].ratio_low == 2.01);
  CHECK(rows[0].ratio_high == 2.07);
  CHECK(rows[0].rounds == 54);
  CHECK(rows[0].batches == 9);
  CHECK(rows[0].is_steady);
}

TEST_CASE("batches that disagree are said to, however well each knows its own ratio", "[exam]") {
  const std::vector<TimeRow> rows = combined(batches_of({1, 1, 1, 1, 1.2, 1.5, 1.5, 1.5, 1.5}));
  REQUIRE(rows.size() == 1);
  CHECK_FALSE(rows[0].is_steady);
  CHECK(rows[0].ratio_low == 1.0);
  CHECK(rows[0].ratio_high == 1.5);
}

TEST_CASE("no interval is narrower than the clock can tell, but naive is itself", "[exam]") {
  const TimeRow same = combined(batches_of(std::vector<double>(9, 3.0))).at(0);
  CHECK(same.ratio_low == Approx(3.0 * 0.998));
  CHECK(same.ratio_high == Approx(3.0 * 1.002));
  const TimeRow naive = combined(batches_of(std::vector<double>(9, 1.0))).at(0);
  CHECK(naive.ratio_low == 1.0);
  CHECK(naive.ratio_high == 1.0);
}

TEST_CASE("times are medians, the minimum is the least, the slowest call keeps its input",
          "[exam]") {
  std::vector<std::vector<TimeRow>> batches;
  for (const double ns : {30.0, 10.0, 20.0, 50.0, 40.0, 60.0, 70.0})
    batches.push_back({row("new", 2.0, ns), row("sometimes", 2.0)});
  batches.back().pop_back();
  const std::vector<TimeRow> rows = combined(batches);
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].ns_median == 40.0);
  CHECK(rows[0].ns_minimum == 10.0);
  CHECK(rows[0].cycles == 80.0);
  CHECK(rows[0].slowest_call_ns == 40.0);
  CHECK(rows[0].slowest.alpha == 40.0);
}

TEST_CASE("stopped early there are times and a ratio, but no interval", "[exam]") {
  CHECK(combined({}).empty());
  const TimeRow few = combined(batches_of({2.0, 2.1, 2.2, 2.3, 2.4})).at(0);
  CHECK(few.ratio == 2.2);
  CHECK(std::isnan(few.ratio_low));
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(combined(batches_of(std::vector<double>(9, none))).at(0).ratio_low));
}

TEST_CASE("intervals of two runs meet, also where each process has a ratio of its own", "[check]") {
  PortableRandom random(5);
  const auto run = [&] {
    std::vector<double> ratios;
    for (int i = 0; i < 9; ++i) ratios.push_back(2.0 * random.log_uniform(0.95, 1.05));
    return combined(batches_of(ratios)).at(0);
  };
  constexpr int pairs = 2000;
  int meet = 0;
  for (int i = 0; i < pairs; ++i) {
    const TimeRow one = run();
    const TimeRow other = run();
    meet += one.ratio_low <= other.ratio_high && other.ratio_low <= one.ratio_high ? 1 : 0;
  }
  CHECK(meet >= pairs - 20);  // 6.7 misses are expected: 164 of the 48620 orders of 9 and 9
}
