// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "derivation/derivation.hpp"
#include "proof/text.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;

TEST_CASE("complete transfer states what each step supposes", "[exam][shared]") {
  const derivation::Derivation& all = whole_derivation();
  REQUIRE_FALSE(all.refused);
  const proof::Theorem& trip = all.at("chain.round_trip");
  CHECK(proof::to_text(trip.statement()) == "w(K) = -v(1)");
  // Each way: one at a time, its own magic ratio, and which run it is; at the wall: the energy, and a bounce.
  const auto& conditions = trip.step().conditions;
  for (const char* way : {"v(j + 1) = b(k); v(j) = V", "w(j + 1) = -b(k); w(j) = -V"})
    CHECK(std::count_if(conditions.begin(), conditions.end(), [&](const std::string& condition) {
            const auto says = [&](const char* part) {
              return condition.find(part) != std::string::npos;
            };
            return says("a run and values of its own") && says(way) &&
                   says("psi = 2*pi/(2*k + 1)") && says("L*(1 - alpha)/(1 + alpha) <= d");
          }) == 1);
  for (const char* wall : {"w(1) != v(K)", "w(1)^2 = v(K)^2"})
    CHECK(std::find(conditions.begin(), conditions.end(), wall) != conditions.end());
}
