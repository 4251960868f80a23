// One line of Coq for each operation of the kernel.

#include "coq/script.hpp"
#include "kernel/names.hpp"

namespace coq {
std::string name(const std::string& kernel_name) {
  static const std::map<std::string, std::string> own = {{"inv", "/"}, {"pi", "PI"}};
  static const std::set<std::string> taken = {
      "R",     "PI",     "isint",      "toN",    "fromN", "least",  "entry",  "dot",   "table",
      "munit", "mtimes", "mtranspose", "mpow",   "det",   "as",     "at",     "cofix", "else",
      "end",   "exists", "exists2",    "fix",    "for",   "forall", "fun",    "if",    "in",
      "let",   "match",  "mod",        "nat",    "O",     "Prop",   "return", "S",     "Set",
      "then",  "Type",   "using",      "where",  "with",  "Z",      "list",   "fst",   "snd",
      "and",   "or",     "not",        "square", "minus", "half"};
  if (const auto it = own.find(kernel_name); it != own.end()) return it->second;
  return kernel_name + (taken.count(kernel_name) != 0 ? "'k" : "");
}
std::string spaced(const Names& names) {
  std::string out;
  for (const std::string& n : names) out += " " + n;
  return out;
}

namespace {
std::string rational(const cln::cl_RA& q) {
  const std::string above = kernel::digits(cln::cl_RA(cln::numerator(q)));
  if (cln::denominator(q) == 1) return q < 0 ? "(" + above + ")" : above;
  return "(" + above + " / " + kernel::digits(cln::cl_RA(cln::denominator(q))) + ")";
}
std::string sizes(std::initializer_list<int> of) {
  std::string out;
  for (const int k : of) out += std::to_string(k) + " ";
  return out;
}
}  // namespace

std::string gallina(Expr e, const Names& bound, const Atoms& atoms) {
  static const std::map<Op, std::string> signs = {
      {Op::Add, " + "},   {Op::Mul, " * "},  {Op::Eq, " = "},   {Op::Lt, " < "},   {Op::Le, " <= "},
      {Op::And, " /\\ "}, {Op::Or, " \\/ "}, {Op::Imp, " -> "}, {Op::Iff, " <-> "}};
  if (const auto it = atoms.find(e); it != atoms.end()) return it->second;
  const auto joined = [&](const std::string& before, const std::string& between,
                          const std::string& after = ")") {
    std::string out;
    for (Expr a : e.args()) out += (out.empty() ? before : between) + gallina(a, bound, atoms);
    return out + after;
  };
  switch (e.op()) {
    case Op::Num:
      return rational(e.value());
    case Op::Var:
      return name(e.name());
    case Op::Bound:
      return bound.at(bound.size() - 1 - std::size_t(e.index()));
    case Op::Fun:
      return e.size() == 0 ? name(e.name()) : joined("(" + name(e.name()) + " ", " ");
    case Op::Pow:
      return joined("(", "", " ^ " + std::to_string(e.exponent()) + ")");
    case Op::Not:
      return joined("(~ ", "");
    case Op::All: {
      Names inner = bound;
      inner.push_back("q'" + std::to_string(bound.size()));
      return "(forall " + inner.back() + " : R, " +
             (e.bound_sort() == Sort::Int ? "isint " + inner.back() + " -> " : "") +
             gallina(e.arg(0), inner, atoms) + ")";
    }
    case Op::Matrix:
      return joined("[", "; ", "]");
    case Op::Times:
      return joined("(mtimes " + sizes({e.rows(), e.arg(0).cols(), e.cols()}), " ");
    case Op::Transpose:
      return joined("(mtranspose " + sizes({e.cols(), e.rows()}), "");
    case Op::MatrixPower:
      return joined("(mpow " + sizes({e.rows()}), " (toN ", "))");
    case Op::Entry:
      return joined("(entry ", "", " " + std::to_string(e.index()) + ")");
    case Op::Det:
      return joined("(det " + sizes({e.arg(0).rows()}), "");
    default:
      return joined("(", signs.at(e.op()));
  }
}
Names loose_names(Expr e) {
  Names out;
  for (int k = e.loose(); k > 0; --k) out.push_back("b'" + std::to_string(k - 1));
  return out;
}
Names names_of(const Exprs& variables) {
  Names out;
  for (Expr v : variables) out.push_back(name(v.name()));
  return out;
}
Exprs variables_of(const Exprs& es) {
  std::set<Expr> all;
  for (Expr e : es) all.merge(kernel::free_variables(e));
  return {all.begin(), all.end()};
}

// Definitions of Coq for those of the kernel, each before its first use.
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
