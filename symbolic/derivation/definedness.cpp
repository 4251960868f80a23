// SPDX-License-Identifier: GPL-2.0-or-later
// Do the terms of a shown statement make sense? The kernel says what they need; it is proved here,
// or the statement is not shown.
#include <algorithm>
#include <functional>

#include "algebra/linear.hpp"
#include "algebra/signs.hpp"
#include "derivation/book.hpp"
#include "kernel/defined.hpp"

namespace derivation {
using namespace algebra;
namespace {
bool is_among(Expr f, const Exprs& formulas) {
  return std::find(formulas.begin(), formulas.end(), f) != formulas.end();
}
bool holds(const std::function<Theorem()>& proof) {
  try {
    proof();
    return true;
  } catch (const Refused&) {
    return false;
  }
}
Exprs conjuncts(Expr f) { return f.op() == Op::And ? f.args() : Exprs{f}; }

bool proved(Expr condition, const Theorems& known) {
  for (const Theorem& t : known)
    if (t.conclusion() == condition) return true;
  if (holds([&] { return linear(condition, known); })) return true;
  if (condition.op() == Op::Lt)
    return holds([&] { return positive(condition.arg(1) - condition.arg(0), known); });
  if (condition.op() == Op::Le)
    return holds([&] { return not_negative(condition.arg(1) - condition.arg(0), known); });
  if (condition.op() != Op::Not || condition.arg(0).op() != Op::Eq) return false;
  const Expr d = condition.arg(0).arg(0) - condition.arg(0).arg(1);
  return holds([&] { return positive(d, known); }) || holds([&] { return positive(-d, known); }) ||
         holds([&] { return linear(lt(0, d), known); });
}
}  // namespace

Exprs unproved_needs(const Theorem& theorem, const Theorems& facts) {
  Exprs out;
  for (const Expr& need : needs(theorem)) {
    const bool guarded = need.op() == Op::Imp;
    const Exprs given = guarded ? conjuncts(need.arg(0)) : Exprs{};
    Exprs all_given;
    for (const Expr& g : given)
      for (const Expr& f : conjuncts(g)) all_given.push_back(f);
    Theorems known;
    for (const Expr& f : all_given)
      if (f.op() == Op::Lt || f.op() == Op::Le || f.op() == Op::Eq) known.push_back(assume(f));
    for (const Theorem& f : facts) {
      const Exprs hypotheses = f.hypotheses();
      const bool usable = std::all_of(hypotheses.begin(), hypotheses.end(),
                                      [&](Expr h) { return is_among(h, all_given); });
      if (usable) known.push_back(f);
    }
    for (const Expr& condition : conjuncts(guarded ? need.arg(1) : need))
      if (!is_among(condition, all_given) && !proved(condition, known)) {
        out.push_back(need);
        break;
      }
  }
  return out;
}
}  // namespace derivation
