// SPDX-License-Identifier: GPL-2.0-or-later
// One proof for each rule of the kernel.
#include <algorithm>

#include "coq/script.hpp"
#include "kernel/names.hpp"

namespace coq {
using kernel::Expr;
using kernel::Exprs;
using kernel::Op;
using kernel::Sort;
using kernel::Theorem;

namespace {
Exprs variables_of(const Theorem& t) {
  Exprs all = t.hypotheses();
  all.push_back(t.conclusion());
  return coq::variables_of(all);
}
bool is_in(const Exprs& list, Expr e) {
  return std::find(list.begin(), list.end(), e) != list.end();
}
std::string known_axiom(const std::string& axiom) {
  static const std::map<std::string, std::string> proofs = {
      {"equal or less or greater", "apply ax_order"},
      {"less is not equal", "lra"},
      {"discrete", "apply ax_discrete; assumption"},
      {"root squared", "apply pow2_sqrt"},
      {"root not negative", "intro; apply sqrt_pos"},
      {"ceiling", "apply ax_ceil"},
      {"sin 0", "apply sin_0"},
      {"cos 0", "apply cos_0"},
      {"sin sum", "apply sin_plus"},
      {"cos sum", "rewrite cos_plus; ring"},
      {"sin minus", "rewrite !minus; apply sin_neg"},
      {"cos minus", "rewrite minus; apply cos_neg"},
      {"circle", "rewrite <- !Rsqr_pow2; apply sin2_cos2"},
      {"sin pi", "apply sin_PI"},
      {"cos pi", "apply cos_PI"},
      {"sin pi/2", "rewrite half; apply sin_PI2"},
      {"cos pi/2", "rewrite half; apply cos_PI2"},
      {"sin positive", "intros [? ?]; now apply sin_gt_0"},
      {"sin at most x", "apply ax_sin_at_most"},
      {"cos falls", "intros [? [? ?]]; apply cos_decreasing_1; lra"},
      {"pi positive", "apply PI_RGT_0"},
      {"atan range", "destruct (atan_bound x); lra"},
      {"atan positive", "intro; rewrite <- atan_0; now apply atan_increasing"},
      {"atan rises", "apply atan_increasing"},
      {"cos atan", "rewrite cos_atan, Rsqr_pow2; unfold Rdiv; ring"},
      {"sin atan", "rewrite sin_atan, Rsqr_pow2; reflexivity"},
      {"atan bounds", "apply ax_atan_bounds"}};
  const auto it = proofs.find(axiom);
  if (it == proofs.end()) kernel::refuse("no proof in Coq of the axiom " + axiom);
  return it->second + ".";
}
}  // namespace

std::string Script::statement(const Theorem& t) {
  const Exprs variables = variables_of(t);
  const std::string binders = spaced(names_of(variables));
  std::string out = binders.empty() ? "" : "forall" + binders + " : R, ";
  for (Expr v : variables)
    if (v.sort() == Sort::Int) out += "isint " + name(v.name()) + " -> ";
  for (Expr h : t.hypotheses()) out += text(h) + " -> ";
  return out + text(t.conclusion());
}
std::string Script::add_lemma(const std::string& kind, const std::string& statement,
                              const std::string& proof) {
  const std::string made = kind + std::to_string(++serial);
  written += "Lemma " + made + " : " + statement + ".\nProof. " + proof + " Qed.\n";
  return made;
}
std::string Script::lemma(const Theorem& t) {
  const Content content{t.hypotheses(), t.conclusion()};
  if (const auto it = lemmas.find(content); it != lemmas.end()) return it->second;
  for (const Theorem& p : t.step().premises) lemma(p);
  if (const auto it = lemmas.find(content); it != lemmas.end()) return it->second;
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
  const kernel::Step s = t.step();
  Exprs terms;
  for (const Theorem& p : s.premises) terms.push_back(p.conclusion());
  if (s.certificate) {
    for (const auto& [f, p] : s.certificate->equations) terms.push_back(f);
    for (const auto& product : s.certificate->products)
      terms.insert(terms.end(), product.roots.begin(), product.roots.end());
  }
  Exprs lost;
  const bool binds = s.rule == "generalize" || s.rule == "instantiate" || s.rule == "induction";
  for (Expr v : coq::variables_of(terms))
    if (!binds && !is_in(c.variables, v)) lost.push_back(v);
  c.variables.insert(c.variables.end(), lost.begin(), lost.end());
  if (lost.empty()) return proof(t, c);
  const std::string binders = spaced(names_of(lost));
  std::string premises;
  std::string intros = binders;
  std::string values;
  std::string integers;
  for (Expr v : lost) {
    values += " 0";
    if (v.sort() != Sort::Int) continue;
    premises += "isint " + name(v.name()) + " -> ";
    intros += " i'" + v.name();
    integers += " (int_num 0)";
  }
  return "assert (any : forall" + binders + " : R, " + premises + text(t.conclusion()) +
         "). { intros" + intros + ". " + proof(t, c) + " } exact (any" + values + integers + ").";
}

std::string Script::proof(const Theorem& t, const Context& c) {
  const std::string rule = t.step().rule;
  if (rule == "arithmetic") return arithmetic(t, c);
  if (rule == "tautology") return tautology(t, c);
  if (rule == "rewrite") return rewritten(t, c);
  if (rule == "induction") return induction(t, c);
  if (rule.rfind("axiom ", 0) == 0) return known_axiom(rule.substr(6));
  return t.step().premises.empty() && rule != "assume" ? defined(t) : logic(t, c);
}
std::string Script::logic(const Theorem& t, const Context& c) {
  const kernel::Step s = t.step();
  if (s.rule == "assume") return "exact h'0.";
  const Theorem& p = s.premises[0];
  Context inner = c;
  if (s.rule == "instantiate") return "exact " + applied(p, c, s.substitution) + ".";
  if (s.rule == "restate")
    return "exact (proj1 " + same(p.conclusion(), t.conclusion(), {}) + " " + applied(p, c) + ").";
  if (s.rule == "discharge") {
    const std::string h = "h'" + std::to_string(c.hypotheses.size());
    inner.hypotheses.push_back(s.extras[0]);
    return "intro " + h + ". exact " + applied(p, inner) + ".";
  }
  const bool is_integer = s.extras[0].sort() == Sort::Int;
  if (s.rule == "generalize") {
    const Expr v = s.extras[0];
    inner.variables.push_back(v);
    return "intros " + name(v.name()) + (is_integer ? " i'" + v.name() : "") + ". exact " +
           applied(p, inner) + ".";
  }
  if (s.rule != "specialize") kernel::refuse("no proof in Coq for the rule " + s.rule);
  const bool takes_integer = p.conclusion().bound_sort() == Sort::Int;
  define_all(s.extras[0]);
  return "exact (" + applied(p, c) + " " + text(s.extras[0]) +
         (takes_integer ? " " + integer(s.extras[0]) : "") + ").";
}
std::string Script::rewritten(const Theorem& t, const Context& c) {
  const kernel::Step s = t.step();
  const Expr equation = s.premises[0].conclusion();
  const Expr l = equation.arg(0);
  return "exact (eq_ind " + text(l) + " (fun z' => " +
         text(s.premises[1].conclusion(), {}, {{l, "z'"}}) + ") " + applied(s.premises[1], c) +
         " " + text(equation.arg(1)) + " " + applied(s.premises[0], c) + ").";
}
std::string Script::induction(const Theorem& t, const Context& c) {
  const kernel::Step s = t.step();
  const Expr n = s.extras[0];
  const Expr lo = s.extras[1];
  const Expr f = s.extras[2];
  const Theorem& base = s.premises[0];
  const Theorem& step = s.premises[1];
  const Expr first = kernel::substitute(f, {{n, lo}});
  const Expr next =
      kernel::imp(kernel::logic_and({kernel::le(lo, n), f}), kernel::substitute(f, {{n, n + 1}}));
  const std::string v = name(n.name());
  return "exact (induct (fun " + v + " => " + text(f) + ") " + text(lo) + " " + integer(lo) +
         " (proj1 " + same(base.conclusion(), first, {}) + " " + applied(base, c) + ") (fun " + v +
         " i'" + n.name() + " => proj1 " + same(step.conclusion(), next, {}) + " " +
         applied(step, c) + ") " + v + " i'" + n.name() + ").";
}
std::string Script::defined(const Theorem& t) {
  const kernel::Step s = t.step();
  if (s.rule == "define")
    return s.extras[0].sort() == Sort::Bool ? "apply iff_refl." : "reflexivity.";
  if (s.rule == "matrix power")
    return "exact (mpow_def " + std::to_string(s.extras[0].rows()) + " " + text(s.extras[0]) + " " +
           text(s.extras[1]) + " " + integer(s.extras[1]) + ").";
  if (s.rule == "least")
    return "exact (least_def _ (fun " + name(s.extras[2].name()) + " => " + text(s.extras[3]) +
           ") _ " + integer(s.extras[1]) + " " + integer(s.extras[2]) + ").";
  if (s.rule == "start" || s.rule == "next") return recursive(t);
  kernel::refuse("no proof in Coq for the rule " + s.rule);
}

std::string Script::applied(const Theorem& p, const Context& c, const kernel::Substitution& s) {
  const auto value = [&](Expr v) {
    if (const auto it = s.find(v); it != s.end()) return it->second;
    return is_in(c.variables, v) ? v : Expr(0);
  };
  std::string out = "(" + lemma(p);
  std::string integers;
  for (Expr v : variables_of(p)) {
    const Expr e = value(v);
    define_all(e);
    out += " " + text(e);
    if (v.sort() == Sort::Int) integers += " " + integer(e);
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
std::string Script::integer(Expr e) {
  std::string out;
  switch (e.op()) {
    case Op::Num:
      return "(int_num " + text(e) + ")";
    case Op::Var:
      return "i'" + e.name();
    case Op::Pow:
      return "(int_pow _ _ " + integer(e.arg(0)) + ")";
    case Op::Add:
    case Op::Mul:
      for (Expr a : e.args())
        out = out.empty() ? integer(a)
                          : std::string(e.op() == Op::Add ? "(int_add" : "(int_mul") + " _ _ " +
                                out + " " + integer(a) + ")";
      return out;
    default:
      break;
  }
  if (e.name() == "ceil") return "(int_ceil " + text(e.arg(0)) + ")";
  out = "(int'" + e.name();
  for (Expr a : e.args()) out += " " + text(a);
  const kernel::Signature& s = *kernel::signature(e.name());
  for (std::size_t k = 0; k < e.size(); ++k)
    if (s.args[k] == Sort::Int) out += " " + integer(e.arg(k));
  return out + ")";
}
}  // namespace coq
