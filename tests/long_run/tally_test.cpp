// SPDX-License-Identifier: GPL-2.0-or-later
#include "long_run/tally.hpp"

#include <cmath>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

#include "long_run/plan.hpp"

using namespace magicmass::long_run;

TEST_CASE("one result that differs is counted and makes a run fail", "[exam]") {
  const double nan = std::nan("");
  CHECK(differences<double>({{1.0, 1.0}, {nan, nan}}) == 0);
  CHECK(differences<double>({{1.0, std::nextafter(1.0, 2.0)}, {nan, 0.0}, {0.5, 0.5}}) == 2);
  for (std::int64_t Tally::*member : {&Tally::misrounded_single, &Tally::misrounded_batch,
                                      &Tally::wrong_counts, &Tally::oracle_wrong}) {
    Tally all, wrong;
    CHECK(all.is_clean());
    wrong.*member = 1;
    all += wrong;
    CHECK_FALSE(all.is_clean());
  }
}

TEST_CASE("no chunk has the inputs of another, and together they are as many as asked for",
          "[check]") {
  Plan plan;
  plan.inputs = plan.everyday = 2 * chunk_size + 10;
  for (const Row& row : rows(plan)) {
    // few numbers, or the same thresholds over again
    if (row.family == "alpha = 1" || row.family == "closest thresholds") continue;
    std::set<std::pair<double, std::int64_t>> seen;
    std::size_t drawn = 0;
    for (std::int64_t number = 0; number < 4; ++number) {
      for (const auto& input : chunk(row, number)) {
        seen.emplace(input.alpha, input.index);
        ++drawn;
      }
    }
    INFO(row.quantity << ", " << row.family);
    CHECK(drawn == static_cast<std::size_t>(plan.inputs));
    // small k come again and again
    CHECK(seen.size() > drawn / 2);
  }
}
