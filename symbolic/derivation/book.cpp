// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/book.hpp"

#include <algorithm>

#include "algebra/logic.hpp"
#include "kernel/print.hpp"

namespace derivation {
void Book::chapter(const std::string& name, const std::string& title,
                   const kernel::Exprs& assumptions) {
  all.push_back({name, title, assumptions, {}});
}
kernel::Theorem Book::show(const std::string& name, const std::string& label,
                           const std::string& words, const kernel::Theorem& theorem) {
  Chapter& last = all.back();
  const std::string id = last.name + "." + name;
  if (has(id)) kernel::refuse("two statements " + id);
  // The chapter's assumptions are read before all other hypotheses.
  kernel::Exprs read_first;
  const kernel::Exprs hypotheses = theorem.hypotheses();
  for (const kernel::Expr& f : last.assumptions)
    if (std::find(hypotheses.begin(), hypotheses.end(), f) != hypotheses.end())
      read_first.push_back(f);
  for (const kernel::Expr& need : unproved_needs(algebra::under(read_first, theorem), facts))
    kernel::refuse(id + " makes sense only where " + kernel::text(need) + ", which is not proved");
  last.statements.push_back({id, label, words, theorem});
  return theorem;
}
const Statement* Book::find(const std::string& id) const {
  for (const Chapter& chapter : all)
    for (const Statement& s : chapter.statements)
      if (s.id == id) return &s;
  return nullptr;
}
kernel::Theorem Book::operator[](const std::string& id) const {
  if (const Statement* s = find(id)) return s->theorem;
  kernel::refuse("no theorem " + id);
}
const Book& the_book() {
  static const Book book = derive();
  return book;
}
}  // namespace derivation
