// The loop over the bits of an index, and its calls.
#include "codegen/emit.hpp"

namespace codegen {
namespace {

/// f at another index.
Expr at(Expr f, Expr index) {
  Exprs arguments = f.args();
  arguments.back() = index;
  return kernel::fun(f.name(), arguments);
}
std::string cpp_name(Expr f) {
  const std::string name = f.name();
  return name.ends_with("_") ? name.substr(0, name.size() - 1) : name;
}
/// x of 2*x.
Expr half_of(Expr index) {
  const bool is_double = index.op() == kernel::Op::Mul && index.size() == 2;
  return is_double && index.arg(0) == Expr(2) ? index.arg(1) : Expr();
}
/// A term, from now on a number of that name.
void know(Builder& terms, Expr term, const std::string& name) {
  terms.nodes[term] = terms.input(name, false, {-infinity, infinity});
}
}  // namespace

std::string emit_doubling(const Doubling& t, const Domain& d) {
  const Expr f = head(d, t.at_0), even = head(d, t.even);
  const Expr m = half_of(even.arg(even.size() - 1));
  const bool is_integer = bool(m) && m.op() == kernel::Op::Var && m.sort() == kernel::Sort::Int;
  const Exprs heads{f, head(d, t.at_1), even, head(d, t.odd)};
  if (!is_integer || heads != Exprs{at(f, 0), at(f, 1), at(f, 2 * m), at(f, 2 * m + 1)})
    throw Refused("not f at 0, 1, 2*m and 2*m + 1: " + kernel::text(t.even.conclusion()));
  for (const Theorem& step : {t.even, t.odd})
    for (Expr h : step.hypotheses())
      if (kernel::free_variables(h).contains(m))
        throw Refused("not for every m: " + kernel::text(h));
  Builder terms(Numbers::field);
  std::string parameters;  // f at 0 has no others
  for (Expr p : kernel::free_variables(f)) {
    know(terms, p, identifier(p.name()));
    parameters += "const Number& " + identifier(p.name()) + ", ";
  }
  const auto value = [&](const Theorem& theorem, const std::string& at_m) {
    Builder these = terms;
    know(these, at(f, m), at_m);
    const int k = these.build(theorem.conclusion().arg(1));
    return PlainText(these.program).right_side(k);
  };
  const std::string start = value(t.at_0, "low"), first = value(t.at_1, "low");
  know(terms, at(f, 1), "first");
  const std::string lower = value(t.even, "low"), upper = value(t.even, "high");
  know(terms, at(f, m + 1), "high");
  const auto line = [](const std::string& code, const Theorem& of) {
    return commented(code, kernel::text(of.conclusion()));
  };
  return "/// " + cpp_name(f) + " at 2n and at 2n + 1, by doubling the index.\n" +
         "template <class Number> std::pair<Number, Number> " + cpp_name(f) + "_doubled(" +
         parameters + "std::int64_t n) {\n" +
         line("  const Number first = " + first + ";", t.at_1) +
         line("  Number low = " + start + ";", t.at_0) +
         "  Number high = first;\n"
         "  const std::uint64_t index = 2 * std::uint64_t(n);\n"
         "  for (int bit = int(std::bit_width(index)); bit-- > 0;) {\n" +
         line("    const Number between = " + value(t.odd, "low") + ";", t.odd) +
         "    if ((index >> bit & 1) != 0) {\n      low = between;\n" +
         line("      high = " + upper + ";", t.even) + "    } else {\n      high = between;\n" +
         line("      low = " + lower + ";", t.even) + "    }\n  }\n  return {low, high};\n}\n";
}

std::string call_doubling(const Doubling& t, Expr term, Builder& terms) {
  const Expr f = t.at_0.conclusion().arg(0);
  std::string lines;
  for (Expr a : term.args()) lines += call_doubling(t, a, terms);
  if (term.op() != kernel::Op::Fun || term.name() != f.name()) return lines;
  if (terms.nodes.count(term) > 0) return lines;
  const Expr index = term.arg(term.size() - 1);
  const bool is_odd = index.op() == kernel::Op::Add && index.size() == 2 && index.arg(1) == Expr(1);
  const Expr x = half_of(is_odd ? index.arg(0) : index);
  const bool is_known = bool(x) && terms.nodes.contains(x) && terms.range(x).low >= 0;
  if (!is_known || !(term == at(f, index)))
    throw Refused("not f at 2*x or 2*x + 1: " + kernel::text(term));
  const std::string pair = cpp_name(f) + "_at_" + identifier(x.name());
  know(terms, at(f, 2 * x), pair + ".first");
  know(terms, at(f, 2 * x + 1), pair + ".second");
  Words arguments;
  for (Expr p : kernel::free_variables(f)) arguments.push_back(identifier(p.name()));
  arguments.push_back(identifier(x.name()));
  return lines + "  const std::pair<Number, Number> " + pair + " = " + cpp_name(f) + "_doubled(" +
         joined(arguments, ", ") + ");\n";
}
}  // namespace codegen
