// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/conservation_audit.hpp"

#include <catch2/catch.hpp>

using namespace magicmass;

TEST_CASE("the audit keeps the largest departure it saw", "[exam]") {
  ConservationAudit<double> audit(0.5, {1.0, 0.0, 0.0});
  audit.look({1.0, 0.0, 0.0});
  CHECK(audit.largest().energy == 0.0);
  CHECK(audit.largest().momentum == 0.0);
  audit.look({1.0, 0.0, 0.5});  // energy 1.125, momentum 1.25
  CHECK(audit.largest().energy == 0.125);
  CHECK(audit.largest().momentum == 0.25);
  audit.look({0.5, 0.0, 0.0});  // energy 0.25, momentum 0.5
  CHECK(audit.largest().energy == 0.75);
  CHECK(audit.largest().momentum == 0.5);
  audit.look({1.0, 0.0, 0.0});
  CHECK(audit.largest().energy == 0.75);
}

TEST_CASE("a huge ball's energy does not underflow", "[exam]") {
  ConservationAudit<double> audit(1e308, {1.0, 0.0, 0.0});
  audit.look({0.0, 0.0, 1e-308});  // momentum 1, energy 1e-308
  CHECK(audit.largest().momentum < 1e-15);
  CHECK(audit.largest().energy == 1.0);
  ConservationAudit<double> slow(1e308, {0.0, 0.0, 1e-154});
  slow.look({0.0, 0.0, 1e-154});
  CHECK(slow.largest().energy == 0.0);
}
