// SPDX-License-Identifier: GPL-2.0-or-later
#include <chrono>

#include <catch2/catch.hpp>

#include "derivation/derivation.hpp"

// Not gated on: a loaded machine may be slow.
TEST_CASE("deriving and proving everything takes less than two seconds", "[time]") {
  const auto start = std::chrono::steady_clock::now();
  const magicmass::derivation::Derivation result = magicmass::derivation::derive();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  WARN(result.theorems.size() << " steps in " << time.count() << " s");
  CHECK(time.count() < 2);
}
