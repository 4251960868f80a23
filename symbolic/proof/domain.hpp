// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proof/statement.hpp"

namespace magicmass::proof {

/// What may be assumed of the symbols, by name. Symbols not named here are real and nothing more.
/// The kernel records every assumption that a proof used as a condition of its theorem.
struct Domain {
  std::set<std::string> positive;       ///< real and > 0
  std::map<std::string, long> integer;  ///< integers from the given value on
  std::vector<Statement> assumed = {};  ///< inequalities ">" and "<="
};

/// What must hold besides: "alpha > 0", "a(n) != a(n - 1)". Ordered by text; the statement, where there is
/// one, lets a special case say what becomes of the condition.
struct Condition {
  std::string text;                                   ///< what must hold
  std::optional<Statement> statement = std::nullopt;  ///< the same, where it is one statement
  std::string index =
      {};  ///< "n" in "n integer, n >= 1": bound by the theorem, so not handed on as it stands
  std::vector<Statement> any_of = {};  ///< "x = 1 or x = y", when the text says that

  /// By text.
  friend bool operator<(const Condition& x, const Condition& y) { return x.text < y.text; }
};
using Conditions = std::set<Condition>;  ///< In order, none twice.

/// "n integer, n >= 1".
inline Condition index_condition(const std::string& name, long from) {
  return {name + " integer, " + name + " >= " + std::to_string(from), std::nullopt, name};
}

}  // namespace magicmass::proof
