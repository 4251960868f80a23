// SPDX-License-Identifier: GPL-2.0-or-later
// What the generator lowers and the paper does not display: each such formula is proved again from the same
// premises, then spoiled in many ways, and each time it must be refused.
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "codegen/forms.hpp"
#include "codegen/kernel_forms.hpp"
#include "derivation/derivation.hpp"
#include "mutants.hpp"
#include "proof/kernel.hpp"
#include "proof/text.hpp"

using namespace magicmass;
using proof::Kernel;
using proof::Theorem;

namespace {

const Theorem& named(const Kernel& kernel, const std::string& id) {
  const auto found = std::find_if(kernel.theorems().begin(), kernel.theorems().end(),
                                  [&](const Theorem& theorem) { return theorem.id() == id; });
  INFO(id);
  REQUIRE(found != kernel.theorems().end());
  return *found;
}

std::set<std::string> lowered_theorems() {
  std::set<std::string> ids;
  const auto take = [&ids](const auto& form) {
    for (const auto& [member, theorem] : form.outputs) ids.insert(theorem);
    ids.insert(form.bindings.begin(), form.bindings.end());
  };
  for (const codegen::Form& form : codegen::forms()) take(form);
  for (const codegen::KernelForm& form : codegen::kernel_forms()) {
    take(form);
    ids.insert(form.first.begin(), form.first.end());
    for (const auto& [member, theorems] : form.other_cases)
      ids.insert(theorems.begin(), theorems.end());
  }
  return ids;
}

// By the rule "substitution" from the premises of `theorem`, in their order.
Theorem proved_again(Kernel& kernel, const Theorem& theorem, const proof::Statement& statement) {
  std::vector<Theorem> equations;
  for (const std::string& premise : theorem.step().premises)
    equations.push_back(named(kernel, premise));
  std::map<std::string, long> indices;
  for (const auto& [name, from] : theorem.domain().integer) indices.emplace(name, from);
  return kernel.rewriting(
      {.id = theorem.id() + "_again", .statement = statement, .indices = indices}, equations);
}

}  // namespace

TEST_CASE("no spoiled form is proved", "[exam]") {
  const derivation::Beginning before(derivation::conservation_laws(), derivation::paper());
  std::set<std::string> chapters;
  for (const std::string& id : lowered_theorems()) {
    const Theorem theorem = named(before.kernel(), id);
    if (theorem.step().rule != "substitution") continue;
    chapters.insert(id.substr(0, id.find('.')));
    Kernel kernel = before.kernel();
    INFO(proof::to_text(theorem.statement()));
    REQUIRE_NOTHROW(proved_again(kernel, theorem, theorem.statement()));
    for (const proof::Statement& mutant : deep_mutants(theorem.statement())) {
      INFO("mutant: " << proof::to_text(mutant));
      kernel = before.kernel();
      CHECK_THROWS_AS(proved_again(kernel, theorem, mutant), proof::NotProved);
    }
  }
  for (const char* chapter : {"power", "chebyshev", "times", "tangent", "offset"})
    CHECK(chapters.contains(chapter));
}

TEST_CASE("no other bound of the offset is proved", "[exam]") {
  const derivation::Beginning before(derivation::conservation_laws(), derivation::paper());
  const GiNaC::ex r = proof::symbol("r_t"), psi = proof::symbol("psi");
  const auto refused = [&](const char* id, const proof::Statement& statement) {
    Kernel kernel = before.kernel();
    const Theorem theorem = named(kernel, id);
    const std::vector<std::string>& premises = theorem.step().premises;
    REQUIRE(premises.size() == 4);
    const auto prove = [&](const proof::Statement& claimed, const char* name) {
      kernel.ordering(
          {.id = name, .statement = claimed, .indices = {{"N_A", 1}, {"N_B", 1}}},
          {{GiNaC::numeric(1, 2), {named(kernel, premises[3])}, 1}},
          {named(kernel, premises[0]), named(kernel, premises[1]), named(kernel, premises[2])});
    };
    CHECK_NOTHROW(prove(theorem.statement(), "again"));
    CHECK_THROWS_AS(prove(statement, "spoiled"), proof::NotProved);
  };
  for (const char* last : {"Q", "P", "P_whole"}) {
    refused((std::string("offset.not_negative_after_") + last).c_str(),
            {r, proof::Relation::less_equal, 0});
    refused((std::string("offset.at_most_after_") + last).c_str(),
            {r, proof::Relation::less_equal, psi / 8});
  }
}
