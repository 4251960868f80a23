// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/due_times.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "random_numbers.hpp"

using namespace magicmass;

namespace {

/// A tournament against looking at every gap, as times come and go.
template <class Scalar>
void check_tournaments() {
  testing::Generator generator(5);
  for (std::size_t gaps = 1; gaps <= 70; ++gaps) {
    INFO(gaps << " gaps");
    std::vector<Scalar> times(gaps);
    DueTimes<Scalar> due(gaps);
    for (std::size_t gap = 0; gap < gaps; ++gap) {
      times[gap] = static_cast<Scalar>(generator() % 20);
      due.set(gap, times[gap]);
    }
    due.replay(0, gaps - 1);
    for (int change = 0; change < 20; ++change) {
      const auto soonest = std::min_element(times.begin(), times.end()) - times.begin();
      REQUIRE(due.first() == static_cast<std::size_t>(soonest));
      const std::size_t changed =
          change % 2 == 0 ? static_cast<std::size_t>(soonest) : generator() % gaps;
      const std::size_t last = std::min(changed + 2, gaps - 1);
      for (std::size_t gap = changed; gap <= last; ++gap) {
        times[gap] = static_cast<Scalar>(generator() % 20);
        due.set(gap, times[gap]);
      }
      due.replay(changed, last);
    }
  }
}

}  // namespace

TEST_CASE("of any number of gaps the first to close is known, the leftmost of equals", "[check]") {
  check_tournaments<double>();
  check_tournaments<std::int64_t>();
}

TEST_CASE("a gap that never closes comes after all others", "[exam]") {
  DueTimes<double> due(9);
  CHECK(is_never<double>(due[8]));
  due.set(8, 3.0);
  due.replay(8, 8);
  CHECK(due.first() == 8);
}

TEST_CASE("what is soon asked for is the first gap of the sixteenth that was played last",
          "[exam]") {
  DueTimes<double> due(
      1000);  // eight times 16 blocks of eight gaps: gaps 448, ..., 511 are a sixteenth
  const auto set = [&due](std::size_t gap, double time) {
    due.set(gap, time);
    due.replay(gap, gap);
  };
  set(460, 2.0);
  CHECK(due.fetch_soon() == 460);
  set(10, 1.0);
  CHECK(due.fetch_soon() == 10);
  set(511, 1.5);
  CHECK(due.first() == 10);
  CHECK(due.fetch_soon() == 511);
  set(511, 3.0);
  CHECK(due.fetch_soon() == 460);
}
