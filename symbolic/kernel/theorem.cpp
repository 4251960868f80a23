// What a theorem holds.
#include "kernel/theorem.hpp"

#include <algorithm>

namespace kernel {
struct Theorem::Content {
  Exprs hypotheses;
  Expr conclusion;
  Step step;
};
Theorem::Theorem(Exprs hypotheses, Expr conclusion, Step step) {
  // A hypothesis is the conclusion itself (assume), or was one of another theorem: a formula, too.
  if (!is_formula(conclusion))
    refuse("a theorem's conclusion must be a formula, not " + brief(conclusion));
  content =
      std::make_shared<const Content>(Content{std::move(hypotheses), conclusion, std::move(step)});
}
Exprs Theorem::hypotheses() const { return content->hypotheses; }
Expr Theorem::conclusion() const { return content->conclusion; }
Step Theorem::step() const { return content->step; }

Exprs united(const Theorems& premises) {
  Exprs out;
  for (const Theorem& t : premises)
    for (Expr f : t.hypotheses())
      if (std::find(out.begin(), out.end(), f) == out.end()) out.push_back(f);
  return out;
}
void check_not_in_hypotheses(Expr v, const Theorem& t) {
  for (Expr h : t.hypotheses())
    if (free_variables(h).count(v)) refuse(brief(v) + " is free in the hypothesis " + brief(h));
}

std::string text(const Theorem& t) {
  std::string out;
  for (Expr h : t.hypotheses())
    out += (out.empty() ? "" : ", ") + (h.op() == Op::All ? "(" + text(h) + ")" : text(h));
  return out + (out.empty() ? "|- " : " |- ") + text(t.conclusion());
}
}  // namespace kernel
