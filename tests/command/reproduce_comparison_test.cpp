// SPDX-License-Identifier: GPL-2.0-or-later
// Verdicts on numbers beside the paper's, and pages that show them: spoilt numbers are found out.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "command/reproduce/comparison.hpp"
#include "command/reproduce/pages.hpp"

using namespace magicmass::command;

namespace {

std::string verdict_on(const std::string& paper, const std::string& ours) {
  return verdict({"table:akbk", "alpha_2", paper, ours, ""});
}

}  // namespace

TEST_CASE("a verdict goes by the digits printed", "[exam]") {
  CHECK(verdict_on("0.236068", "0.2360679774997897") == "agrees");
  CHECK(verdict_on("0.029927", "0.029927830949727403") == "agrees, cut off");
  CHECK(verdict_on("0.236068", "0.2360691") == "differs");
  CHECK(verdict_on("0.236068", "-0.2360679774997897") == "differs");
  CHECK(verdict_on("0.84", "0.8400") == "agrees");
  CHECK(verdict_on("0.84", "1.0360") == "differs");
  CHECK(verdict_on("0.84", "nan") == "differs");
  CHECK(verdict_on("0.84", "") == "differs");
  CHECK(verdict_on("0.84", "0.84x") == "differs");
  CHECK(verdict_on("", "0.84") == "not in the paper");
}

TEST_CASE("whole numbers agree only as they are", "[exam]") {
  CHECK(verdict_on("3", "3") == "agrees");
  CHECK(verdict_on("1", "1.000000000000") == "agrees");
  CHECK(verdict_on("0", "-0.000") == "agrees");
  CHECK(verdict_on("3", "4") == "differs");
  CHECK(verdict_on("0", "1e-17") == "differs");
  CHECK(verdict_on("1", "1.000000000001") == "differs");
}

TEST_CASE("expressions agree when a proof says so", "[exam]") {
  Comparison row{"exact:bk", "beta_1", "sqrt(2)-1", "sqrt(2) - 1", "", true};
  CHECK(verdict(row) == "agrees");
  row.is_equal = false;
  CHECK(verdict(row) == "differs");
}

TEST_CASE("a difference without a reason is counted and said on every page", "[exam]") {
  const Comparison good{"table:akbk", "alpha_2", "0.236068", "0.2360679774997897", ""};
  const Comparison known{"fig:inelastic", "shift <of> beta_1", "0.43", "0.4739",
                         "it was rounded & so"};
  const Comparison spoilt{"table:akbk", "alpha_3", "0.109916", "0.1199", ""};
  const Tally sum = tally({{"One", "Words.", {good, known}}, {"Two", "", {spoilt, good}}});
  CHECK((sum.agree == 2 && sum.explained == 1 && sum.unexplained == 1 && sum.not_printed == 0));
  const std::vector<ComparisonSection> sections = {{"One", "Words.", {good, known, spoilt}}};
  const std::string html = reproduction_html(sections, {{"counts", "Title", "A \"text\""}});
  CHECK(html.find("<strong>differs</strong>: not explained: one of the two is wrong") !=
        std::string::npos);
  CHECK(html.find("shift &lt;of&gt; beta_1") != std::string::npos);
  CHECK(html.find("it was rounded &amp; so") != std::string::npos);
  CHECK(html.find("alt=\"A &quot;text&quot;\"") != std::string::npos);
}
