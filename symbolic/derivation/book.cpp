#include "derivation/book.hpp"

#include <algorithm>

#include "algebra/tactics.hpp"

namespace derivation {
using namespace algebra;
namespace {
// Do the terms of a shown statement make sense? What the kernel says they need is proved here.

/// Is there a proof, from nothing but what is given?
bool holds(const Exprs& given, const std::function<std::optional<Theorem>()>& proof) {
  const auto t = proof();
  if (!t) return false;
  return std::ranges::all_of(t->hypotheses(), [&](Expr h) { return is_among(h, given); });
}

bool proved(Expr condition, const Theorems& facts, const Exprs& given) {
  for (const Theorem& t : facts)
    if (t.conclusion() == condition) return true;
  if (condition.op() == Op::All) return false;
  const bool negated = condition.op() == Op::Not && condition.arg(0).op() == Op::Eq;
  const Expr f = negated ? condition.arg(0) : condition;
  const auto has_sign = [&](Expr d, bool strict) {
    return holds(given, [&] { return sign_of(d, facts, strict); });
  };
  const Expr up = f.arg(1) - f.arg(0);
  if (negated && has_sign(f.arg(0) - f.arg(1), true)) return true;
  const bool has_order = negated || f.op() == Op::Lt || f.op() == Op::Le;
  if (has_order && has_sign(up, f.op() != Op::Le)) return true;
  return holds(given, [&] { return linear_if(condition, facts); });
}
bool is_part(Expr part, Expr of) {
  return part == of || std::ranges::any_of(of.args(), [&](Expr a) { return is_part(part, a); });
}
}  // namespace
void Book::chapter(const std::string& name, const std::string& title, const Exprs& assumptions) {
  all.push_back({name, title, assumptions, {}});
  suppose(assumptions);
}
Theorem Book::show(const std::string& name, const std::string& label, const std::string& words,
                   const Theorem& theorem) {
  Chapter& last = all.back();
  const std::string id = last.name + "." + name;
  if (has(id)) kernel::refuse("two statements " + id);
  // The chapter's assumptions are read before all other hypotheses.
  Exprs read_first;
  for (const Expr& f : last.assumptions)
    if (is_among(f, theorem.hypotheses())) read_first.push_back(f);
  const auto missing = [&](const Exprs& added) {
    return unproved_needs(under(read_first, under(added, theorem)));
  };
  Exprs added;  // what the terms need, or else all that the chapter assumes
  for (const Expr& need : missing({}))
    for (const Expr& f : last.assumptions)
      if (is_part(f, need)) added.push_back(f);
  if (!added.empty() && !missing(added).empty()) added = last.assumptions;
  for (const Expr& need : missing(added))
    kernel::refuse(id + " makes sense only where " + kernel::text(need) + ", which is not proved");
  const Theorem shown = under(added, theorem);
  last.statements.push_back({id, label, words, shown});
  return shown;
}
Theorem Book::name(const std::string& symbol, const Exprs& params, Expr value, const Exprs& domain,
                   const std::string& words, const std::string& label,
                   const std::string& shown_as) {
  const Theorem definition = defined(symbol, params, value, domain);
  show(shown_as.empty() ? symbol : shown_as, label, words, under(domain, definition));
  return definition;
}
const Statement* Book::find(const std::string& id) const {
  for (const Chapter& chapter : all)
    for (const Statement& s : chapter.statements)
      if (s.id == id) return &s;
  return nullptr;
}
Theorem Book::operator[](const std::string& id) const {
  if (const Statement* s = find(id)) return s->theorem;
  kernel::refuse("no theorem " + id);
}
Exprs unproved_needs(const Theorem& theorem) {
  Exprs out;
  for (const Expr& need : needs(theorem)) {
    const bool guarded = need.op() == Op::Imp;
    const Exprs given = guarded ? conjuncts(need.arg(0)) : Exprs{};
    Exprs all_given;
    for (const Expr& g : given)
      for (const Expr& f : conjuncts(g)) all_given.push_back(f);
    Theorems facts = assumed(all_given);
    for (const Theorem& f : known())
      if (holds(all_given, [&] { return f; })) facts.push_back(f);
    for (const Expr& condition : conjuncts(guarded ? need.arg(1) : need))
      if (!is_among(condition, all_given) && !proved(condition, facts, all_given)) {
        out.push_back(need);
        break;
      }
  }
  return out;
}
Theorem defined(const std::string& symbol, const Exprs& params, Expr value, const Exprs& domain) {
  const std::set<std::string> hidden{"alpha", "V", "M_A", "w_B", "M_C",
                                     "e",     "L", "W",   "d_A", "d_B"};
  const auto printed =
      std::ranges::find_if(params, [&](Expr p) { return !hidden.contains(p.name()); });
  const Theorem definition = kernel::define(symbol, params, value, int(printed - params.begin()));
  if (!domain.empty()) kernel::restrict_domain(symbol, params, kernel::logic_and(domain));
  return definition;
}
Theorems defined_by_recursion(const std::vector<std::string>& names, const Exprs& params, Expr n,
                              const Exprs& domain, const Exprs& start,
                              const std::function<Exprs(const Exprs&)>& next) {
  Exprs before;
  for (const std::string& name : names) before.push_back(kernel::real(name + "_before"));
  const Theorems out = kernel::define_recursive(names, params, n, before, start, next(before));
  const Expr where = kernel::logic_and(domain);
  for (const std::string& name : names) kernel::restrict_domain(name, params + Exprs{n}, where);
  return out;
}
}  // namespace derivation
