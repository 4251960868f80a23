// SPDX-License-Identifier: GPL-2.0-or-later
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "derivation/derivation.hpp"
#include "proof/text.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;

namespace {

std::set<std::string> ancestors(const derivation::Derivation& all, const std::string& id) {
  std::set<std::string> found;
  const auto visit = [&](const auto& self, const std::string& name) -> void {
    if (!found.insert(name).second) return;
    for (const std::string& premise : all.at(name).step().premises) self(self, premise);
  };
  visit(visit, id);
  return found;
}

}  // namespace

TEST_CASE("the straight line gives the same times and distances by another way", "[exam][shared]") {
  const derivation::Derivation& all = whole_derivation();
  REQUIRE_FALSE(all.refused);
  for (const char* name : {"t_of_P", "t_of_Q", "s_of_P", "s_of_Q"}) {
    const std::string line = std::string("unfolding.") + name,
                      direct = std::string("times.") + name;
    INFO(line);
    CHECK(proof::to_text(all.at(line).statement()) == proof::to_text(all.at(direct).statement()));
    const std::set<std::string> by_line = ancestors(all, line),
                                by_recurrence = ancestors(all, direct);
    for (const char* recurrence : {"times.t_next", "times.s_next", "times.P"}) {
      CHECK_FALSE(by_line.contains(recurrence));
      CHECK(by_recurrence.contains(recurrence));
    }
    CHECK(by_line.contains("unfolding.line"));
  }
}
