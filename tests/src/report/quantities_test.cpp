// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/quantities.hpp"

#include <set>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/evaluators.hpp"
#include "report/contestants.hpp"
#include "report/oracle.hpp"

using namespace magicmass;
using namespace magicmass::report;

TEST_CASE("each generated table is of a quantity that is measured, with its inputs and members",
          "[exam]") {
  std::set<std::string> met;
  const auto look = [&]<const auto & table>(const char* name, const char* outputs,
                                            const char* inputs) {
    const Quantity& quantity = quantity_named(name);
    met.insert(name);
    std::string members;
    for (const std::string& member : quantity.members)
      members += (members.empty() ? "" : ",") + member;
    std::string taken;
    for (const std::string& input : quantity.inputs) taken += (taken.empty() ? "" : ",") + input;
    CHECK(members == outputs);
    CHECK(taken == inputs);
    CHECK(generated_contestants(name).size() == 3 * table.size());
  };
  generated::visit_tables<double>(look);
  for (const char* name : {"velocities", "encounters", "angle", "ratios"})
    CHECK(met.contains(name));
}

TEST_CASE("a quantity's inputs tell what it ranges over", "[exam]") {
  CHECK(quantity_named("velocities").index() == "n");
  CHECK(quantity_named("ratios").index() == "k");
  CHECK(quantity_named("counts").index().empty());
  CHECK(has_last_index("encounters"));
  CHECK_FALSE(has_last_index("angle"));
  CHECK_FALSE(takes_alpha("ratios"));
  CHECK_THROWS_AS(quantity_named("speed"), InvalidInput);
}

TEST_CASE("nobody teaches the oracle what it knows by itself", "[exam]") {
  Oracle oracle;
  const auto wrong = [](const Input&) { return std::vector<ExactValue>(1); };
  CHECK_THROWS_AS(oracle.learn("angle", "closed", wrong), std::logic_error);
}
