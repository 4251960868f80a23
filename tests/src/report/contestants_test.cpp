// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/contestants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>

#include "magicmass/evaluators.hpp"
#include "report/errors.hpp"
#include "report/evaluation.hpp"
#include "report/quantities.hpp"

using namespace magicmass;
using namespace magicmass::report;

namespace {

Contestant contestant(const std::string& quantity, const std::string& name,
                      const std::string& precision = "double") {
  for (Contestant& one : contestants(quantity))
    if (one.name == name && one.precision == precision) return one;
  FAIL("no contestant " << name << " for " << quantity);
  return {};
}

Deviation deviation_of(const Contestant& one, const Input& input, std::size_t member) {
  Oracle oracle;
  return compared(one, input, oracle).value().at(member).value();
}

Family family(const std::string& quantity, const std::string& name, std::size_t size) {
  for (Family& one : families(quantity, size))
    if (one.name == name) return one;
  FAIL("no family " << name);
  return {};
}

}  // namespace

TEST_CASE("each has a name of its own, and one is naive in double", "[exam]") {
  for (const Quantity& quantity : quantities()) {
    std::set<std::tuple<std::string, std::string>> names;
    int naive = 0;
    for (const Contestant& one : contestants(quantity.name)) {
      CHECK(one.quantity == quantity.name);
      CHECK(names.emplace(one.name, one.precision).second);
      naive += one.is_naive && one.precision == "double" ? 1 : 0;
    }
    CHECK(naive == (quantity.is_known ? 1 : 0));
    CHECK(names.size() >= 3);
  }
}

TEST_CASE("on an easy input each is right to a thousandth, one by one and in its loops", "[exam]") {
  for (const Quantity& quantity : quantities()) {
    if (!quantity.is_known) continue;  // nor does the oracle know it by itself
    const std::vector<Input> inputs(6, Input{0.125, 2});
    for (const Contestant& one : contestants(quantity.name)) {
      INFO(one.name << " " << one.precision);
      REQUIRE(one.can(inputs[0]));
      Oracle oracle;
      const auto& exact = oracle.at(quantity.name, inputs[0]);
      std::array<long double, 5> got{};
      if (!one.is_yardstick) one.evaluate(inputs[0], got.data());
      for (std::size_t i = 0; i < exact.size() && !one.is_yardstick; ++i)
        CHECK(std::fabs(got[i] - exact[i].high) <= std::fabs(exact[i].high) * 1e-3L);
      CHECK_NOTHROW(one.evaluate_all(inputs));
      if (one.evaluate_chained) CHECK_NOTHROW(one.evaluate_chained(inputs));
      CHECK(one.evaluate_chained.operator bool() != one.prepare.operator bool());
    }
  }
}

TEST_CASE("the tables' evaluators are all there in three precisions", "[exam]") {
  std::size_t expected = 0;
  for (const auto& row : generated::velocity_evaluators<double>()) {
    for (const char* precision : {"float", "double", "long double"}) {
      const Contestant one = contestant("velocities", row.name, precision);
      CHECK(one.form == row.form);
      CHECK(one.eps_bound == row.eps_bound);
    }
    expected += 3;
  }
  CHECK(generated_contestants("velocities").size() == expected);
  CHECK(generated_contestants("counts").empty());
}

TEST_CASE("the canary sings: naive N_A is wrong at about four in ten thresholds", "[exam]") {
  Oracle oracle;
  const auto wrong_share = [&](const char* name) {
    const ErrorRow row =
        measure(contestant("counts", name), family("counts", "zeros", 600), oracle, {0})[0];
    REQUIRE(row.samples > 400);
    return static_cast<double>(row.wrong) / static_cast<double>(row.samples);
  };
  CHECK(wrong_share("naive") > 0.3);
  CHECK(wrong_share("naive") < 0.5);
  CHECK(wrong_share("count_collisions") == 0);
}

TEST_CASE("the canary sings: naive b_n has no correct digit at 1e-300", "[exam]") {
  for (const std::int64_t n : {1, 5, 1000})
    CHECK(deviation_of(contestant("velocities", "naive"), {1e-300, n}, 1).ulp > 0x1p51);
  for (const std::int64_t n : {1, 5, 1000})
    CHECK(deviation_of(contestant("velocities", "velocities_product"), {1e-300, n}, 1).ulp < 8);
}

TEST_CASE("the canary sings: naive a_1 has no correct digit above 1e155", "[exam]") {
  for (const double alpha : {1e155, 1e200, 1e308}) {
    const Deviation naive = deviation_of(contestant("velocities", "naive"), {alpha, 1}, 0);
    CHECK(naive.ulp > 0x1p51);
    CHECK(deviation_of(contestant("velocities", "velocities_product"), {alpha, 1}, 0).ulp < 8);
  }
}

TEST_CASE("what rounds exact rationals is correctly rounded wherever it goes", "[check]") {
  Oracle oracle;
  for (const std::string quantity : {"velocities", "encounters"}) {
    std::size_t samples = 0;
    for (const Family& one : families(quantity, 60))
      for (const ErrorRow& row :
           measure(contestant(quantity, "exact_rational"), one, oracle, {10})) {
        INFO(quantity << " " << row.member << " on " << row.family);
        samples += row.samples;
        CHECK(row.wrong_signs == 0);
        CHECK(row.promise_kept);
        if (row.samples > 0) CHECK(row.correctly_rounded == 1);
      }
    CHECK(samples > 500);
  }
}

TEST_CASE("every array function gives the same bits with every instruction set of this machine",
          "[check]") {
  for (const char* quantity : {"velocities", "elastic_terminal", "counts", "ratios", "sequence"}) {
    const std::vector<Contestant> all = contestants(quantity);
    for (const Contestant& one : all) {
      const bool is_narrow = one.name.ends_with("_avx2") || one.name.ends_with("_baseline");
      if (!is_narrow) continue;
      const std::string best = one.name.substr(0, one.name.rfind('_'));
      for (const Family& family : families(quantity, 20))
        for (const Input& input : family.inputs) {
          std::array<long double, 5> here{};
          std::array<long double, 5> there{};
          one.evaluate(input, here.data());
          contestant(quantity, best).evaluate(input, there.data());
          for (std::size_t i = 0; i < here.size(); ++i)
            CHECK((here[i] == there[i] || (std::isnan(here[i]) && std::isnan(there[i]))));
        }
    }
  }
}

TEST_CASE("stepping has no answer where it would take too long", "[exam]") {
  CHECK_FALSE(contestant("velocities", "stepping").can({1e-20, 1LL << 40}));
  CHECK_FALSE(contestant("counts", "stepping").can({1e-20, 0}));
  CHECK(contestant("counts", "stepping").can({1e-4, 0}));
}
