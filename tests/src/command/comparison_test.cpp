// SPDX-License-Identifier: GPL-2.0-or-later
// The paper's numbers beside ours: what is spoiled is named.
#include "command/comparison.hpp"

#include "catch.hpp"
#include "host/embedded.hpp"
#include "refusal.hpp"

using command::Comparison;
using command::comparisons;

namespace {

const std::string header = "label,number,printed,question,column,reason\n";

Comparison one(const std::string& row) { return comparisons(header + row + "\n").at(0); }

/// The paper's numbers with a text in place of another.
std::vector<Comparison> with(const std::string& text, const std::string& other) {
  std::string all = host::embedded("paper_numbers.csv");
  all.replace(all.find(text), text.size(), other);
  return comparisons(all);
}

/// The numbers that are not fine, with what is said.
std::vector<std::string> wrong(const std::vector<Comparison>& all) {
  std::vector<std::string> names;
  for (const Comparison& each : all)
    if (!each.is_fine) names.push_back(each.number + ": " + each.reason);
  return names;
}

}  // namespace

TEST_CASE("Every number of the paper agrees or differs for a reason that holds") {
  const std::vector<Comparison> all = comparisons(host::embedded("paper_numbers.csv"));
  REQUIRE(all.size() == 94);
  REQUIRE(wrong(all).empty());
}

TEST_CASE("A spoiled number or reason is named, and nothing else", "[check]") {
  using Names = std::vector<std::string>;
  const std::string nobody = ": Nobody knows why: one of the two is wrong.";
  CHECK(wrong(with("0.109916", "0.109917")) == Names{"alpha_3" + nobody});
  CHECK(wrong(with("sqrt(5)-2", "sqrt(5)-1")) == Names{"alpha_2 in square roots" + nobody});
  CHECK(wrong(with("2/3", "1/3")) == Names{"psi/pi at alpha = 1" + nobody});
  CHECK(wrong(with("c_t,terminal", "a_t,terminal")) == Names{"b_t at beta_1" + nobody});
  CHECK(wrong(with("cut off\n", "\n")) == Names{"alpha_6" + nobody});
  const std::string fails = ": The reason given does not hold: ";
  const std::string beta_1 = "shift of beta_1 in %" + fails;
  CHECK(wrong(with("0.029927", "0.029926")) == Names{"alpha_6" + fails + "cut off."});
  CHECK(wrong(with("cut off\n", "full moon\n")) == Names{"alpha_6" + fails + "full moon."});
  CHECK(wrong(with("rounded extremum\n", "cut off\n")) == Names{beta_1 + "cut off."});
  CHECK(wrong(with("0.43,", "0.44,")) == Names{beta_1 + "rounded extremum."});
  CHECK(wrong(with("9/10,shift,\n", "9/10,shift,rounded extremum\n")) ==
        Names{"shift of alpha_1 in %: It agrees: no reason is needed."});
}

TEST_CASE("A page names what is spoiled, and the check has failed", "[check]") {
  const auto page = [](const std::vector<Comparison>& all) { return page_of(all, "text"); };
  CHECK_FALSE(page(comparisons(host::embedded("paper_numbers.csv"))).check_failed);
  const answers::Answer spoiled = page(with("0.064178", "0.064187"));
  CHECK(spoiled.check_failed);
  CHECK_THAT(spoiled.document, ContainsSubstring("89 agree, 4 differ for the reason given, 1"));
  CHECK_THAT(spoiled.document,
             ContainsSubstring("alpha_4   0.064187  0.06417777247591214   differs"));
  CHECK_THAT(spoiled.document, ContainsSubstring("Nobody knows why: one of the two is wrong.\n"));
}

TEST_CASE("A row without a meaning is named", "[check]") {
  const auto refused = [](const std::string& row, const std::string& because) {
    CHECK_THAT(refusal<std::runtime_error>([&] { one(row); }), ContainsSubstring(because));
  };
  refused("x,x,1", "paper_numbers.csv: x,x,1: six fields");
  refused("x,x,1,guess --alpha 1,N_A,", "no numbers answer \"guess --alpha 1\"");
  refused("x,x,1,count --alpha 1,N_C,", "no column N_C");
  refused("x,x,1,count --alhpa 1,N_A,", "count: no option, or no value: --alhpa; allowed: --alpha");
  refused("x,x,1,extremum --near 0.1 --restitution 9/10,alpha,",
          "near: 0.1; allowed: magic:k, deficient:k");
  refused("x,x,1,extremum --near magic:1 --restitution 1,alpha,",
          "restitution: allowed: a fraction below 1");
}
