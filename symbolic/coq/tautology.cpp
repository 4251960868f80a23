// SPDX-License-Identifier: GPL-2.0-or-later
// Propositional logic: parts that are no connective become variables, those with one canonical form
// the same; l <= r is not r < l.
#include "coq/script.hpp"
#include "kernel/polynomial.hpp"

namespace coq {
namespace {
bool is_connective(Expr f) {
  return f.op() == Op::Not || f.op() == Op::And || f.op() == Op::Or || f.op() == Op::Imp ||
         f.op() == Op::Iff;
}
/// What the kernel takes the part, or its negation where it is <=, to be.
Expr key(Expr part) {
  if (part.op() == Op::Le) return kernel::canonical(kernel::lt(part.arg(1), part.arg(0)));
  return kernel::canonical(part);
}
class Parts {
public:
  void add(Expr f) {
    if (is_connective(f)) {
      for (Expr a : f.args()) add(a);
      return;
    }
    if (names.count(f)) return;
    give_name(f);
    if (is_matrix_equation(f)) return add(by_entries(f));
    alike[key(f)].push_back(f);
  }
  /// A variable for the key of parts that are several.
  void add_keys() {
    for (const auto& [form, parts] : alike)
      if (parts.size() > 1) give_name(form);
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
  parts.add_keys();
  std::string statement, arguments, proofs;
  const auto bridge = [&](Expr l, Expr r, const std::string& sign, const std::string& proof) {
    statement +=
        "(" + gallina(l, {}, parts.names) + " <-> " + sign + gallina(r, {}, parts.names) + ") -> ";
    proofs += " " + proof;
  };
  for (Expr f : parts.order) {
    arguments += " " + gallina(f);
    if (is_matrix_equation(f)) bridge(f, by_entries(f), "", same_entries(f, {}));
  }
  for (const auto& [form, alike] : parts.alike) {
    if (alike.size() == 1) continue;
    for (Expr f : alike) {
      if (f == form) continue;
      if (f.op() != Op::Le) {
        bridge(f, form, "", same(f, form, {}));
        continue;
      }
      const Expr less = kernel::lt(f.arg(1), f.arg(0));
      bridge(f, form, "~ ", "(iff_trans (not_lt _ _) (same_not _ _ " + same(less, form, {}) + "))");
    }
  }
  for (const Theorem& p : t.step().premises) {
    statement += gallina(p.conclusion(), {}, parts.names) + " -> ";
    proofs += " " + applied(p, c);
  }
  std::string variables;
  for (Expr f : parts.order) variables += " " + parts.names.at(f);
  return "assert (c'0 : forall" + variables + " : Prop, " + statement +
         gallina(t.conclusion(), {}, parts.names) +
         "). { clear. first [tauto | intros; apply NNPP; tauto]. } exact (c'0" + arguments +
         proofs + ").";
}
}  // namespace coq
