// SPDX-License-Identifier: GPL-2.0-or-later
// Statements with something wrong in them.
#pragma once

#include <vector>

#include <ginac/ginac.h>

#include "proof/names.hpp"
#include "proof/statement.hpp"

namespace magicmass {

// A sign, a factor and an index, on the right side; terms of a sum one by one.
inline std::vector<proof::Statement> mutants(const proof::Statement& statement) {
  const GiNaC::ex &lhs = statement.lhs(), &rhs = statement.rhs();
  const proof::Relation relation = statement.relation();
  std::vector<proof::Statement> all;
  if (rhs.is_zero()) {
    all.emplace_back(lhs, relation, proof::symbol("V"));
    return all;
  }
  all.emplace_back(lhs, relation, -rhs);
  all.emplace_back(lhs, relation, 2 * rhs);
  if (GiNaC::is_a<GiNaC::add>(rhs))
    for (const GiNaC::ex& term : rhs) all.emplace_back(lhs, relation, rhs - 2 * term);
  for (const char* name : {"n", "k", "N_A", "N_B"}) {
    const GiNaC::ex index = proof::symbol(name);
    const GiNaC::ex shifted = rhs.subs(index == index + 1);
    if (!shifted.is_equal(rhs)) all.emplace_back(lhs, relation, shifted);
  }
  return all;
}

// The same, and one sign in each sum inside.
inline std::vector<proof::Statement> deep_mutants(const proof::Statement& statement) {
  std::vector<proof::Statement> all = mutants(statement);
  const GiNaC::ex& rhs = statement.rhs();
  for (auto part = rhs.preorder_begin(); part != rhs.preorder_end(); ++part) {
    if (!GiNaC::is_a<GiNaC::add>(*part) || part->is_equal(rhs)) continue;
    for (const GiNaC::ex& term : *part)
      all.emplace_back(statement.lhs(), statement.relation(),
                       rhs.subs(*part == *part - 2 * term, GiNaC::subs_options::no_pattern));
  }
  return all;
}

}  // namespace magicmass
