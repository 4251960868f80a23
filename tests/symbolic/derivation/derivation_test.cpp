// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/derivation.hpp"

#include <algorithm>
#include <set>
#include <type_traits>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "magicmass/errors.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;

TEST_CASE("every step is proved from the laws", "[exam][shared]") {
  INFO((whole_derivation().refused ? whole_derivation().refused->what() : ""));
  REQUIRE_FALSE(whole_derivation().refused);
  const std::set<std::string> verdicts{"proved", "law", "definition", "hypothesis"};
  std::set<std::string> seen;
  for (const proof::Theorem& theorem : whole_derivation().theorems) {
    INFO(theorem.id());
    CHECK(verdicts.contains(theorem.step().verdict));
    for (const std::string& premise : theorem.step().premises) CHECK(seen.contains(premise));
    CHECK(seen.insert(theorem.id()).second);
  }
}

TEST_CASE("what is not there is refused by its name, as bad input is everywhere",
          "[exam][shared]") {
  CHECK(whole_derivation().at("power.b").id() == "power.b");
  CHECK_THROWS_AS(whole_derivation().at("power.z"), InvalidInput);
  CHECK_THROWS_WITH(whole_derivation().at("power.z"), "no theorem is called power.z");
  const derivation::Paper paper = derivation::paper();
  CHECK_THROWS_AS(paper.at("eq:none"), InvalidInput);
  CHECK_THROWS_AS(derivation::Beginning("none", derivation::conservation_laws(), paper),
                  InvalidInput);
  CHECK_THROWS_WITH(derivation::derive_up_to("powers"), "no chapter is called powers");
  CHECK_THROWS_AS(proof::symbol("2x"), InvalidInput);
  STATIC_REQUIRE(std::is_base_of_v<Error, proof::NotProved>);
}

TEST_CASE("the laws are the two conservation laws, the contact, the start and uniform motion",
          "[exam][shared]") {
  std::set<std::string> laws;
  for (const proof::Theorem& theorem : whole_derivation().theorems)
    if (theorem.step().verdict == "law") laws.insert(theorem.id());
  CHECK(laws == std::set<std::string>{"contact.momentum",
                                      "contact.energy",
                                      "contact.changes",
                                      "power.a_0",
                                      "power.b_0",
                                      "power.c_0",
                                      "times.t_1",
                                      "times.s_1",
                                      "times.to_B",
                                      "times.gap_Q",
                                      "times.to_A",
                                      "times.gap_P",
                                      "restitution.momentum",
                                      "restitution.law",
                                      "wedge.wall",
                                      "wedge.v_A_0",
                                      "wedge.v_B_0",
                                      "wedge.v_C_0",
                                      "wedge.tau_1",
                                      "wedge.d_1",
                                      "wedge.to_B",
                                      "wedge.gap_Q",
                                      "wedge.to_A",
                                      "wedge.gap_P"});
}

TEST_CASE("hypotheses are conditions of what rests on them", "[exam][shared]") {
  for (const proof::Theorem& theorem : whole_derivation().theorems) {
    if (theorem.step().verdict != "hypothesis") continue;
    const std::string supposed = proof::to_text(theorem.statement());
    for (const proof::Theorem& other : whole_derivation().theorems) {
      const auto& premises = other.step().premises;
      if (other.step().rule == "special case" ||  // it speaks of other values
          std::find(premises.begin(), premises.end(), theorem.id()) == premises.end())
        continue;
      INFO(other.id() << " rests on " << theorem.id());
      const auto& conditions = other.step().conditions;
      CHECK(std::any_of(conditions.begin(), conditions.end(), [&](const std::string& condition) {
        return condition.find(supposed) != std::string::npos;
      }));
    }
  }
}

TEST_CASE("main results rest on no hypothesis", "[exam][shared]") {
  std::set<std::string> hypotheses;
  for (const proof::Theorem& theorem : whole_derivation().theorems)
    if (theorem.step().verdict == "hypothesis")
      hypotheses.insert(proof::to_text(theorem.statement()));
  CHECK_FALSE(hypotheses.empty());
  for (const char* id : {"power.a",
                         "power.b",
                         "power.c",
                         "power.c_prime",
                         "power.a_product",
                         "chebyshev.a",
                         "counting.N_A",
                         "counting.N_B",
                         "ratios.alpha_k_range",
                         "ratios.beta_k_range",
                         "terminal.A_stays_behind",
                         "terminal.b_below_V",
                         "minima.least",
                         "small_alpha.N",
                         "times.t_of_P",
                         "times.t_of_Q",
                         "frame.lambda_n_paper",
                         "multiples.cos_n",
                         "multiples.sin_n",
                         "table.cos_psi",
                         "mapping.collision",
                         "mapping.wedge",
                         "unfolding.s_of_P",
                         "unfolding.s_of_Q",
                         "unfolding.t_of_P",
                         "unfolding.t_of_Q",
                         "wedge.v_A",
                         "wedge.N_C",
                         "wedge.tau_P",
                         "special_cases.digits_of_pi",
                         "collapse.always_P"})
    for (const std::string& condition : whole_derivation().at(id).step().conditions) {
      INFO(id << ": " << condition);
      CHECK_FALSE(hypotheses.contains(condition));
    }
}

TEST_CASE("every displayed equation that is claimed is proved under its label", "[exam][shared]") {
  const derivation::Paper paper = derivation::paper();
  for (const auto& [label, statement] : paper.equations()) {
    INFO(label);
    const std::string shown = proof::to_text(statement);
    CHECK(std::any_of(whole_derivation().theorems.begin(), whole_derivation().theorems.end(),
                      [&](const proof::Theorem& theorem) {
                        return theorem.step().verdict == "proved" &&
                               proof::to_text(theorem.statement()) == shown &&
                               !theorem.step().label.empty();
                      }));
  }
}

TEST_CASE("a second derivation gives the same steps, word for word", "[check][shared]") {
  const derivation::Derivation again = derivation::derive();
  REQUIRE(again.theorems.size() == whole_derivation().theorems.size());
  for (std::size_t i = 0; i < again.theorems.size(); ++i) {
    const proof::Step &one = whole_derivation().theorems[i].step(),
                      &other = again.theorems[i].step();
    CHECK(one.id == other.id);
    CHECK(one.from == other.from);
    CHECK(one.to == other.to);
    CHECK(one.conditions == other.conditions);
  }
}

TEST_CASE("a derivation up to a chapter is the whole one's beginning, to that chapter's end",
          "[exam][shared]") {
  const auto& all = whole_derivation().theorems;
  const auto in = [](const std::string& chapter, const proof::Theorem& theorem) {
    return theorem.id().starts_with(chapter + ".");
  };
  for (const std::string chapter : {"orthogonal", "power", "transmission"}) {
    const derivation::Derivation begun = derivation::derive_up_to(chapter);
    CHECK_FALSE(begun.refused);
    const std::size_t size = begun.theorems.size();
    REQUIRE(size <= all.size());
    for (std::size_t i = 0; i < size; ++i)
      CHECK(begun.theorems[i].step().from == all[i].step().from);
    CHECK(in(chapter, all[size - 1]));
    CHECK((size == all.size() || !in(chapter, all[size])));
  }
}
