// The book: chapters of shown theorems, in the order in which they are proved.
#pragma once
#include <functional>

#include "kernel/theorem.hpp"

namespace derivation {
using kernel::Expr;
using kernel::Exprs;
using kernel::Theorem;
using kernel::Theorems;
struct Statement {
  std::string id;  ///< "power.a": the chapter, then a name
  std::string
      label;  ///< of the paper's equation, several separated by spaces; empty: the paper has none
  std::string words;
  Theorem theorem;
};
struct Chapter {
  std::string name;
  std::string title;
  Exprs assumptions;  ///< said once at its head, not at each of its statements
  std::vector<Statement> statements;
};

class Book {
public:
  /// Begins a chapter, in which tactics know its assumptions.
  void chapter(const std::string& name, const std::string& title, const Exprs& assumptions);
  /// Adds a statement to the last chapter and returns its theorem. Throws Refused where the id is
  /// taken or where a term of the statement is not proved to make sense under its hypotheses.
  Theorem show(const std::string& name, const std::string& label, const std::string& words,
               const Theorem& theorem);
  Theorem show(const std::string& name, const std::string& words, const Theorem& theorem) {
    return show(name, "", words, theorem);
  }
  /// As `defined`, and shows it where `domain` holds under the id `shown_as`, or else the symbol.
  Theorem name(const std::string& symbol, const Exprs& params, Expr value, const Exprs& domain,
               const std::string& words, const std::string& label = "",
               const std::string& shown_as = "");
  /// The same, shown as "def_" and the symbol.
  Theorem define(const std::string& symbol, const Exprs& params, Expr value, const Exprs& domain,
                 const std::string& words) {
    return name(symbol, params, value, domain, words, "", "def_" + symbol);
  }
  /// The theorem of an id. Throws Refused where there is none.
  Theorem operator[](const std::string& id) const;
  bool has(const std::string& id) const { return find(id) != nullptr; }
  const std::vector<Chapter>& chapters() const { return all; }

private:
  std::vector<Chapter> all;

  const Statement* find(const std::string& id) const;
};

/// symbol(params) = value, meant to be used where `domain` holds; leading parameters that name
/// masses, V, e or L are not printed.
Theorem defined(const std::string& symbol, const Exprs& params, Expr value, const Exprs& domain);
/// names_i(params, 0) = start_i; names_i(params, n + 1) = next_i of all names(params, n), 0 <= n.
Theorems defined_by_recursion(const std::vector<std::string>& names, const Exprs& params, Expr n,
                              const Exprs& domain, const Exprs& start,
                              const std::function<Exprs(const Exprs&)>& next);
/// What terms of `theorem` need to make sense and neither its hypotheses nor what is known prove.
Exprs unproved_needs(const Theorem& theorem);
/// The book of this process, each chapter proved when it is first asked for.
const Book& the_book();
/// What is proved already; after a chapter that threw, all that was before its fault.
const Book& proved_so_far();
/// The theorem of an id; no chapter is proved beyond the id's own. Throws Refused without one.
Theorem shown(const std::string& id);
bool is_shown(const std::string& id);
}  // namespace derivation
