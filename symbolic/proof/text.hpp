// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "proof/domain.hpp"
#include "proof/statement.hpp"

namespace magicmass::proof {

/// An expression in infix notation, the same on every run: operands are ordered by what they are and
/// by name, never by GiNaC's own order. Equal trees give equal text, so it also serves as a key.
std::string to_text(const GiNaC::ex& e);

/// Both sides and the sign between them.
std::string to_text(const Statement& statement);
std::string to_text(Relation relation);  ///< "=", "!=", "<=", ">", "~"

/// Whether the term that comes first by name has a negative coefficient. GiNaC holds x - y or -(y - x) as
/// its hashes fall; whoever prints or translates a sum as a factor asks this and turns the sign round.
bool leads_with_minus(const GiNaC::ex& sum);

/// Whether words speak of a symbol by its name.
bool speaks_of(const std::string& words, const std::string& name);

/// The statement as a condition.
inline Condition condition(const Statement& statement) { return {to_text(statement), statement}; }

}  // namespace magicmass::proof
