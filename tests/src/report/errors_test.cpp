// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/errors.hpp"

#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

#include "report/contestants.hpp"
#include "report/evaluation.hpp"
#include "report/last_collision.hpp"

using namespace magicmass;
using namespace magicmass::report;

namespace {

/// Correctly rounded velocities but for b, which is `ulps` off where `planted` says so.
Contestant planted(const std::shared_ptr<Oracle>& oracle, double ulps,
                   bool (*where)(const Input&)) {
  Contestant one;
  one.name = "planted";
  one.quantity = "velocities";
  one.precision = "double";
  one.can = [](const Input&) { return true; };
  one.evaluate = [=](const Input& input, long double* members) {
    for (const ExactValue& exact : oracle->at("velocities", input))
      *members++ = exact.nearest_double;
    members -= 4;
    const auto b = static_cast<double>(members[1]);
    // below b, which may be the power of two that the exact value just falls short of
    const double ulp = std::fabs(b) - std::nextafter(std::fabs(b), 0.0);
    if (where(input)) members[1] = b - ulps * ulp;
  };
  return one;
}

bool is_close_to_a_threshold(const Input& input) {
  return std::fabs(input.alpha / 0x1.1c7397cb68b7ep-18 - 1) < 0x1p-48;
}

bool same(const ErrorRow& x, const ErrorRow& y) {
  return x.contestant == y.contestant && x.member == y.member && x.family == y.family &&
         x.samples == y.samples && x.climbed == y.climbed && x.max_ulp == y.max_ulp &&
         x.worst.alpha == y.worst.alpha && x.worst.index == y.worst.index &&
         x.ulp_999 == y.ulp_999 && x.ulp_median == y.ulp_median &&
         x.correctly_rounded == y.correctly_rounded && x.wrong_signs == y.wrong_signs &&
         x.over_envelope == y.over_envelope && x.max_eps == y.max_eps &&
         x.max_promise_eps == y.max_promise_eps && x.wrong == y.wrong;
}

}  // namespace

TEST_CASE("3 ulp planted on one family are found on that family and on no other", "[exam]") {
  const auto oracle = std::make_shared<Oracle>();
  const Contestant wrong = planted(oracle, 3, is_close_to_a_threshold);
  int found = 0;
  for (const Family& family : families("velocities", 40))
    for (const ErrorRow& row : measure(wrong, family, *oracle, {10})) {
      INFO(row.family << " " << row.member);
      const bool is_there = row.family == "closest thresholds" && row.member == "b";
      found += is_there ? 1 : 0;
      if (is_there) {
        CHECK(row.max_ulp > 2.4);
        CHECK(row.max_ulp < 3.6);
        CHECK(is_close_to_a_threshold(row.worst));
        CHECK(row.correctly_rounded < 1);
      } else if (row.samples > 0) {
        CHECK(row.max_ulp <= 0.5);
        CHECK(row.correctly_rounded == 1);
        CHECK(row.wrong_signs == 0);
      }
    }
  CHECK(found == 1);
}

TEST_CASE("a broken promise is said to be broken", "[exam]") {
  const auto oracle = std::make_shared<Oracle>();
  Contestant wrong = planted(oracle, 3, [](const Input&) { return true; });
  const Family family{"one", "", "velocities", {{0.1, 2}, {0.01, 3}}};
  CHECK(measure(wrong, family, *oracle, {0})[1].promise_kept);
  wrong.ulp_bound = 2;
  CHECK_FALSE(measure(wrong, family, *oracle, {0})[1].promise_kept);
  CHECK(measure(wrong, family, *oracle, {0})[0].promise_kept);
  wrong.ulp_bound = 4;
  CHECK(measure(wrong, family, *oracle, {0})[1].promise_kept);
}

TEST_CASE("the climb finds the hill beside the samples", "[exam]") {
  const auto oracle = std::make_shared<Oracle>();
  // an error that grows by an ulp a double towards 0.1 + 40 ulp, and is seen from 0.1
  Contestant hill = planted(oracle, 0, [](const Input&) { return false; });
  const auto right = hill.evaluate;
  hill.evaluate = [right](const Input& input, long double* members) {
    right(input, members);
    const double steps = std::fabs((input.alpha - 0.1) / 0x1p-56 - 40);
    if (steps < 100) members[1] += (100 - steps) * 0x1p-53;
  };
  const Family family{"one", "", "velocities", {{0.1, 3}}};
  const ErrorRow still = measure(hill, family, *oracle, {0})[1];
  const ErrorRow climbed = measure(hill, family, *oracle, {200})[1];
  CHECK(still.climbed == 0);
  CHECK(climbed.climbed > 0);
  CHECK(still.max_ulp < 62);
  CHECK(climbed.max_ulp > 99);
  CHECK(climbed.samples == 1);
  CHECK(climbed.ulp_median == still.ulp_median);
}

TEST_CASE("two runs agree on every figure", "[exam]") {
  for (const std::string quantity : {"velocities", "counts"})
    for (const Contestant& one : contestants(quantity)) {
      Oracle first, second;
      for (const Family& family : families(quantity, 12)) {
        if (family.name != "zeros" && family.name != "everyday") continue;
        const auto once = measure(one, family, first, {6});
        const auto twice = measure(one, family, second, {6});
        REQUIRE(once.size() == twice.size());
        for (std::size_t i = 0; i < once.size(); ++i) CHECK(same(once[i], twice[i]));
      }
    }
}

TEST_CASE("an input is rounded to what the contestant takes", "[exam]") {
  const Input rounded = rounded_input({0.1, 4}, "velocities", "float");
  CHECK(rounded.alpha == static_cast<double>(0.1F));
  CHECK(rounded_input({1e-300, 4}, "velocities", "float").alpha == 0);
  CHECK(rounded_input({0.1, 4}, "velocities", "double").alpha == 0.1);
  // 0.99999999999 has N_A = 2, its float is 1 with N_A = 1
  CHECK(rounded_input({0.99999999999, 2}, "velocities", "float").index == 1);
  Oracle oracle;
  const Contestant one = generated_contestants("velocities").at(0);
  CHECK_FALSE(compared(one, {0.0, 0}, oracle));
  CHECK_FALSE(compared(one, {HUGE_VAL, 0}, oracle));
  CHECK_FALSE(compared(one, {0.1, 5}, oracle));
  CHECK_FALSE(compared(one, {0.1, -1}, oracle));
  CHECK_FALSE(compared(one, {0.1, 4}, oracle)->at(1));
}
