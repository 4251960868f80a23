// SPDX-License-Identifier: GPL-2.0-or-later
// The data of the figures: what each one is to show holds for its numbers.
#include "answers/figures.hpp"

#include <cmath>
#include <map>

#include "answers/motion.hpp"
#include "catch.hpp"

using namespace answers;

namespace {

const Figure& named(const std::string& name) {
  for (const Figure& figure : figures())
    if (figure.name == name) return figure;
  throw std::out_of_range(name);
}

double number(const Row& row, std::size_t column) { return std::stod(row.at(column).text); }

/// Of two neighbours, the least.
double least_distance(const Row& row, std::size_t first) {
  double least = INFINITY;
  for (std::size_t i = first; i + 1 < row.size(); ++i)
    least = std::min(least, std::abs(number(row, i) - number(row, i + 1)));
  return least;
}

}  // namespace

TEST_CASE("Less is transmitted where more energy is lost, nothing shown where it never ends") {
  int of_collapses = 0, of_ones = 0;
  for (const Row& row : named("transmission").data().rows) {
    const double alpha = number(row, 0);
    of_ones += number(row, 1) == 1 ? 1 : 0;
    for (std::size_t column = 2; column < row.size(); ++column) {
      const Trio trio = Trio::equal_blocks(value_of(alpha), cln::cl_RA(11 - int(column)) / 10);
      const bool is_collapse = !trio.count().has_value();
      REQUIRE(row[column].text.empty() == is_collapse);
      if (is_collapse)
        ++of_collapses;
      else
        REQUIRE(number(row, column) < number(row, column - 1));
    }
  }
  CHECK(of_collapses > 0);
  CHECK(of_ones == 10);  // alpha_1 to alpha_10
}

TEST_CASE("Velocities keep the energy; the block turns before the wall and leaves as fast") {
  for (const Row& row : named("velocities").data().rows) {
    const double a = number(row, 1), b = number(row, 2), ball = number(row, 4);
    CHECK_THAT(a * a + b * b + ball * ball / 1000, WithinAbs(1, 1e-14));
  }
  const Table way = named("way").data();
  double last = 0, nearest = 0;
  for (const Row& row : way.rows) {
    nearest = std::max(nearest, number(row, 1));
    CHECK(number(row, 1) <= number(row, 2));
    if (number(row, 0) <= 1) CHECK(number(row, 1) >= last);
    last = number(row, 1);
  }
  CHECK(nearest < 1);
  const auto speed = [&](std::size_t i) {
    return (number(way.rows[i + 1], 1) - number(way.rows[i], 1)) /
           (number(way.rows[i + 1], 0) - number(way.rows[i], 0));
  };
  CHECK_THAT(speed(way.rows.size() - 2), WithinAbs(-1, 0.03));
}

TEST_CASE("Two bodies meet at each collision of the trajectories; B takes all in panel a") {
  const Table table = named("trajectories").data();
  std::map<std::string, int> collisions;
  Row last;
  for (const Row& row : table.rows) {
    const bool is_inside = number(row, 1) > -1 && number(row, 1) < 5;
    if (is_inside) CHECK_THAT(least_distance(row, 2), WithinAbs(0, 1e-14));
    if (is_inside) ++collisions[row[0].text];
    if (row[0].text == "a") last = row;
  }
  CHECK(collisions == std::map<std::string, int>{{"a", 6}, {"b", 6}, {"c", 7}});
  CHECK_THAT(number(last, 4), WithinAbs(5, 1e-13));
}

TEST_CASE("V_n keeps its length; a whole turn ends where it began") {
  const Table table = named("sphere").data();
  for (const Row& row : table.rows)
    CHECK_THAT(std::hypot(number(row, 2), number(row, 3), number(row, 4)), WithinAbs(1, 1e-14));
  CHECK_THAT(number(table.rows.back(), 2), WithinAbs(1, 1e-14));
  CHECK(table.rows[5][3].text == "1");
}

TEST_CASE("The collisions lie on a straight line through the unfolded wedge") {
  const Table table = named("wedge").data();
  REQUIRE(table.rows.size() == 6);
  const auto height = [](const Row& row) { return number(row, 2) * std::sin(number(row, 3)); };
  for (const Row& row : table.rows)
    CHECK_THAT(height(row), WithinAbs(height(table.rows[0]), 1e-14));
  CHECK(std::abs(number(table.rows[1], 2) - number(table.rows[0], 2)) > 0.1);
}

TEST_CASE("The cradle: there and back, then A_1 leaves as it came") {
  const Table table = named("cradle").data();
  REQUIRE(table.rows.size() == 43);  // 2 (1 + ... + 4) 2 collisions, the wall, start and end
  for (std::size_t i = 1; i + 1 < table.rows.size(); ++i)
    if (i != 21) CHECK_THAT(least_distance(table.rows[i], 1), WithinAbs(0, 1e-13));
  CHECK_THAT(number(table.rows.back(), 1), WithinAbs(-3, 1e-13));
}
