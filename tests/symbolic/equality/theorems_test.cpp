// SPDX-License-Identifier: GPL-2.0-or-later
// What the derivation has proved must be equal here too, and what it has not must not.
#include <algorithm>
#include <optional>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "derivation/derivation.hpp"
#include "equality/decide.hpp"
#include "equality/from_ginac.hpp"
#include "equality/paper_names.hpp"
#include "proof/names.hpp"
#include "whole_derivation.hpp"

using namespace magicmass;
using namespace magicmass::equality;

namespace {

struct Sides {
  std::string id;
  Tree lhs, rhs;
};

bool has_step_function(const GiNaC::ex& e) {
  return proof::is_step_function(e) || std::any_of(e.begin(), e.end(), has_step_function);
}

// The scalar equations about functions of alpha, n, k and V that hold without a hypothesis.
std::vector<Sides> scalar_equations() {
  const std::set<std::string> known{"alpha", "n", "k", "m", "V", "L"};
  std::vector<Sides> result;
  for (const proof::Theorem& theorem : whole_derivation().theorems) {
    const GiNaC::ex& left = theorem.lhs();
    const GiNaC::ex& right = theorem.rhs();
    if (theorem.step().verdict != "proved" ||
        theorem.statement().relation() != proof::Relation::equal ||
        GiNaC::is_a<GiNaC::matrix>(left) || proof::contains_sequence(left) ||
        proof::contains_sequence(right) || has_step_function(left) || has_step_function(right))
      continue;
    try {
      const Sides sides{theorem.id(), with_meanings(from_ginac(left)),
                        with_meanings(from_ginac(right))};
      std::set<std::string> symbols = symbols_of(sides.lhs);
      collect_symbols(sides.rhs, symbols);
      // psi = 2 pi/(2 k + 1) and the like: a hypothesis ties alpha to k
      const bool tied = symbols.contains("alpha") && symbols.contains("k");
      if (!tied && std::includes(known.begin(), known.end(), symbols.begin(), symbols.end()))
        result.push_back(sides);
    } catch (const std::exception&) {  // a product of matrices: no scalar
    }
  }
  return result;
}

Verdict verdict_on(const Tree& lhs, const Tree& rhs) {
  std::set<std::string> symbols = symbols_of(lhs);
  collect_symbols(rhs, symbols);
  return decide(lhs, rhs, parse_domain({}, symbols));
}

// Each number in the tree, in turn, made larger by 1.
void mutants(const Tree& tree, const std::function<void(const Tree&)>& use) {
  if (is_number(tree)) return use(number(tree->value + 1));
  for (std::size_t i = 0; i < tree->parts.size(); ++i)
    mutants(tree->parts[i], [&](const Tree& part) {
      std::vector<Tree> parts = tree->parts;
      parts[i] = part;
      use(with_parts(tree, parts));
    });
}

}  // namespace

TEST_CASE("the derivation's scalar theorems are equal, and their mutants are not",
          "[check][shared]") {
  const std::vector<Sides> equations = scalar_equations();
  // sqrt(sec x - 1) sqrt(sec x + 1) is tan x only where its sign is known from the range of x
  const std::set<std::string> undecided{"ratios.alpha_k_back", "ratios.beta_k_back"};
  CHECK(equations.size() >= 10);
  for (const Sides& sides : equations) {
    INFO(sides.id << ": " << to_text(sides.lhs) << " = " << to_text(sides.rhs));
    const Verdict verdict = verdict_on(sides.lhs, sides.rhs);
    INFO(verdict.proof);
    if (undecided.contains(sides.id))
      CHECK(verdict.answer == Answer::undecided);
    else
      CHECK(verdict.answer == Answer::equal);
    mutants(sides.rhs, [&](const Tree& wrong) {
      INFO("mutant " << to_text(wrong));
      try {
        CHECK(verdict_on(sides.lhs, wrong).answer == Answer::different);
      } catch (const NoQuestion&) {  // a root of a negative number
      }
    });
  }
}

TEST_CASE("the defined names mean what the derivation proves", "[exam][shared]") {
  const std::vector<std::pair<std::string, std::string>> proved{
      {"psi", "rotation.psi_paper"},
      {"theta", "contact.theta_paper"},
      {"V_CM", "power.V_CM_paper"},
      {"alpha_k", "ratios.alpha_k_paper"},
      {"beta_k", "ratios.beta_k_paper"},
      {"a_n", "power.a"},
      {"b_n", "power.b"},
      {"c_n", "power.c"},
      {"c_prime_n", "power.c_prime"},
  };
  REQUIRE(proved.size() == defined_names().size());
  for (const auto& [name, id] : proved) {
    INFO(name);
    const Tree meant = meaning(name).value();
    const Tree theorem = with_meanings(from_ginac(whole_derivation().at(id).rhs()));
    CHECK(verdict_on(meant, theorem).answer == Answer::equal);
  }
}
