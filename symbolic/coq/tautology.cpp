// Propositional logic: parts with one canonical form become one variable; l <= r is not r < l.
#include "coq/script.hpp"
#include "kernel/polynomial.hpp"

namespace coq {
namespace {
/// What the kernel takes the part, or its negation where it is <=, to be.
Expr key(Expr part) {
  if (part.op() == Op::Le) return kernel::canonical(kernel::lt(part.arg(1), part.arg(0)));
  return kernel::canonical(part);
}
struct Parts {
  void add(Expr f) {
    if (std::set{Op::Not, Op::And, Op::Or, Op::Imp, Op::Iff}.contains(f.op())) {
      for (Expr a : f.args()) add(a);
      return;
    }
    if (names.count(f)) return;
    give_name(f);
    if (is_matrix_equation(f)) return add(by_entries(f));
    alike[key(f)].push_back(f);
  }
  void give_name(Expr f) {
    if (names.emplace(f, "p'" + std::to_string(names.size())).second) order.push_back(f);
  }
  Atoms names = {};
  Exprs order = {};
  std::map<Expr, Exprs> alike = {};
};
}  // namespace

std::string Script::tautology(const Theorem& t, const Context& c) {
  Parts parts;
  for (const Theorem& p : t.step().premises) parts.add(p.conclusion());
  parts.add(t.conclusion());
  // A variable for the key of parts that are several; others have none.
  std::erase_if(parts.alike, [](const auto& of) { return of.second.size() == 1; });
  for (const auto& [form, alike] : parts.alike) parts.give_name(form);
  std::string variables, statement, arguments, proofs;
  const auto bridge = [&](Expr l, Expr r, const std::string& sign, const std::string& proof) {
    statement +=
        "(" + gallina(l, {}, parts.names) + " <-> " + sign + gallina(r, {}, parts.names) + ") -> ";
    proofs += " " + proof;
  };
  for (Expr f : parts.order) {
    variables += " " + parts.names.at(f);
    arguments += " " + gallina(f);
    if (is_matrix_equation(f)) bridge(f, by_entries(f), "", same_entries(f, {}));
  }
  for (const auto& [form, alike] : parts.alike)
    for (Expr f : alike)
      if (f.op() == Op::Le) {
        const std::string proof = same(kernel::lt(f.arg(1), f.arg(0)), form, {});
        bridge(f, form, "~ ", "(iff_trans (not_lt _ _) (same_not _ _ " + proof + "))");
      } else if (!(f == form)) {
        bridge(f, form, "", same(f, form, {}));
      }
  for (const Theorem& p : t.step().premises) {
    statement += gallina(p.conclusion(), {}, parts.names) + " -> ";
    proofs += " " + applied(p, c);
  }
  return "assert (c'0 : forall" + variables + " : Prop, " + statement +
         gallina(t.conclusion(), {}, parts.names) +
         "). { clear. first [tauto | intros; apply NNPP; tauto]. } exact (c'0" + arguments +
         proofs + ").";
}
}  // namespace coq
