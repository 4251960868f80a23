// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes from text to what they come to.
#include <algorithm>
#include <random>

#include "catch.hpp"
#include "magicmass/numbers/errors.hpp"
#include "runs.hpp"

using namespace magicmass::scenes;

namespace {

/// A chain of fractions: where only_halves, with many ties.
std::string random_chain(std::uint64_t seed, bool only_halves) {
  std::mt19937_64 random(seed);
  const std::uint64_t below = only_halves ? 2 : 89;
  const std::size_t bodies = 2 + random() % 4;
  std::string masses, velocities, positions;
  std::uint64_t place = 0;
  const auto fraction = [&](std::int64_t above) {
    return '"' + std::to_string(above) + "/" + std::to_string(below) + "\",";
  };
  for (std::size_t i = 0; i < bodies; ++i) {
    place += random() % (3 * below);
    masses += fraction(static_cast<std::int64_t>(1 + random() % (2 * below)));
    positions += fraction(static_cast<std::int64_t>(place));
    velocities += fraction(static_cast<std::int64_t>(random() % (4 * below)) -
                           static_cast<std::int64_t>(2 * below));
  }
  const std::string wall = random() % 2 == 0 ? "left_wall = -1\n" : "";
  const std::string restitution = random() % 3 == 0 ? "restitution = 0.9\n" : "";
  return "kind = 'chain'\nmasses = [" + masses + "]\npositions = [" + positions +
         "]\nvelocities = [" + velocities + "]\n" + wall + restitution + "max_events = 12\n";
}

/// Four bodies a length apart, the first of which moves.
std::string four_equal(const std::string& e) {
  return "kind = 'chain'\nmasses = [1, 1, 1, 1]\npositions = [0, 1, 2, 3]\n"
         "velocities = [1, 0, 0, 0]\nrestitution = '" +
         e + "'\n";
}

}  // namespace

TEST_CASE("doubles and exact numbers have the same collisions", "[check]") {
  int in_doubles = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    INFO(seed);
    const std::string text = random_chain(seed, seed % 4 == 0);
    const auto off = result_of(text).errors.value_or(magicmass::simulator::Errors<double>());
    const Numbers most{0, off.time, off.position, off.velocity, off.velocity};
    std::vector<Row> rows = rows_of(scene_of(text));
    std::vector<Row> expected = rows_of(scene_of(text, true));
    REQUIRE(rows.size() == expected.size());
    const auto by_gap = [](const Row& x, const Row& y) { return x.gap < y.gap; };
    std::stable_sort(rows.begin(), rows.end(), by_gap);  // what is far apart may be told in any
    std::stable_sort(expected.begin(), expected.end(), by_gap);  // order, if it is at once
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Numbers got = numbers(rows[i]), exact = numbers(expected[i]);
      for (std::size_t k = 0; k < got.size(); ++k)
        CHECK_THAT(got[k], WithinAbs(exact[k], most[k] + 2e-16 * std::abs(exact[k])));
    }
    in_doubles += !rows.empty() && std::holds_alternative<double>(rows[0].time) ? 1 : 0;
  }
  CHECK((in_doubles > 250 && in_doubles < 450));
}

TEST_CASE("rounding at the start hides no collision", "[exam]") {
  const std::string chain = "kind = 'chain'\nmasses = [1, 1]\npositions = [0, 1]\nvelocities = ";
  const Result late = result_of(chain + "['1/3', 0.3333333333333333]");
  CHECK(late.plan.is_exact);
  CHECK(late.events == 1);
  CHECK(result_of(chain + "[0.3333333333333333, '1/3']").events == 0);
  CHECK_FALSE(result_of(chain + "[0.25, 0.25]").plan.is_exact);
  CHECK_FALSE(result_of(chain + "['magic:3', 0]").is_undecided);
  CHECK_FALSE(result_of("kind = 'chain'\nmasses = [1, 2, 3, 4]\nV = 'magic:3'\nmax_events = 3")
                  .is_undecided);
}

TEST_CASE("a number just between two doubles is one of them", "[exam]") {
  // (1 + alpha)/2, and with equal masses (1 - e)/2 and (1 + e)/2, have 54 bits.
  for (const char* text :
       {"alpha = 0.12\nmax_events = 2", "alpha = 0.00012", "alpha = 1\nrestitution = 0.07"})
    CHECK(rows_of(scene_of(text)).size() > 1);
}

TEST_CASE("where a run stops it says so", "[exam]") {
  CHECK(result_of("alpha = 0.12\nmax_events = 6").status == Status::complete);
  const Result early = result_of("alpha = 0.12\nuntil = 1");
  CHECK((early.events == 3 && early.status == Status::limited));
  CHECK_FALSE(early.is_undecided);
  const Result at_until = result_of("alpha = '1/3'\nuntil = '2/3'");
  CHECK((at_until.events == 2 && at_until.plan.is_exact));
  CHECK(result_of("alpha = '1/3'\nuntil = '1999999999/3000000000'").events == 1);
}

TEST_CASE("a collision at the time `until` belongs to the run, by theorem too", "[exam]") {
  const auto counts = [](const std::string& scene, const std::string& until) {
    const Result result = result_of("kind = 'chain'\n" + scene + "until = " + until);
    CHECK(result.plan.model == "transfers");
    CHECK_FALSE(result.is_undecided);
    return result.events;
  };
  const std::string one_wall =
      "blocks = 5\nballs = ['magic:1', 'magic:2', 'magic:2', 'magic:1']\n"
      "V = '1/3'\ngap = 4\nwalls = 'left'\n";
  CHECK(counts(one_wall, "60") == 12);
  CHECK(counts(one_wall, "'59999999999999999999/1000000000000000000'") == 11);
  // The first collision of a trio, its middle one, and the wall.
  const std::string walls = "blocks = 2\nballs = 'magic:3'\nwalls = 'both'\n";
  for (const auto& [time, events] :
       {std::pair{1, 1}, {2, 4}, {3, 7}, {4, 10}, {5, 13}, {7, 14}, {9, 15}}) {
    const std::string before = "'" + std::to_string(time) + "-1/10^30'";
    CHECK(counts(walls, std::to_string(time)) == events);
    CHECK(counts(walls, before) == events - 1);
  }
}

TEST_CASE("what cools below doubles is limited, not complete", "[exam]") {
  const Result cold = result_of(four_equal("7/100"));
  CHECK(cold.status == Status::limited);
  CHECK_THAT(cold.plan.reason, ContainsSubstring("exact numbers become too long"));
  for (const Number& v : cold.terminal) CHECK(double_of(v));
}

TEST_CASE("exact numbers that grow too long are no answer", "[exam]") {
  const std::string text = four_equal(std::string(1000, '1') + "/1" + std::string(1002, '0'));
  CHECK_THROWS_WITH(
      result_of(text, true),
      ContainsSubstring("exact numbers become too long; possible with --max-events 19"));
  CHECK(result_of(text + "max_events = 3", true).events == 3);
}

TEST_CASE("what a body at the other end receives", "[exam]") {
  const std::string text = "alpha = 0.12\npositions = [0, 1, 1]\nvelocities = ";
  const Result mirrored = result_of(text + "[0, 0, -1]");
  CHECK(number(mirrored.transmitted) == number(result_of("alpha = 0.12").transmitted));
  CHECK_THAT(number(mirrored.transmitted), WithinAbs(0.9913169341460811, 1e-15));
  CHECK(scene_of(text + "[0, 0, -1]").receiver() == std::size_t(0));
  for (const char* other : {"[1, 0, -1]", "[0, 1, 0]", "[0, 0, 0]"})
    CHECK_FALSE(scene_of(text + other).receiver());
}

TEST_CASE("what doubles do not hold is no number", "[exam]") {
  const auto energy = [](const std::string& V) {
    return double_of(result_of("kind = 'chain'\nmasses = [1, 1, 2]\nvelocities = [0.5, 0, " + V +
                               "]\npositions = [0, 1, 2]")
                         .energy);
  };
  CHECK(energy("1e100") == 1e200);
  CHECK_FALSE(energy("1e200"));
  for (const char* V : {"1e200", "1e-200"}) {
    const Result result = result_of("alpha = 0.12\nV = " + std::string(V));
    CHECK_FALSE(double_of(result.energy));
    CHECK(number(result.transmitted) > 0.99);
  }
  CHECK_FALSE(double_of(result_of("alpha = '2^10000'").terminal[1]));
  CHECK_THROWS_WITH(result_of("kind = 'chain'\nmasses = [1, 1e-9, 1]\nvelocities = [1e308, 0, 0]\n"
                              "positions = [0, 1, 2]\nleft_wall = 0"),
                    ContainsSubstring("the velocities after collision 1 do not fit a double"));
}

TEST_CASE("a scene with a few wrong bytes is a scene or is refused", "[check]") {
  const std::string good =
      "kind = 'chain' # a comment\nmasses = [2, '1/3', 0x3, \"sqrt(5)-2\"]\npositions = [0, '1/2',"
      " 1.25, 'sqrt(5)']\nvelocities = [1, 0, '-1/4', 0]\nright_wall = 4\nrestitution = 1\n"
      "outputs = ['counts', 'events']\nuntil = 3\nmax_events = 5\n";
  std::mt19937_64 random(9);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = good;
    for (std::uint64_t n = 1 + random() % 3; n > 0; --n)
      text[random() % text.size()] =
          random() % 2 == 0 ? good[random() % good.size()] : static_cast<char>(random() % 256);
    try {
      result_of(text);
    } catch (const magicmass::InvalidInput& error) {
      ++refused;
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
      CHECK_THAT(error.what(), ContainsSubstring("; allowed: "));
    } catch (const magicmass::Undecided&) {
    }
  }
  CHECK((refused > 1000 && refused < 3000));
}
