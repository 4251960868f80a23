// SPDX-License-Identifier: GPL-2.0-or-later
// Every law and every formula of the paper is spoiled in turn; each time some step must be refused.
#include <set>
#include <vector>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "derivation/derivation.hpp"
#include "mutants.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

using namespace magicmass;
using GiNaC::ex;
using proof::Statement;

namespace {

void check_refused(const derivation::Derivation& result, const Statement& mutant) {
  INFO("mutant: " << proof::to_text(mutant));
  REQUIRE(result.refused);
  CHECK_THAT(result.refused->what(), Catch::Contains("not proved"));
}

void check_formulas_of(const std::string& chapter) {
  const derivation::Laws laws = derivation::conservation_laws();
  const std::map<std::string, Statement> real = derivation::paper().equations();
  const derivation::Beginning before(chapter, laws, derivation::paper());
  for (const auto& [label, statement] : derivation::paper_chapters().at(chapter))
    for (const Statement& mutant : mutants(statement)) {
      // Lengths and energies are the same after any two cycles, so a shifted index spoils nothing in these two.
      const bool conserved = label == "eq:V2" || label == "eq:energy-conservation-PnQn";
      if (conserved && mutant.rhs().has(proof::a(proof::symbol("n") + (label == "eq:V2" ? 0 : 1))))
        continue;
      INFO(label);
      std::map<std::string, Statement> spoiled = real;
      spoiled.insert_or_assign(label, mutant);
      check_refused(before.completed(laws, derivation::Paper(spoiled)), mutant);
    }
}

}  // namespace

TEST_CASE("no spoiled law leads to the paper's results", "[exam]") {
  using derivation::Laws;
  for (Statement Laws::*law :
       {&Laws::momentum, &Laws::energy, &Laws::contact, &Laws::restitution, &Laws::wall,
        &Laws::a_initial, &Laws::b_initial, &Laws::c_initial, &Laws::t_initial, &Laws::s_initial,
        &Laws::t_Q, &Laws::s_Q, &Laws::t_P, &Laws::s_P}) {
    const Laws real = derivation::conservation_laws();
    for (const Statement& mutant : mutants(real.*law)) {
      // v_1 != -u_1, v_1 != 2 u_1 and so on are other conditions, and useless ones: they must be refused too.
      Laws spoiled = real;
      spoiled.*law = mutant;
      check_refused(derivation::derive(spoiled, derivation::paper()), mutant);
    }
  }
}

TEST_CASE("no spoiled formula of contact is proved", "[exam]") { check_formulas_of("contact"); }
TEST_CASE("no spoiled formula of cycle is proved", "[exam]") { check_formulas_of("cycle"); }
TEST_CASE("no spoiled formula of rotation is proved", "[exam]") { check_formulas_of("rotation"); }
TEST_CASE("no spoiled formula of power is proved", "[exam]") { check_formulas_of("power"); }
TEST_CASE("no spoiled formula of counting is proved", "[exam]") { check_formulas_of("counting"); }
TEST_CASE("no spoiled formula of ratios is proved", "[exam]") { check_formulas_of("ratios"); }
TEST_CASE("no spoiled formula of terminal is proved", "[exam]") { check_formulas_of("terminal"); }
TEST_CASE("no spoiled formula of small_alpha is proved", "[exam]") {
  check_formulas_of("small_alpha");
}

TEST_CASE("no spoiled formula of orthogonal is proved", "[exam]") {
  check_formulas_of("orthogonal");
}

TEST_CASE("no spoiled formula of frame is proved", "[exam]") { check_formulas_of("frame"); }

TEST_CASE("no spoiled formula of mapping is proved", "[exam]") { check_formulas_of("mapping"); }

TEST_CASE("no spoiled formula of table is proved", "[exam]") { check_formulas_of("table"); }

TEST_CASE("no spoiled formula of multiples is proved", "[exam]") { check_formulas_of("multiples"); }

TEST_CASE("no spoiled formula of restitution is proved", "[exam]") {
  check_formulas_of("restitution");
}

TEST_CASE("every chapter's formulas are spoiled", "[exam]") {
  const std::set<std::string> above{"restitution", "multiples", "table",    "mapping",    "frame",
                                    "orthogonal",  "contact",   "cycle",    "rotation",   "power",
                                    "counting",    "ratios",    "terminal", "small_alpha"};
  for (const auto& [chapter, equations] : derivation::paper_chapters())
    CHECK(above.contains(chapter));
}
