// SPDX-License-Identifier: GPL-2.0-or-later
// The book: chapters of shown theorems, in the order in which they are proved.
#pragma once
#include <string>
#include <vector>

#include "kernel/theorem.hpp"

namespace derivation {
struct Statement {
  std::string id;  ///< "power.a": the chapter, then a name
  std::string
      label;  ///< of the paper's equation, several separated by spaces; empty: the paper has none
  std::string words;
  kernel::Theorem theorem;
};
struct Chapter {
  std::string name;
  std::string title;
  kernel::Exprs assumptions;  ///< said once at its head, not at each of its statements
  std::vector<Statement> statements;
};

class Book {
public:
  void chapter(const std::string& name, const std::string& title, const kernel::Exprs& assumptions);
  /// Adds a statement to the last chapter and returns its theorem. Throws Refused where the id is
  /// taken or where a term of the statement is not proved to make sense under its hypotheses.
  kernel::Theorem show(const std::string& name, const std::string& label, const std::string& words,
                       const kernel::Theorem& theorem);
  kernel::Theorem show(const std::string& name, const std::string& words,
                       const kernel::Theorem& theorem) {
    return show(name, "", words, theorem);
  }
  /// Defines symbol(params) = value, meant to be used where `domain` holds, and shows it there
  /// under the id `shown_as`, or else the symbol. Leading parameters that name masses, V, e or L
  /// are not printed.
  kernel::Theorem name(const std::string& symbol, const kernel::Exprs& params, kernel::Expr value,
                       const kernel::Exprs& domain, const std::string& words,
                       const std::string& label = "", const std::string& shown_as = "");
  /// The theorem of an id. Throws Refused where there is none.
  kernel::Theorem operator[](const std::string& id) const;
  bool has(const std::string& id) const { return find(id) != nullptr; }
  const std::vector<Chapter>& chapters() const { return all; }

private:
  std::vector<Chapter> all;

  const Statement* find(const std::string& id) const;
};

/// What terms of `theorem` need to make sense and neither its hypotheses nor what is known prove.
kernel::Exprs unproved_needs(const kernel::Theorem& theorem);
/// The whole derivation, proved again at each call; its definitions can be made once a process, so
/// the second call throws Refused.
Book derive();
/// The book of this process, proved at the first call.
const Book& the_book();
}  // namespace derivation
