// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/theorem_index.hpp"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "render/step_names.hpp"
#include "render/steps.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;
using namespace magicmass::render;

namespace {

const TheoremIndex& index() {
  static const TheoremIndex result = theorem_index(steps_of(whole_derivation()));
  return result;
}

bool is_listed(std::string_view label) {
  const auto& all = derivation::paper_equations();
  return std::any_of(all.begin(), all.end(),
                     [&](const auto& equation) { return equation.label == label; });
}

/// Displayed there, or said in one of its sections.
bool is_in_the_paper(const std::string& label) {
  const auto speaks = [&](const auto& listed) {
    return derivation::speaks_of(label, listed.label);
  };
  const auto& equations = derivation::paper_equations();
  const auto& sections = derivation::paper_sections();
  return std::any_of(equations.begin(), equations.end(), speaks) ||
         std::any_of(sections.begin(), sections.end(), speaks);
}

}  // namespace

TEST_CASE("every equation of the paper is proved, or there is a reason why it is not claimed",
          "[exam][shared]") {
  std::set<std::string_view> seen;
  for (const IndexedEquation& indexed : index().equations) {
    const derivation::PaperEquation& equation = indexed.equation;
    INFO(equation.label);
    CHECK(seen.insert(equation.label).second);
    CHECK_FALSE(equation.place.empty());
    if (!equation.not_claimed.empty()) {
      CHECK(indexed.theorems.empty());  // no reason for what is proved
      CHECK(equation.same_as.empty());
    } else {
      CHECK_FALSE(indexed.theorems.empty());
    }
    if (!equation.same_as.empty()) CHECK(is_listed(equation.same_as));
    CHECK(remark(indexed) != "not proved yet");
  }
  // 64 labels in equations, 2 tables, 22 displayed equations without a label, and the axis
  CHECK(seen.size() == 64 + 2 + 22 + 1);
}

TEST_CASE("a label of the paper is carried by what the kernel accepted, and it is in the paper",
          "[exam][shared]") {
  const std::set<std::string> verdicts{"proved", "law", "definition"};
  for (const proof::Step& step : index().steps) {
    INFO(step.id << ": " << step.label);
    for (const std::string& label : labels_of(step)) CHECK(is_in_the_paper(label));
    if (!step.label.empty()) CHECK(verdicts.contains(step.verdict));
  }
}

TEST_CASE("what the paper says in its text is listed by section", "[exam]") {
  proof::Step first, second;
  first.id = "mapping.projection";
  first.label = "sec:comparison, projection";
  second.id = "table.psi";
  second.label = "app:lam-n, range of psi, table:trig, cos psi";
  const TheoremIndex small = theorem_index({second, first});
  REQUIRE(small.in_the_text.size() == 2);
  CHECK(small.in_the_text[0].label == "sec:comparison, projection");
  CHECK(small.in_the_text[1].label == "app:lam-n, range of psi");
  CHECK(small.in_the_text[1].place == "App. C");
  CHECK(small.in_the_text[1].theorems == std::vector<std::string>{"table.psi"});
  CHECK_FALSE(is_in_the_paper("eq:no-such-label"));
}

TEST_CASE("labels with a comma in them are told from several labels", "[exam]") {
  using Labels = std::vector<std::string>;
  CHECK(derivation::split_labels("eq:Lam-G-G, Lam-GAM") == Labels{"eq:Lam-G-G", "Lam-GAM"});
  CHECK(derivation::split_labels("app:Vn, Gamma_A") == Labels{"app:Vn, Gamma_A"});
  CHECK(derivation::split_labels("eq:lambda-n, app:lam-n, Lambda") ==
        Labels{"eq:lambda-n", "app:lam-n, Lambda"});
  CHECK(derivation::split_labels("").empty());
  CHECK(derivation::split_labels("sec:comparison, projection, sec:result") ==
        Labels{"sec:comparison, projection", "sec:result"});
  CHECK(derivation::speaks_of("table:trig, cos psi", "table:trig"));
  CHECK(derivation::speaks_of("sec:nhx, sin 1/2", "sec:nhx, sin"));
  CHECK_FALSE(derivation::speaks_of("eq:V-n-0", "eq:V-n"));
  CHECK_FALSE(derivation::speaks_of("eq:ac", "eq:ac-dc"));
}

TEST_CASE("what goes beyond the paper is there and carries no label of it", "[exam][shared]") {
  for (const IndexedResult& indexed : index().beyond) {
    INFO(indexed.result.name);
    CHECK_FALSE(indexed.theorems.empty());
    for (const proof::Step& step : index().steps)
      if (std::find(indexed.theorems.begin(), indexed.theorems.end(), step.id) !=
          indexed.theorems.end())
        CHECK(step.label.empty());
  }
}

TEST_CASE("the index misses an equation that loses its theorem", "[exam][shared]") {
  std::vector<proof::Step> steps = index().steps;
  std::erase_if(steps, [](const proof::Step& step) { return step.id == "power.a"; });
  const TheoremIndex less = theorem_index(steps);
  const auto lost =
      std::find_if(less.equations.begin(), less.equations.end(),
                   [](const auto& indexed) { return indexed.equation.label == "eq:a-final"; });
  REQUIRE(lost != less.equations.end());
  CHECK(remark(*lost) == "not proved yet");
}
