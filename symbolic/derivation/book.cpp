// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/book.hpp"

#include <algorithm>
#include <set>

#include "algebra/logic.hpp"
#include "kernel/defined.hpp"
#include "kernel/print.hpp"

namespace derivation {
namespace {
bool is_part(kernel::Expr part, kernel::Expr of) {
  const kernel::Exprs args = of.args();
  return part == of ||
         std::any_of(args.begin(), args.end(), [&](kernel::Expr a) { return is_part(part, a); });
}
}  // namespace
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
  const auto missing = [&](const kernel::Exprs& added) {
    return unproved_needs(algebra::under(read_first, algebra::under(added, theorem)));
  };
  kernel::Exprs added;  // what the terms need, or else all that the chapter assumes
  for (const kernel::Expr& need : missing({}))
    for (const kernel::Expr& f : last.assumptions)
      if (is_part(f, need)) added.push_back(f);
  if (!added.empty() && !missing(added).empty()) added = last.assumptions;
  for (const kernel::Expr& need : missing(added))
    kernel::refuse(id + " makes sense only where " + kernel::text(need) + ", which is not proved");
  const kernel::Theorem shown = algebra::under(added, theorem);
  last.statements.push_back({id, label, words, shown});
  return shown;
}
kernel::Theorem Book::name(const std::string& symbol, const kernel::Exprs& params,
                           kernel::Expr value, const kernel::Exprs& domain,
                           const std::string& words, const std::string& label,
                           const std::string& shown_as) {
  const std::set<std::string> hidden{"alpha", "V", "M_A", "w_B", "M_C", "e", "L"};
  const auto printed = std::find_if(params.begin(), params.end(),
                                    [&](kernel::Expr p) { return hidden.count(p.name()) == 0; });
  const kernel::Theorem definition =
      kernel::define(symbol, params, value, int(printed - params.begin()));
  if (!domain.empty())
    kernel::restrict_domain(symbol, params,
                            domain.size() == 1 ? domain[0] : kernel::logic_and(domain));
  show(shown_as.empty() ? symbol : shown_as, label, words, algebra::under(domain, definition));
  return definition;
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
