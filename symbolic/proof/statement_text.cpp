// SPDX-License-Identifier: GPL-2.0-or-later
#include <stdexcept>

#include <ginac/ginac.h>

#include "proof/text.hpp"

namespace magicmass::proof {

std::string text(const Statement& statement) {
  return text(statement.lhs()) + " " + text(statement.relation()) + " " + text(statement.rhs());
}

std::string text(Relation relation) {
  switch (relation) {
    case Relation::equal:
      return "=";
    case Relation::not_equal:
      return "!=";
    case Relation::less_equal:
      return "<=";
    case Relation::greater:
      return ">";
    case Relation::asymptotic:
      return "~";
  }
  throw std::logic_error("a relation without a sign");
}

}  // namespace magicmass::proof
