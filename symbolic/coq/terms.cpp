// One line of Coq for each operation of the kernel.

#include "coq/script.hpp"

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
}  // namespace coq
