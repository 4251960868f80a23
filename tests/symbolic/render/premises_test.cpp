// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/premises.hpp"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "render/derivation_pages.hpp"
#include "render/steps.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;
using namespace magicmass::render;

namespace {
proof::Step step(const std::string& id, const std::string& from, const std::string& to,
                 const std::string& verdict, std::vector<std::string> premises = {}) {
  proof::Step result;
  result.id = id;
  result.from = from;
  result.relation = "=";
  result.to = to;
  result.verdict = verdict;
  result.premises = std::move(premises);
  return result;
}
}  // namespace

TEST_CASE("a tree shows each step once, with definitions that are mentioned", "[exam]") {
  const std::vector<proof::Step> all{
      step("x.law", "u", "v", "law"), step("x.h", "h", "2*u", "definition"),
      step("x.one", "h", "2*v", "proved", {"x.law"}),
      step("x.two", "w", "4*v", "proved", {"x.one", "x.law"}), step("x.other", "z", "1", "proved")};
  const auto tree = premise_tree({all[3]}, all);
  CHECK(tree_text(tree, {.unicode = true}) ==
        "x.two\n"
        "│    w = 4v\n"
        "├─ x.law (law)\n"
        "│       u = v\n"
        "└─ x.one\n"
        "   │    h = 2v\n"
        "   ├─ x.law (law), see above\n"
        "   └─ x.h (definition)\n"
        "           h = 2u\n");
  const auto steps = steps_of_tree(tree, all);
  CHECK(steps.size() == 4);
  CHECK(steps.front().id == "x.law");
}

TEST_CASE("whatever a result rests on is in its tree", "[exam][shared]") {
  const auto all = steps_of(whole_derivation());
  const auto root =
      std::find_if(all.begin(), all.end(), [](const auto& each) { return each.id == "power.a"; });
  REQUIRE(root != all.end());
  const auto steps = steps_of_tree(premise_tree({*root}, all), all);
  std::set<std::string> ids;
  for (const proof::Step& each : steps) {
    for (const std::string& premise : each.premises) CHECK(ids.contains(premise));
    ids.insert(each.id);
  }
  for (const char* needed :
       {"contact.momentum", "contact.energy", "power.a_0", "power.V_CM", "rotation.psi"})
    CHECK(ids.contains(needed));
  CHECK_FALSE(ids.contains("times.t_1"));
}
