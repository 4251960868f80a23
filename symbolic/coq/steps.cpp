// One proof for each rule of the kernel.
#include <algorithm>

#include "coq/script.hpp"
#include "kernel/polynomial.hpp"

namespace coq {
namespace {
Exprs variables_of(const Theorem& t) {
  Exprs all = t.hypotheses();
  all.push_back(t.conclusion());
  return coq::variables_of(all);
}
bool is_in(const Exprs& list, Expr e) { return std::ranges::count(list, e) != 0; }

// Propositional logic: parts with one canonical form become one variable; l <= r is not r < l.

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

std::string Script::statement(const Theorem& t) {
  const Exprs variables = variables_of(t);
  const std::string binders = spaced(names_of(variables));
  std::string out = binders.empty() ? "" : "forall" + binders + " : R, ";
  for (Expr v : variables)
    if (v.sort() == Sort::Int) out += "isint " + name(v.name()) + " -> ";
  for (Expr h : t.hypotheses()) out += gallina(h) + " -> ";
  return out + gallina(t.conclusion());
}
std::string Script::add_lemma(const std::string& kind, const std::string& statement,
                              const std::string& proof) {
  const std::string made = kind + std::to_string(++serial);
  written += "Lemma " + made + " : " + statement + ".\nProof. " + proof + " Qed.\n";
  return made;
}
std::string Script::lemma(const Theorem& wanted) {
  const Sequent content = sequent_of(wanted);
  if (const auto it = lemmas.find(content); it != lemmas.end()) return it->second;
  const Theorem& t = chosen.at(content);
  for (const Theorem& p : t.step().premises) lemma(p);
  for (Expr h : t.hypotheses()) define_all(h);
  define_all(t.conclusion());
  const Exprs variables = variables_of(t);
  std::string intros = spaced(names_of(variables));
  for (Expr v : variables)
    if (v.sort() == Sort::Int) intros += " i'" + v.name();
  for (std::size_t k = 0; k < t.hypotheses().size(); ++k) intros += " h'" + std::to_string(k);
  const std::string why = with_lost_variables(t, {variables, t.hypotheses()});
  return lemmas[content] =
             add_lemma("s'", statement(t), (intros.empty() ? "" : "intros" + intros + ". ") + why);
}
/// Variables of the premises that the theorem has no more may have any value, such as 0.
std::string Script::with_lost_variables(const Theorem& t, Context c) {
  const Step s = t.step();
  Exprs terms;
  for (const Theorem& p : s.premises) terms.push_back(p.conclusion());
  if (s.certificate) {
    for (const auto& [f, p] : s.certificate->equations) terms.push_back(f);
    for (const auto& product : s.certificate->products)
      terms.insert(terms.end(), product.roots.begin(), product.roots.end());
  }
  const bool binds = s.rule == "generalize" || s.rule == "instantiate" || s.rule == "induction";
  std::string out;
  for (Expr v : coq::variables_of(terms)) {
    if (binds || is_in(c.variables, v)) continue;
    c.variables.push_back(v);
    out += "pose (" + name(v.name()) + " := 0). ";
    if (v.sort() == Sort::Int)
      out += "assert (i'" + v.name() + " : isint " + name(v.name()) + ") by exact (int_num 0). ";
  }
  return out + proof(t, c);
}

std::string Script::proof(const Theorem& t, const Context& c) {
  const Step s = t.step();
  const std::string& rule = s.rule;
  if (rule == "assume") return "exact h'0.";
  if (rule == "arithmetic") return arithmetic(t, c);
  if (rule == "tautology") return tautology(t, c);
  if (rule == "rewrite") return rewritten(t, c);
  if (rule == "induction") return induction(t, c);
  if (rule == "start" || rule == "next") return recursive(t);
  if (rule.starts_with("axiom ")) return "axiom.";
  if (rule == "define")
    return s.extras[0].sort() == Sort::Bool ? "apply iff_refl." : "reflexivity.";
  if (rule == "matrix power")
    return "exact (mpow_def " + std::to_string(s.extras[0].rows()) + " " + gallina(s.extras[0]) +
           " " + gallina(s.extras[1]) + " ltac:(int)).";
  if (rule == "least")
    return "exact (least_def " + gallina(s.extras[1]) + " (fun " + name(s.extras[2].name()) +
           " => " + gallina(s.extras[3]) + ") " + gallina(s.extras[2]) + " ltac:(int) ltac:(int)).";
  const Theorem& p = s.premises.at(0);
  Context inner = c;
  if (rule == "instantiate") return "exact " + applied(p, c, s.substitution) + ".";
  if (rule == "restate")
    return "exact (proj1 " + same(p.conclusion(), t.conclusion(), {}) + " " + applied(p, c) + ").";
  const Expr e = s.extras.at(0);
  if (rule == "discharge") {
    const std::string h = "h'" + std::to_string(c.hypotheses.size());
    inner.hypotheses.push_back(e);
    return "intro " + h + ". exact " + applied(p, inner) + ".";
  }
  if (rule == "generalize") {
    inner.variables.push_back(e);
    return "intros " + name(e.name()) + (e.sort() == Sort::Int ? " i'" + e.name() : "") +
           ". exact " + applied(p, inner) + ".";
  }
  if (rule != "specialize") kernel::refuse("no proof in Coq for the rule " + rule);
  const bool takes_integer = p.conclusion().bound_sort() == Sort::Int;
  define_all(e);
  return "exact (" + applied(p, c) + " " + gallina(e) + (takes_integer ? " ltac:(int)" : "") + ").";
}
std::string Script::rewritten(const Theorem& t, const Context& c) {
  const Step s = t.step();
  const Expr equation = s.premises[0].conclusion(), l = equation.arg(0);
  return "exact (eq_ind " + gallina(l) + " (fun z'0 => " +
         gallina(s.premises[1].conclusion(), {}, {{l, "z'0"}}) + ") " + applied(s.premises[1], c) +
         " " + gallina(equation.arg(1)) + " " + applied(s.premises[0], c) + ").";
}
std::string Script::induction(const Theorem& t, const Context& c) {
  const Step s = t.step();
  const Expr n = s.extras[0], lo = s.extras[1], f = s.extras[2];
  const Theorem& base = s.premises[0];
  const Theorem& step = s.premises[1];
  const Expr first = kernel::substitute(f, {{n, lo}});
  const Expr next =
      kernel::imp(kernel::logic_and({kernel::le(lo, n), f}), kernel::substitute(f, {{n, n + 1}}));
  const std::string v = name(n.name());
  return "exact (induct (fun " + v + " => " + gallina(f) + ") " + gallina(lo) + " ltac:(int)" +
         " (proj1 " + same(base.conclusion(), first, {}) + " " + applied(base, c) + ") (fun " + v +
         " i'" + n.name() + " => proj1 " + same(step.conclusion(), next, {}) + " " +
         applied(step, c) + ") " + v + " i'" + n.name() + ").";
}
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
std::string Script::applied(const Theorem& p, const Context& c, const kernel::Substitution& s) {
  std::string out = "(" + lemma(p);
  std::string integers;
  for (Expr v : variables_of(p)) {
    const auto there = s.find(v);
    const Expr e = there != s.end() ? there->second : is_in(c.variables, v) ? v : Expr(0);
    define_all(e);
    out += " " + gallina(e);
    if (v.sort() == Sort::Int) integers += " ltac:(int)";
  }
  out += integers;
  for (Expr h : p.hypotheses()) {
    const Expr there = s.empty() ? h : kernel::substitute(h, s);
    const auto it = std::find(c.hypotheses.begin(), c.hypotheses.end(), there);
    if (it == c.hypotheses.end()) throw std::logic_error("a hypothesis is lost");
    out += " h'" + std::to_string(it - c.hypotheses.begin());
  }
  return out + ")";
}
}  // namespace coq
