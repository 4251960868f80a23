// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "derivation/derivation.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;

TEST_CASE("the table holds for every positive alpha, its tangents where they have no pole",
          "[exam][shared]") {
  const derivation::Derivation& all = whole_derivation();
  REQUIRE_FALSE(all.refused);
  int entries = 0;
  for (const proof::Theorem& theorem : all.theorems) {
    if (theorem.step().label.rfind("table:trig", 0) != 0) continue;
    ++entries;
    INFO(theorem.id());
    const auto& conditions = theorem.step().conditions;
    const bool has_pole = theorem.id() == "table.tan_theta" || theorem.id() == "table.tan_psi";
    CHECK((conditions == std::vector<std::string>{"alpha > 0"}) != has_pole);
    CHECK(std::any_of(conditions.begin(), conditions.end(), [](const std::string& condition) {
            return condition.find("!= 0") != std::string::npos;
          }) == has_pole);
  }
  CHECK(entries == 15);
}
