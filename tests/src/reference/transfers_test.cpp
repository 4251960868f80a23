// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/transfers.hpp"

#include <catch2/catch.hpp>

#include "magicmass/reference/trio_end.hpp"
#include "magicmass/simulator/line_motion.hpp"

using namespace magicmass;
using reference::FieldNumber;

namespace {

reference::ExactLine cradle(const std::string& balls, const std::string& more) {
  return reference::exact_line(
      parse_scene("kind = \"chain\"\nblocks = 3\nballs = " + balls + "\n" + more, "cradle"));
}

/// The paper's five blocks between walls, four balls of one kind, for the time of a thousand round trips.
reference::ExactLine five(const std::string& ball) {
  return reference::exact_line(parse_scene(
      "kind = \"chain\"\nblocks = 5\nballs = " + ball + "\nwalls = \"both\"\nuntil = 20000",
      "five"));
}

}  // namespace

TEST_CASE("a thousand round trips between walls: exact counts and nothing left behind", "[exam]") {
  const reference::ExactLine line = reference::exact_line(
      parse_scene("kind = \"chain\"\nblocks = 5\nballs = [\"magic:1\", \"magic:2\", \"magic:3\", "
                  "\"magic:4\"]\nwalls = \"both\"\nuntil = 20000",
                  "cradle"));
  REQUIRE_FALSE(reference::why_no_cradle(line).has_value());
  const reference::CradleEnd end = reference::run_cradle(line, 1000000);
  CHECK(end.round_trips == 1000);
  CHECK(end.transfers == 8000);
  CHECK(end.contacts == 1000 * (2 * (2 + 4 + 6 + 8) + 2));
  CHECK(end.mover == 0);
  CHECK(end.direction == 1);
}

TEST_CASE("exact events in the field of the ratio see the same cradle", "[check]") {
  for (const char* ball : {"\"magic:2\"", "\"magic:3\"", "\"sqrt(5)-2\""}) {
    const reference::ExactLine line = cradle(ball, "walls = \"both\"\nuntil = 120");
    const reference::CradleEnd end = reference::run_cradle(line, 1000000);
    REQUIRE(line.one_field);
    LineMotion<FieldNumber> motion(line.together());
    while (motion.next() && !(*line.until < *motion.next())) motion.step();
    CHECK(end.round_trips == 10);
    CHECK(cln::cl_I(static_cast<long>(motion.events())) == end.contacts);
    CHECK(motion.ties().simultaneous == 0);
    CHECK(motion.line().velocities == std::vector<FieldNumber>{FieldNumber(1), 0, 0, 0, 0});
  }
}

TEST_CASE("every magic ball carries a cradle through a thousand round trips", "[exam]") {
  for (const int k : {1, 2, 3, 4, 5, 10, 100}) {
    const reference::ExactLine line = five("\"magic:" + std::to_string(k) + "\"");
    const reference::CradleEnd end = reference::run_cradle(line, 100000000);
    INFO(k);
    CHECK(end.round_trips == 1000);
    CHECK(end.transfers == 8000);
    CHECK(end.contacts == 1000 * (2 * 4 * 2 * k + 2));
    CHECK(end.mover == 0);
  }
}

TEST_CASE("a thousand round trips event by event: exact counts, no residual, nothing spurious",
          "[check]") {
  for (const auto& [ball, k] : {std::pair("\"magic:1\"", 1), {"\"sqrt(5)-2\"", 2}}) {
    const reference::ExactLine line = five(ball);
    LineMotion<FieldNumber> motion(line.together());
    while (motion.next() && !(*line.until < *motion.next())) motion.step();
    INFO(ball);
    CHECK(motion.events() == 1000 * (2 * 4 * 2 * k + 2));
    CHECK(motion.ties().simultaneous == 0);
    CHECK(motion.line().velocities ==
          std::vector<FieldNumber>{FieldNumber(1), 0, 0, 0, 0, 0, 0, 0, 0});
  }
}

TEST_CASE("plain doubles lose the cradle, and know it", "[exam]") {
  const auto moving = [](const LineMotion<double>& motion) {
    int bodies = 0;
    for (std::size_t i = 0; i < motion.bodies(); ++i)
      bodies += motion.body(i).velocity == 0.0 ? 0 : 1;
    return bodies;
  };
  for (const auto& [ball, k] : {std::pair("\"magic:2\"", 2), {"\"magic:3\"", 3}}) {
    LineMotion<double> motion(reference::rounded(five(ball)));
    while (motion.next() && *motion.next() <= 20000) motion.step();
    INFO(ball);
    CHECK(moving(motion) > 1);  // residual velocities, which are 0 in truth
    CHECK(motion.ties().near > 0);
    CHECK(motion.ties().first_near <= 2 * k);  // already after the first transfer
  }
  LineMotion<double> equal(reference::rounded(five("\"magic:1\"")));
  while (equal.next() && *equal.next() <= 20000) equal.step();
  CHECK(moving(equal) == 1);  // equal masses are the easy case: nothing is rounded
  CHECK(equal.ties().near == 0);
}

TEST_CASE("what is no cradle is told why", "[exam]") {
  CHECK(reference::why_no_cradle(cradle("0.1", "")) == "a ball has no magic ratio");
  CHECK(reference::why_no_cradle(cradle("\"magic:2\"", "restitution = 0.5")) ==
        "contacts are not elastic");
  CHECK(reference::why_no_cradle(cradle("\"magic:2\"", "gap = 0.6")) ==
        "a block reaches the next ball before the ball behind it is at rest");
  CHECK_FALSE(reference::why_no_cradle(cradle("\"magic:2\"", "gap = 0.62")).has_value());
}

TEST_CASE("the room that a ball needs is what its next block moves before the last contact",
          "[check]") {
  for (const int k : {2, 3, 4, 9}) {
    const std::string ball = "\"magic:" + std::to_string(k) + "\"";
    const reference::ExactLine trio = reference::exact_line(parse_scene("alpha = " + ball, "trio"));
    const double room =
        reference::TrioEnd(trio, cln::cl_I(2 * k)).contact(2 * k - 1).position - 1.0;
    const auto why = [&](double gap) {
      return reference::why_no_cradle(cradle(ball, "gap = " + std::to_string(gap)));
    };
    CHECK(why(room - 1e-5).has_value());
    CHECK_FALSE(why(room + 1e-5).has_value());
  }
}
