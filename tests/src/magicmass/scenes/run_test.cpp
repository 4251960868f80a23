// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes from text to what they come to.
#include <random>

#include "magicmass/numbers/errors.hpp"
#include "runs.hpp"

using namespace magicmass::scenes;

namespace {

/// A chain of fractions: where only_halves, with many ties.
std::string random_chain(std::uint64_t seed, bool only_halves) {
  std::mt19937_64 random(seed);
  const std::uint64_t below = only_halves ? 2 : 89;
  const std::size_t bodies = 2 + random() % 4;
  std::vector<std::string> masses, velocities, positions;
  std::uint64_t place = 0;
  const auto fraction = [&](std::int64_t above) {
    return "'" + std::to_string(above) + "/" + std::to_string(below) + "'";
  };
  for (std::size_t i = 0; i < bodies; ++i) {
    place += random() % (3 * below);
    masses.push_back(fraction(static_cast<std::int64_t>(1 + random() % (2 * below))));
    positions.push_back(fraction(static_cast<std::int64_t>(place)));
    velocities.push_back(fraction(static_cast<std::int64_t>(random() % (4 * below)) -
                                  static_cast<std::int64_t>(2 * below)));
  }
  return "kind = 'chain'\nmasses = " + list(masses) + "positions = " + list(positions) +
         "velocities = " + list(velocities) + (random() % 2 == 0 ? "left_wall = -1\n" : "") +
         (random() % 3 == 0 ? "restitution = 0.9\n" : "") + "max_events = 12\n";
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
