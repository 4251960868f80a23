// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/timing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "report/processor_clock.hpp"

using namespace magicmass::report;

namespace {

/// Takes `cost` by its own clock for each input, ten times that above index 100, and is expected to.
Contestant pretended(const std::string& name, double cost, bool is_naive = false) {
  Contestant one{.name = name, .quantity = "numbers", .form = "closed", .precision = "double"};
  one.is_naive = is_naive;
  one.can = [](const Input&) { return true; };
  one.evaluate_all = [](std::span<const Input>) {};
  one.own_clock = [cost](std::span<const Input> inputs, std::size_t repetitions) {
    double all = 0.0;
    for (const Input& input : inputs) all += input.index > 100 ? 10 * cost : cost;
    return all * static_cast<double>(repetitions);
  };
  one.expected_ns = [cost](const Input& input) { return input.index > 100 ? 10 * cost : cost; };
  return one;
}

Family numbers(const std::string& name, std::int64_t first, std::int64_t last) {
  Family family{name, "", "numbers", {}};
  for (std::int64_t i = first; i <= last; ++i) family.inputs.push_back({1.0, i});
  return family;
}

TimingPlan short_plan() {
  TimingPlan plan;
  plan.rounds.rounds = 7;
  plan.rounds.shortest_ns = 1.0;
  return plan;
}

const TimeRow& row_of(const std::vector<TimeRow>& rows, const std::string& name,
                      const std::string& family) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const TimeRow& row) {
    return row.contestant == name && row.family == family;
  });
  REQUIRE(found != rows.end());
  return *found;
}

}  // namespace

TEST_CASE("each family has its own times, so that a slow branch hides behind no average",
          "[exam]") {
  const std::vector<Contestant> contestants = {pretended("new", 5.0),
                                               pretended("naive", 20.0, true)};
  const std::vector<TimeRow> rows = time_families(
      contestants, {numbers("small", 1, 100), numbers("large", 101, 150)}, short_plan());
  REQUIRE(rows.size() == 4);
  CHECK(row_of(rows, "new", "small").ns_median == Approx(5.0));
  CHECK(row_of(rows, "new", "large").ns_median == Approx(50.0));
  CHECK(row_of(rows, "new", "large").ns_minimum == Approx(50.0));
  for (const TimeRow& row : rows) {
    CHECK(row.rounds == 7);
    CHECK(row.ratio == Approx(row.contestant == "new" ? 0.25 : 1.0));
    CHECK(std::isnan(row.ratio_low));  // one process says nothing of the next
  }
}

TEST_CASE("the slowest call is found, with its input", "[exam]") {
  const Family family = numbers("mostly small", 60, 101);
  const SlowestCall slowest = slowest_call(pretended("new", 5.0), family.inputs);
  CHECK(slowest.ns == Approx(50.0));
  CHECK(slowest.input.index == 101);
}

TEST_CASE("ratios are taken on the same inputs, where one of the two cannot do them all",
          "[exam]") {
  std::vector<Contestant> contestants = {pretended("new", 5.0), pretended("naive", 20.0, true)};
  contestants[0].can = [](const Input& input) { return input.index > 100; };
  const std::vector<TimeRow> rows =
      time_families(contestants, {numbers("both", 1, 200)}, short_plan());
  REQUIRE(rows.size() == 2);  // naive's companion on new's inputs is no row
  CHECK(row_of(rows, "new", "both").ratio == Approx(0.25));
  CHECK(row_of(rows, "new", "both").inputs == 100);
  CHECK(row_of(rows, "naive", "both").inputs == 200);
  contestants[1].can = [](const Input& input) { return input.index <= 150; };
  const std::vector<TimeRow> apart =
      time_families(contestants, {numbers("both", 1, 200)}, short_plan());
  CHECK(std::isnan(row_of(apart, "new", "both").ratio));  // nothing to compare with
  contestants[0].can = [](const Input&) { return false; };
  CHECK(time_families(contestants, {numbers("both", 1, 200)}, short_plan()).size() == 1);
}

TEST_CASE("a slow contestant samples half or half of these, and what takes too long is left out",
          "[exam]") {
  const Family family = numbers("both", 1, 200);
  TimingPlan plan = short_plan();
  plan.longest_pass_ns = 200.0 * 50.0;
  CHECK(timed_inputs(pretended("fast", 5.0), family.inputs, plan).size() == 200);
  CHECK(timed_inputs(pretended("slow", 50.0), family.inputs, plan).size() == 25);
  plan.longest_call_ns = 100.0;
  CHECK(timed_inputs(pretended("slow", 50.0), family.inputs, plan).size() == 100);
  plan.inputs = 10;
  Contestant unknown = pretended("unknown", 5.0);
  unknown.expected_ns = {};
  CHECK(timed_inputs(unknown, family.inputs, plan).size() == 10);
}

TEST_CASE("which inputs are timed does not depend on how long they take", "[exam]") {
  const Family family = numbers("both", 1, 200);
  TimingPlan plan = short_plan();
  plan.longest_pass_ns = 200.0 * 50.0;
  Contestant slow_today = pretended("new", 50.0);
  slow_today.own_clock = [](std::span<const Input>, std::size_t) { return 1e9; };
  const std::vector<Input> first = timed_inputs(pretended("new", 50.0), family.inputs, plan);
  const std::vector<Input> again = timed_inputs(slow_today, family.inputs, plan);
  REQUIRE(first.size() == 25);
  REQUIRE(again.size() == 25);
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].index == again[i].index);
}

TEST_CASE("stopped before six rounds there are no rows", "[exam]") {
  TimingPlan plan = short_plan();
  int asked = 0;
  plan.rounds.go_on = [&](double) { return ++asked < 8; };
  const std::vector<Contestant> one = {pretended("naive", 20.0, true)};
  CHECK(time_families(one, {numbers("small", 1, 100)}, plan).empty());
  plan.rounds.go_on = [&](double) { return ++asked < 18; };
  const auto rows = time_families(one, {numbers("small", 1, 100)}, plan);
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].rounds >= 6);
}

// Not gated on: a loaded machine may be slow.
TEST_CASE("latency, throughput and cycles of a known loop", "[time]") {
  Contestant one{
      .name = "multiply", .quantity = "numbers", .form = "closed", .precision = "double"};
  one.is_naive = true;
  one.can = [](const Input&) { return true; };
  one.evaluate_all = [](std::span<const Input> inputs) {
    for (const Input& input : inputs) {
      const std::int64_t square = input.index * input.index;
      asm volatile("" : : "r"(square));
    }
  };
  one.evaluate_chained = [](std::span<const Input> inputs) {
    std::int64_t chain = 1;
    for (const Input& input : inputs) chain = (chain * input.index) * input.index;
    asm volatile("" : : "r"(chain));
  };
  const std::vector<TimeRow> rows = time_families({one}, {numbers("some", 1, 512)}, TimingPlan());
  REQUIRE(rows.size() == 1);
  WARN("throughput " << rows[0].ns_median << " ns, latency " << rows[0].latency_ns << " ns, "
                     << rows[0].cycles.value_or(0) << " cycles");
  CHECK(rows[0].latency_ns > rows[0].ns_median);
}
