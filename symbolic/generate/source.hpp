// SPDX-License-Identifier: GPL-2.0-or-later
// Theorems of the book in units of V, with their ids.
#pragma once
#include <initializer_list>
#include <string>

#include "codegen/manifest.hpp"
#include "derivation/book.hpp"

namespace generate {
class Source {
public:
  kernel::Theorem operator[](const std::string& id) { return taken(id, book[id]); }
  kernel::Theorem part(const std::string& id, std::size_t i);
  kernel::Theorems all(const std::string& chapter, std::initializer_list<const char*> names);
  /// The theorem in units of V, known by that id from now on.
  kernel::Theorem taken(const std::string& id, const kernel::Theorem& t);

  const derivation::Book& book = derivation::the_book();
  const kernel::Substitution units{{kernel::real("V"), 1}};
  codegen::Ids ids;
};
kernel::Theorems operator+(kernel::Theorems a, const kernel::Theorems& b);
}  // namespace generate
