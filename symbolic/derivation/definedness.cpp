// Do the terms of a shown statement make sense? What the kernel says they need is proved here.
#include <algorithm>

#include "algebra/tactics.hpp"
#include "derivation/book.hpp"

namespace derivation {
using namespace algebra;
namespace {
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
}  // namespace

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
}  // namespace derivation
