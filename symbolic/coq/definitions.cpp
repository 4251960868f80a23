// Definitions of Coq for those of the kernel, each before its first use.
#include "coq/script.hpp"
#include "kernel/names.hpp"

namespace coq {
namespace {
std::string parameters(const Exprs& variables) {
  return variables.empty() ? "" : " (" + spaced(names_of(variables)).substr(1) + " : R)";
}
/// That the value is an integer, for the prelude's int.
std::string integer_lemma(Expr call, const std::string& proof) {
  std::string premises;
  for (Expr p : call.args())
    if (p.sort() == Sort::Int) premises += "isint " + name(p.name()) + " -> ";
  const std::string binders = spaced(names_of(call.args()));
  return "Lemma int'" + call.name() + " : " + (binders.empty() ? "" : "forall" + binders + ", ") +
         premises + "isint " + gallina(call) + ".\nProof. intros. " + proof +
         " Qed.\nGlobal Hint Resolve int'" + call.name() + " : int.\n";
}
/// A recursion: n, then for each sequence its value at n, the variable for the value before, the
/// start, the step. In Coq they are functions of a natural number, defined together.
struct Recursion {
  explicit Recursion(const Step& s) : n(s.extras[0]) {
    for (std::size_t k = 1; k + 3 < s.extras.size(); k += 4) {
      values.push_back(s.extras[k]);
      before.push_back(s.extras[k + 1]);
      start.push_back(s.extras[k + 2]);
      next.push_back(s.extras[k + 3]);
    }
    params = values[0].args();
    params.pop_back();
  }
  std::string value(std::size_t i, const std::string& at) const {
    return "(all'" + values[i].name() + spaced(names_of(params)) + " " + at + ")";
  }
  Expr n;
  Exprs values = {}, before = {}, start = {}, next = {}, params = {};
};
}  // namespace

Script::Script(Proofs of) : chosen(std::move(of)) {
  for (const auto& [content, t] : chosen) {
    const Step s = t.step();
    if (s.rule == "define" || s.rule == "least") definitions.emplace(s.extras[0].name(), t);
    if (s.rule == "start" || s.rule == "next")
      for (std::size_t k = 1; k < s.extras.size(); k += 4)
        definitions.emplace(s.extras[k].name(), t);
  }
}
void Script::define_all(Expr e) {
  static const std::set<std::string> of_coq = {"inv", "sqrt", "sin", "cos", "atan", "ceil", "pi"};
  const bool is_own = e.op() == Op::Fun && !of_coq.count(e.name());
  if (is_own && !std::exchange(is_defined[e.name()], true)) {
    const auto it = definitions.find(e.name());
    if (it == definitions.end()) kernel::refuse("no definition of " + e.name());
    written += definition(it->second);
  }
  for (Expr a : e.args()) define_all(a);
}

std::string Script::definition(const Theorem& t) {
  const Step s = t.step();
  if (s.rule == "start" || s.rule == "next") return recursion(s);
  const Expr call = s.extras[0];
  const std::string head = "Definition " + name(call.name()) + parameters(call.args());
  const bool is_least = s.rule == "least";
  for (Expr e : s.extras)
    if (!(e == call)) define_all(e);
  const std::string value = is_least
                                ? "least " + gallina(s.extras[1]) + " (fun " +
                                      name(s.extras[2].name()) + " => " + gallina(s.extras[3]) + ")"
                                : gallina(s.extras[1]);
  static const std::map<Sort, std::string> types = {
      {Sort::Real, "R"}, {Sort::Int, "R"}, {Sort::Bool, "Prop"}, {Sort::Matrix, "list R"}};
  const std::string made = head + " : " + types.at(call.sort()) + " := " + value + ".\n";
  if (call.sort() != Sort::Int) return made;
  return made + integer_lemma(call, is_least ? "apply int_least; int."
                                             : "unfold " + name(call.name()) + "; int.");
}

std::string Script::recursion(const Step& s) {
  const Recursion r(s);
  Atoms before{{r.n, "(fromN m'0)"}};
  for (std::size_t i = 0; i < r.values.size(); ++i) {
    is_defined[r.values[i].name()] = true;
    before[r.before[i]] = r.value(i, "m'0");
    define_all(r.start[i]);
    define_all(r.next[i]);
  }
  std::string all, values;
  for (std::size_t i = 0; i < r.values.size(); ++i) {
    all += (i == 0 ? "Fixpoint all'" : "\nwith all'") + r.values[i].name() + parameters(r.params) +
           " (k'0 : nat) {struct k'0} : R :=\n  match k'0 with O => " + gallina(r.start[i]) +
           " | S m'0 => " + gallina(r.next[i], {}, before) + " end";
    values += "Definition " + name(r.values[i].name()) + parameters(r.values[i].args()) +
              " : R := " + r.value(i, "(toN " + name(r.n.name()) + ")") + ".\n";
  }
  return all + ".\n" + values;
}
std::string Script::recursive(const Theorem& t) {
  const Step s = t.step();
  const Recursion r(s);
  const bool is_start = s.rule == "start";
  const std::string function = (is_start ? t.conclusion() : t.conclusion().arg(1)).arg(0).name();
  std::size_t i = 0;
  while (r.values[i].name() != function) ++i;
  const std::string jump = "(f_equal (fun k'0 => " + r.value(i, "k'0") + ") ";
  if (is_start) return "exact " + jump + "toN_0).";
  Atoms now{{r.n, "z'0"}};
  for (std::size_t k = 0; k < r.values.size(); ++k) now[r.before[k]] = gallina(r.values[k]);
  const std::string from_0 = " " + name(r.n.name()) + " i'" + r.n.name() + " h'0)";
  return "intro h'0. exact (eq_trans " + jump + "(toN_next" + from_0 + ") (f_equal (fun z'0 => " +
         gallina(r.next[i], {}, now) + ") (fromN_toN" + from_0 + ")).";
}
}  // namespace coq
