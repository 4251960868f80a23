// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/growth.hpp"

#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

using namespace magicmass::report;

namespace {

/// Takes index^1.5 nanoseconds by its own clock.
Contestant pretended(const std::string& quantity) {
  Contestant one{
      .name = "pretended", .quantity = quantity, .form = "closed", .precision = "double"};
  one.is_naive = true;
  one.can = [](const Input& input) { return input.index <= 4096; };
  one.evaluate_all = [](std::span<const Input>) {};
  one.own_clock = [](std::span<const Input> inputs, std::size_t repetitions) {
    double all = 0.0;
    for (const Input& input : inputs) all += std::pow(static_cast<double>(input.index), 1.5);
    return all * static_cast<double>(repetitions);
  };
  return one;
}

}  // namespace

TEST_CASE("the scales run up to the last collision, each x with inputs that exist", "[exam]") {
  for (const bool quick : {true, false})
    for (const Scale& scale : growth_scales(quick)) {
      INFO(scale.words);
      REQUIRE(scale.x.size() == scale.families.size());
      CHECK(scale.x.size() >= 6);
      for (const Family& family : scale.families) {
        CHECK(family.quantity == scale.quantity);
        CHECK(!family.inputs.empty());
        for (const Input& input : family.inputs) CHECK(input.index >= 1);
      }
    }
}

TEST_CASE("exponents of time and error are those of the work", "[exam]") {
  Scale scale{"n", "n", "numbers", {}, {}};
  for (std::int64_t n = 1; n <= 65536; n *= 4) {
    scale.x.push_back(static_cast<double>(n));
    scale.families.push_back({"n = " + std::to_string(n), "", "numbers", {{0.5, n}}});
  }
  const MeasureErrors errors = [](const Contestant&, const Family& family) {
    ErrorRow small;
    small.samples = 1;
    small.max_ulp = 0.25;
    ErrorRow large = small;
    large.max_ulp = static_cast<double>(family.inputs[0].index) * 2;
    ErrorRow none;
    none.max_ulp = 1e300;  // no samples, so not an error
    return std::vector<ErrorRow>{small, large, none};
  };
  TimingPlan plan;
  plan.rounds.rounds = 7;
  const std::vector<Growth> all =
      growth_along(scale, {pretended("numbers"), pretended("others")}, errors, plan);
  REQUIRE(all.size() == 1);
  REQUIRE(all[0].points.size() == 7);  // up to what it can do
  REQUIRE(all[0].time);
  CHECK(all[0].time->exponent == Approx(1.5));
  CHECK(all[0].time->spread < 1e-9);
  REQUIRE(all[0].error);
  CHECK(all[0].error->exponent == Approx(1.0));
  CHECK(all[0].points[1].max_ulp == 8.0);
}

TEST_CASE("a long array is walked through, a short one gone over again", "[exam]") {
  const std::vector<Input> inputs = {{0.5, 1}, {0.25, 2}, {0.125, 3}};
  Contestant one = pretended("numbers");
  one.own_clock = {};
  std::vector<std::size_t> passes;
  std::vector<const Input*> begins;
  one.evaluate_all = [&](std::span<const Input> window) {
    passes.push_back(window.size());
    begins.push_back(window.data());
  };
  const std::vector<Growth> all =
      growth_with_array_length("numbers", inputs, {one}, {64, 16384}, {.rounds = 2});
  REQUIRE(all.size() == 1);
  CHECK(all[0].points.size() == 2);
  CHECK(std::count(passes.begin(), passes.end(), std::size_t{64}) > 0);
  CHECK(std::count(passes.begin(), passes.end(), std::size_t{4096}) > 0);
  std::vector<const Input*> different;
  for (std::size_t i = 0; i < passes.size(); ++i)
    if (passes[i] == 4096) different.push_back(begins[i]);
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  CHECK(different.size() == 4);
}
