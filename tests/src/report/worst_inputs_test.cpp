// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/worst_inputs.hpp"

#include <cmath>
#include <sstream>

#include <catch2/catch.hpp>

#include "report/pinned_inputs.hpp"
#include "report/quantities.hpp"

using namespace magicmass;
using namespace magicmass::report;

TEST_CASE("what is written is read back, sorted", "[exam]") {
  const std::vector<WorstInput> some{
      {"naive", "double", "velocities", "b", "ulp", {1e-300, 5, 0.9}, 1e15},
      {"naive", "double", "velocities", "a", "ulp", {0.1, 7}, HUGE_VAL},
  };
  std::ostringstream written;
  write_worst_inputs(written, some);
  std::istringstream file(written.str());
  const auto read = read_worst_inputs(file);
  REQUIRE(read.size() == 2);
  CHECK(read[0].member == "a");
  CHECK(std::isinf(read[0].error));
  CHECK(read[1].input.alpha == 1e-300);
  CHECK(read[1].input.index == 5);
  CHECK(read[1].input.e == 0.9);
  CHECK(read[1].error == 1e15);
}

TEST_CASE("a file that is something else is refused with the line", "[exam]") {
  const auto refused = [](const std::string& text, const std::string& says) {
    std::istringstream file(text);
    CHECK_THROWS_WITH(read_worst_inputs(file), Catch::Contains(says));
  };
  const std::string header = "quantity,contestant,precision,member,figure,alpha,index,e,error\n";
  refused("", "begin with");
  refused("alpha,n\n", "begin with");
  refused(header + "velocities,naive\n", "velocities,naive");
  refused(header + "velocities,naive,double,a,ulp,zero,1,1,2\n", "zero");
  refused(header + "velocities,naive,double,a,ulp,1p-3,1x,1,2\n", "1x");
}

TEST_CASE("the worse of what was known and what was found is kept", "[exam]") {
  ErrorRow row;
  row.contestant = "naive";
  row.precision = "double";
  row.quantity = "angle";
  row.member = "psi";
  row.max_ulp = 3;
  row.worst = {0.25, 0};
  const auto found = merged({}, {row});
  REQUIRE(found.size() == 1);  // no envelope and no eps: nothing was wrong by these
  CHECK(found[0].input.alpha == 0.25);
  row.max_ulp = 2;
  row.worst = {0.5, 0};
  CHECK(merged(found, {row})[0].input.alpha == 0.25);
  row.max_ulp = 4;
  CHECK(merged(found, {row})[0].input.alpha == 0.5);
  CHECK(worst_inputs_family("angle", found).inputs.size() == 1);
  row.worst = {5e-324, 0};
  row.max_ulp = HUGE_VAL;
  CHECK(merged(found, {row}).size() == 2);  // hides nothing
  CHECK(worst_inputs_family("ratios", found).inputs.empty());
}

TEST_CASE("the pinned inputs are no worse than when they were found", "[exam]") {
  for (const Quantity& quantity : quantities()) {
    if (!quantity.is_known) continue;
    INFO(quantity.name);
    Oracle oracle;
    const std::size_t replayed = testing::replay_pinned(quantity.name, oracle);
    // exact counts have no worst input
    CHECK((replayed > 0) == (quantity.name != "counts"));
  }
}

TEST_CASE("pin the worst inputs", "[.pin]") {
  for (const Quantity& quantity : quantities()) {
    Oracle oracle;
    if (quantity.is_known) testing::pin_worst(quantity.name, oracle, 2000);
  }
}
