// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/equality.hpp"

#include <algorithm>
#include <numeric>

#include "answers/errors.hpp"
#include "answers/evaluate.hpp"
#include "answers/shown_text.hpp"
#include "derivation/book.hpp"
#include "kernel/print.hpp"

namespace answers {
namespace {

using equality::Verdict;
using kernel::Expr;
using kernel::Op;

// A term of the book in the symbols that people type.
Expr typed(Expr e) {
  if (e.op() == Op::Var) return notation::symbol(e.name());
  if (e.size() == 0) return e;
  kernel::Exprs args;
  for (Expr arg : e.args()) args.push_back(typed(arg));
  return kernel::with_args(e, args);
}

/// Letters to insert, delete or replace to make one word the other.
std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}
void note_misspellings(const std::set<std::string>& names, std::vector<std::string>& notes) {
  for (const std::string& name : names)
    for (const std::string known : {"alpha", "theta", "psi", "V_CM"})
      if (name.size() >= 3 && name != known && edit_distance(name, known) <= known.size() / 2 - 1)
        notes.push_back(name + " is taken as a symbol of its own; " + known + "?");
}

Cell counterexample_cell(const Verdict& verdict) {
  if (!verdict.counterexample) return missing_cell();
  const auto& c = *verdict.counterexample;
  const auto json = [](const std::string& text) { return text_cell(text).json; };
  return {(c.point.empty() ? "" : "at " + c.point + ": ") + c.left + " and " + c.right +
              ", apart by " + c.difference,
          "{\"at\": " + json(c.point) + ", \"left\": " + json(c.left) +
              ", \"right\": " + json(c.right) + ", \"difference\": " + json(c.difference) + "}"};
}

}  // namespace

Expr with_meanings(Expr e, std::vector<std::string>& notes) {
  kernel::Substitution meanings;
  for (const std::string& name : notation::symbols_of(e)) {
    const Expr equation = definition_of(name);
    if (!equation || name == "rho") continue;
    meanings.emplace(notation::symbol(name), typed(written_out(equation.arg(1))));
    notes.push_back(name + " = " + kernel::text(equation.arg(1)));
  }
  return kernel::substitute(e, meanings);
}

Expr stated_value(const std::string& step) {
  const std::size_t colon = step.find(": ");
  const std::string left = colon == step.npos ? "" : step.substr(colon + 2);
  kernel::Exprs open{derivation::the_book()[step.substr(0, colon)].conclusion()};
  while (!open.empty()) {
    const Expr e = open.back();
    open.pop_back();
    if (e.op() == Op::Imp) open.push_back(e.arg(1));
    for (std::size_t i = e.op() == Op::And ? e.size() : 0; i > 0; --i) open.push_back(e.arg(i - 1));
    if (e.op() == Op::Eq && (left.empty() || kernel::text(e.arg(0)) == left))
      return typed(written_out(e.arg(1)));
  }
  kernel::refuse(step + ": this step states no such equation");
}

std::vector<Column> equal_columns() {
  return named_columns(
      {"verdict", "proof", "counterexample", "domain", "conditions", "theorem", "notes"});
}

Answer equal(const Request& request) {
  if (request.words.size() != 2)
    throw InvalidInput(
        "equal: two expressions are needed; example: magicmass equal \"sqrt(8)\" "
        "\"2*sqrt(2)\"");
  std::vector<std::string> notes;
  std::vector<Expr> sides;
  std::set<std::string> symbols;
  try {
    for (int i : {0, 1}) {
      try {
        notation::Typed read = notation::read_typed(request.words[std::size_t(i)]);
        if (kernel::is_matrix(read.term)) kernel::refuse("a matrix; equal compares numbers");
        notes.insert(notes.end(), read.notes.begin(), read.notes.end());
        note_misspellings(notation::symbols_of(read.term), notes);
        sides.push_back(with_meanings(read.term, notes));
        symbols.merge(notation::symbols_of(sides.back()));
      } catch (const kernel::Refused& r) {
        throw InvalidInput(std::string("equal: ") + (i == 0 ? "left" : "right") + " side, " +
                           shown_text(r.what(), 300));
      }
    }
    const equality::Domain domain = equality::read_domain(request.text("domain"), symbols, notes);
    const Verdict verdict = equality::decide(sides[0], sides[1], domain);
    notes.insert(notes.end(), verdict.notes.begin(), verdict.notes.end());
    const Row row{text_cell(equality::word(verdict.answer)),
                  text_cell(verdict.proof),
                  counterexample_cell(verdict),
                  list_cell(verdict.domain),
                  list_cell(verdict.conditions),
                  verdict.theorem.empty() ? missing_cell() : text_cell(verdict.theorem),
                  list_cell(notes)};
    return {{equal_columns(), {row}, false},
            "",
            verdict.answer == equality::Answer::Different,
            verdict.answer == equality::Answer::Undecided};
  } catch (const kernel::Refused& r) {
    throw InvalidInput(std::string("equal: ") + shown_text(r.what(), 300));
  }
}

}  // namespace answers
