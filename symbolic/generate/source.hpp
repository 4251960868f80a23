// SPDX-License-Identifier: GPL-2.0-or-later
// Theorems of the book in units of V, with their ids.
#pragma once
#include <string>

#include "codegen/manifest.hpp"
#include "derivation/book.hpp"

namespace generate {
class Source {
public:
  /// "evaluators.def_w def_t terminal.definitions/2": a word without a chapter is of the one before
  /// it, /2 is the theorem's part 2, counted from 0. Each is known by its id from now on.
  kernel::Theorems operator()(const std::string& words);

  const kernel::Substitution units{{kernel::real("V"), 1}};
  codegen::Ids ids;
};
}  // namespace generate
