// SPDX-License-Identifier: GPL-2.0-or-later
#include <cctype>
#include <stdexcept>

#include <ginac/ginac.h>

#include "proof/text.hpp"

namespace magicmass::proof {

std::string to_text(const Statement& statement) {
  return to_text(statement.lhs()) + " " + to_text(statement.relation()) + " " +
         to_text(statement.rhs());
}

std::string to_text(Relation relation) {
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

bool speaks_of(const std::string& words, const std::string& name) {
  const auto part_of_name = [](char character) {
    return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_';
  };
  for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !part_of_name(words[at - 1])) &&
        (end == words.size() || !part_of_name(words[end])))
      return true;
  }
  return false;
}

}  // namespace magicmass::proof
