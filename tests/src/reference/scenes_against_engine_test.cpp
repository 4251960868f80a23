// SPDX-License-Identifier: GPL-2.0-or-later
// 10,000 random scenes at exact rationals: every closed form against the event engine, without any difference.
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include "magicmass/collapse_product.hpp"
#include "magicmass/encounters_exact.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/exact_line.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/trio_end.hpp"
#include "magicmass/simulator/line_motion.hpp"
#include "magicmass/velocities_exact.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using cln::cl_RA;

namespace {

std::string random_text(testing::Generator& generator, std::int64_t most) {
  return std::to_string(testing::whole(generator, 1, most)) + "/" +
         std::to_string(testing::whole(generator, 1, most));
}

Line<cl_RA> rational(const reference::ExactLine& line) {
  return converted<cl_RA>(line.together(),
                          [](const reference::FieldNumber& x) { return x.rational(); });
}

/// All events agree with the powers of the cycle's map: counts, velocities, times and places.
void check_powers(const reference::ExactLine& line) {
  const reference::TrioEnd end(line);
  if (end.collapse()) {
    LineMotion<cl_RA> motion(rational(line));
    for (int i = 0; i < 20; ++i) motion.step();  // there is always a next contact
    REQUIRE(reference::nearest<double>(motion.now()) <= end.collapse()->time);
    return;
  }
  const reference::TrioPowers<cl_RA> powers(rational(line));
  LineMotion<cl_RA> motion(rational(line));
  cln::cl_I j = 0;
  while (motion.next()) {
    const auto approach = powers.approach(j);
    const LineEvent<cl_RA> event = motion.step();
    j = j + 1;
    REQUIRE(event.time == approach.gap / approach.speed);
    const auto state = powers.after(j);
    const bool with_A = cln::oddp(j);
    REQUIRE(event.gap == (with_A ? 1 : 2));
    REQUIRE(event.v_left == (with_A ? state.v.a : state.v.c));
    REQUIRE(event.v_right == (with_A ? state.v.c : state.v.b));
    REQUIRE(event.position == state.x.c + state.v.c * event.time);
  }
  REQUIRE(j == end.contacts());
  REQUIRE(motion.ties().simultaneous == 0);
}

}  // namespace

TEST_CASE("elastic scenes of equal blocks: the generated formulas against the engine", "[check]") {
  testing::Generator generator(81);
  for (int i = 0; i < 4000; ++i) {
    const cl_RA alpha = reference::parse_rational(random_text(generator, 60));
    LineMotion<cl_RA> motion({{1, alpha, 1}, {0, 0, 1}, {1, 0, 0}, std::nullopt, std::nullopt});
    std::int64_t n = 0;
    while (motion.next()) {
      const LineEvent<cl_RA> event = motion.step();
      if (event.gap == 1) ++n;
      const auto v = generated::velocities_exact<cl_RA>(alpha, n);
      REQUIRE(event.v_left == (event.gap == 1 ? v.a : v.c_prime));
      REQUIRE(event.v_right == (event.gap == 1 ? v.c : v.b));
      REQUIRE(event.time == generated::encounters_exact<cl_RA>(alpha, motion.events() - 1).t);
    }
    const reference::LargeCounts counts = reference::count_collisions(alpha);
    REQUIRE(counts.N_A + counts.N_B == motion.events());
  }
}

TEST_CASE("any three masses, elastic or not: the powers against the engine", "[check]") {
  testing::Generator generator(82);
  for (int i = 0; i < 4000; ++i) {
    const bool elastic = i % 2 == 0;
    const std::string e = elastic ? "1" : std::to_string(testing::whole(generator, 1, 20)) + "/20";
    const Scene scene = parse_scene(
        "masses = [\"" + random_text(generator, 20) + "\", \"" + random_text(generator, 20) +
            "\", \"" + random_text(generator, 20) + "\"]\nrestitution = \"" + e + "\"\nV = \"" +
            random_text(generator, 9) + "\"\nL = \"" + random_text(generator, 9) + "\"",
        "random");
    check_powers(reference::exact_line(scene));
  }
}

TEST_CASE("a block, a ball and a wall: the powers against the engine", "[check]") {
  testing::Generator generator(83);
  for (int i = 0; i < 2000; ++i) {
    const std::string e =
        i % 2 == 0 ? "1" : std::to_string(testing::whole(generator, 2, 20)) + "/20";
    const Scene scene =
        parse_scene("kind = \"wall\"\nmasses = [\"" + random_text(generator, 30) + "\", \"" +
                        random_text(generator, 30) + "\"]\nrestitution = \"" + e + "\"",
                    "random");
    check_powers(reference::exact_line(scene));
  }
}

TEST_CASE("a block of 100^k times the ball's mass counts digits of pi", "[exam]") {
  const std::array<long, 13> digits = {
      3,        31,        314,        3141,        31415,        314159,       3141592,
      31415926, 314159265, 3141592653, 31415926535, 314159265358, 3141592653589};
  for (std::size_t k = 0; k < digits.size(); ++k) {
    const Scene scene =
        parse_scene("kind = \"wall\"\nmass_ratio = \"100^" + std::to_string(k) + "\"", "pi");
    const reference::ExactLine line = reference::exact_line(scene);
    CHECK(reference::TrioEnd(line).contacts() == cln::cl_I(digits[k]));
  }
}

TEST_CASE("collapse begins at its thresholds", "[exam]") {
  const auto collapse = [](const std::string& text) {
    const reference::ExactLine line = reference::exact_line(parse_scene(text, "e"));
    return reference::TrioEnd(line).collapse();
  };
  CHECK(collapse("alpha = 1\nrestitution = \"7/100\"").has_value());
  CHECK_FALSE(collapse("alpha = 1\nrestitution = \"72/1000\"").has_value());
  for (int percent = 10; percent < 100; ++percent) {
    const double e = percent / 100.0;
    const double threshold = (1 + e) / (2 * std::sqrt(e)) - 1;
    const std::string rest = "\nrestitution = " + std::to_string(e);
    const auto alpha = [&](double factor) {
      return "alpha = " + std::to_string(threshold * factor * 1e9) + "e-9" + rest;
    };
    CHECK_FALSE(collapse(alpha(1.000001)).has_value());
    const auto below = collapse(alpha(0.999999));
    REQUIRE(below.has_value());
    const double time = generated::collapse_product(threshold * 0.999999, e);
    CHECK(below->time == Approx(time).epsilon(1e-3));  // the root of alpha_c - alpha is steep there
    CHECK(collapse(alpha(0.5))->time ==
          Approx(generated::collapse_product(threshold * 0.5, e)).epsilon(1e-9));
  }
}

TEST_CASE("where infinitely many collisions end, stepping comes as close as it can", "[exam]") {
  for (const char* masses : {"[1, 1, 1]", "[3, 2, 1]", "[1, 0.5, 7]"}) {
    const reference::ExactLine line = reference::exact_line(
        parse_scene(std::string("masses = ") + masses + "\nrestitution = \"1/40\"", "e"));
    const auto collapse = reference::TrioEnd(line).collapse();
    REQUIRE(collapse.has_value());
    LineMotion<cl_RA> motion(rational(line));
    LineEvent<cl_RA> event{};
    for (int i = 0; i < 60; ++i) event = motion.step();
    CHECK(reference::nearest<double>(event.time) == Approx(collapse->time).epsilon(1e-12));
    CHECK(reference::nearest<double>(event.position) == Approx(collapse->position).epsilon(1e-12));
  }
}

TEST_CASE("a scene of 10^500 collisions is answered like any other", "[exam]") {
  const reference::ExactLine line =
      reference::exact_line(parse_scene("kind = \"wall\"\nmass_ratio = \"100^500\"", "pi"));
  const std::string digits = reference::to_text(reference::TrioEnd(line).contacts());
  CHECK(digits.size() == 501);
  CHECK(digits.starts_with("31415926535897932384626433832795028841971693993751058209749445923"));
}

TEST_CASE("a value that no precision decides is not guessed", "[exam]") {
  const auto after_all = [](const std::string& V) {
    const reference::ExactLine line =
        reference::exact_line(parse_scene("alpha = \"magic:1001\"\nV = \"" + V + "\"", "halfway"));
    return reference::TrioEnd(line, cln::cl_I(2002), 1024).velocities(2002);
  };
  const BodyVelocities<double> v = after_all("1");
  CHECK(v == BodyVelocities<double>{0.0, 1.0, 0.0});
  CHECK_FALSE(std::signbit(v.a));
  CHECK_FALSE(std::signbit(v.c));
  // B ends with V, halfway between two doubles.
  CHECK_THROWS_AS(after_all("9007199254740993/9007199254740992"), Undecided);
}
