// SPDX-License-Identifier: GPL-2.0-or-later
// What both tiers say of the last collision, on every family of hard inputs, against the oracle.
#include "magicmass/terminal.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include <catch2/catch.hpp>

#include "magicmass/accurate.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/scenes/mass_ratio.hpp"
#include "report/family.hpp"
#include "tiers/exact_terminal.hpp"

using namespace magicmass;
using report::ExactValue;

namespace {

using Pairs = std::initializer_list<std::pair<double, const ExactValue*>>;

bool is_nearest(Pairs members) {
  return std::all_of(members.begin(), members.end(), [](const auto& member) {
    return member.first == member.second->nearest_double;
  });
}
bool is_within_4_envelopes(Pairs members) {
  return std::all_of(members.begin(), members.end(), [](const auto& member) {
    return report::deviation(member.first, *member.second).over_envelope <= 4.0 &&
           (member.second->high != 0 || member.first == 0.0);
  });
}

template <class Judge>
bool holds(const Terminal& got, const testing::ExactTerminal& exact, const Judge& judge) {
  return got.counts == exact.counts && judge({{got.a_t, &exact.a_t},
                                              {got.b_t, &exact.b_t},
                                              {got.c_t, &exact.c_t},
                                              {got.rho, &exact.rho}});
}

}  // namespace

TEST_CASE(
    "terminal values: nearest in tier accurate, within 4 envelopes in tier fast, counts exact",
    "[check]") {
  report::Oracle oracle;
  for (const report::Family& family : report::families("angle", 16))
    for (const report::Input& input : family.inputs) {
      INFO(family.name << ": alpha = " << to_text(MassRatio(input.alpha)));
      const auto exact = testing::exact_terminal(oracle, input.alpha);
      const auto accurate = accurate::terminal(input.alpha);
      const auto fast = fast::terminal(input.alpha);
      REQUIRE((accurate.has_value() == exact.has_value() && fast.has_value() == exact.has_value()));
      if (!exact) continue;
      REQUIRE(holds(*accurate, *exact, is_nearest));
      REQUIRE(holds(*fast, *exact, is_within_4_envelopes));
    }
}

TEST_CASE("a terminal value that is off, or a count, would be seen", "[exam]") {
  report::Oracle oracle;
  const auto exact = testing::exact_terminal(oracle, 0.02).value();
  Terminal got = accurate::terminal(0.02).value();
  CHECK(holds(got, exact, is_nearest));
  got.rho = std::nextafter(got.rho, 0.0);
  CHECK_FALSE(holds(got, exact, is_nearest));
  CHECK(holds(got, exact, is_within_4_envelopes));
  got.rho *= 1 - 0x1p-46;
  CHECK_FALSE(holds(got, exact, is_within_4_envelopes));
  got = accurate::terminal(0.02).value();
  ++got.counts.N_B;
  CHECK_FALSE(holds(got, exact, is_nearest));
}
