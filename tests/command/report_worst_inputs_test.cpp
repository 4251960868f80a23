// SPDX-License-Identifier: GPL-2.0-or-later
// The pinned worst inputs of quantities whose exact values are their own theorems': that takes the derivation.
#include <catch2/catch.hpp>

#include "command/report/exact_formulas.hpp"
#include "derivation/derivation.hpp"
#include "report/pinned_inputs.hpp"
#include "report/quantities.hpp"

using namespace magicmass;

namespace {

std::vector<std::string> known_by_theorem_alone() {
  std::vector<std::string> names;
  for (const report::Quantity& quantity : report::quantities())
    if (!quantity.is_known) names.push_back(quantity.name);
  return names;
}

report::Oracle taught_oracle() {
  report::Oracle oracle;
  command::teach(oracle,
                 command::derived_forms(derivation::derive().theorems, known_by_theorem_alone()));
  return oracle;
}

}  // namespace

TEST_CASE("pinned inputs known by theorem alone are no worse than when they were found", "[exam]") {
  report::Oracle oracle = taught_oracle();
  for (const std::string& quantity : known_by_theorem_alone()) {
    INFO(quantity);
    CHECK(testing::replay_pinned(quantity, oracle) > 0);
  }
}

TEST_CASE("pin the worst inputs known by theorem alone", "[.pin]") {
  report::Oracle oracle = taught_oracle();
  for (const std::string& quantity : known_by_theorem_alone())
    testing::pin_worst(quantity, oracle, 64);
}
