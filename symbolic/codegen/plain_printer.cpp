// SPDX-License-Identifier: GPL-2.0-or-later
// Prints terms as they stand in the theorems.
#include "codegen/plain_printer.hpp"

#include <array>
#include <cmath>

#include "codegen/exact.hpp"
#include "codegen/quantity.hpp"
#include "kernel/print.hpp"

namespace codegen {
using kernel::Expr;
using kernel::Op;

namespace {
struct Function {
  const char* name;
  Interval (*range)(Interval);
};
Interval rounded_up(Interval x) { return {std::ceil(x.low), std::ceil(x.high)}; }
/// Of any angle: where it is past the half turn that is known, all values are allowed for.
Interval any_sine(Interval x) {
  const bool is_known = x.low >= -1.5 && x.high <= 3.14;
  return is_known ? sine(x) : Interval{-1, 1};
}
Interval any_cosine(Interval x) {
  const bool is_known = x.size() <= 3.14;
  return is_known ? cosine(x) : Interval{-1, 1};
}
constexpr std::array<Function, 5> functions_of_cmath{{{"sqrt", root},
                                                      {"sin", any_sine},
                                                      {"cos", any_cosine},
                                                      {"atan", arc_tangent},
                                                      {"ceil", rounded_up}}};
const Function* function_of(Expr e) {
  if (e.op() != Op::Fun) return nullptr;
  for (const Function& f : functions_of_cmath) {
    if (e.name() == f.name) return &f;
  }
  return nullptr;
}
/// inv(x) or inv(x)^k: below the line.
bool is_inverse(Expr e) {
  const Expr base = e.op() == Op::Pow ? e.arg(0) : e;
  return base.op() == Op::Fun && base.name() == "inv";
}
}  // namespace

std::string without_brackets(const std::string& s) {
  if (s.empty() || s[0] != '(') return s;
  int depth = 0;
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    depth += s[k] == '(' ? 1 : s[k] == ')' ? -1 : 0;
    if (depth == 0) return s;
  }
  return s.substr(1, s.size() - 2);
}

bool PlainPrinter::is_function(Expr e) { return function_of(e) != nullptr; }

/// An exact form has no ranges: its numbers are those of any field.
template <class Operation>
Interval PlainPrinter::ranged(const Operation& operation) const {
  return is_exact ? Interval{0, 0} : operation();
}
Printed PlainPrinter::checked(std::string text, Expr e, Interval r) const {
  const bool is_small = r.least() > 0 && r.least() < plain_smallest;
  if (!(r.size() <= plain_largest) || is_small) {
    throw Refused(kernel::text(e) + " may over- or underflow");
  }
  return {std::move(text), r};
}
Printed PlainPrinter::number(const cln::cl_RA& q) const {
  const std::string above = "Number(" + kernel::digits(cln::numerator(q)) + ")";
  const double x = nearest(q);
  const Interval range = is_double(q) ? Interval{x, x} : around(x, x);
  if (cln::denominator(q) == 1) return {above, range};
  return {"(" + above + " / Number(" + kernel::digits(cln::denominator(q)) + "))", range};
}
Printed PlainPrinter::sum(Expr e, bool in_product) {
  Printed s = print(e.arg(0));
  for (std::size_t k = 1; k < e.size(); ++k) {
    const Expr term = e.arg(k);
    const Expr lead = term.op() == Op::Mul ? term.arg(0) : term;
    const bool is_taken_off = lead.op() == Op::Num && lead.value() < 0;
    const Printed next = print(is_taken_off ? kernel::operator-(term) : term, true);
    const Interval range = ranged([&] {
      return s.range + (is_taken_off ? Interval{-1, -1} * next.range : next.range);
    });
    s = checked(s.text + (is_taken_off ? " - " : " + ") + next.text, e, range);
  }
  if (in_product) s.text = "(" + s.text + ")";
  return s;
}
Printed PlainPrinter::product(Expr e) {
  Printed p = number(1);
  bool is_one = true;
  for (Expr a : e.args()) {
    if (is_inverse(a) || a == Expr(1)) continue;
    const Printed factor = print(a, true);
    const Interval range = ranged([&] { return p.range * factor.range; });
    p = checked(is_one ? factor.text : p.text + " * " + factor.text, e, range);
    is_one = false;
  }
  for (Expr a : e.args()) {
    if (!is_inverse(a)) continue;
    const Expr below = a.op() == Op::Pow ? kernel::power(a.arg(0).arg(0), a.exponent()) : a.arg(0);
    if (below == Expr(1)) continue;
    const Printed divisor = print(below, true);
    const Interval range = ranged([&] { return p.range / divisor.range; });
    p = checked(p.text + " / " + divisor.text, e, range);
    is_one = false;
  }
  const bool is_word = p.text.find(' ') == std::string::npos;
  return {is_word ? p.text : "(" + p.text + ")", p.range};
}
Printed PlainPrinter::power(Expr e) {
  if (is_inverse(e)) return product(kernel::operator*(1, e));
  const Printed base = print(e.arg(0), true);
  Printed p = base;
  for (int k = 1; k < e.exponent(); ++k) {
    const Interval range =
        ranged([&] { return k == 1 ? square(base.range) : p.range * base.range; });
    p = checked(p.text + " * " + base.text, e, range);
  }
  return {"(" + p.text + ")", p.range};
}
Printed PlainPrinter::call(Expr e) {
  if (is_inverse(e)) return product(kernel::operator*(1, e));
  const bool is_pi = e.name() == "pi" && e.size() == 0;
  const Function* function = function_of(e);
  if (!is_pi && function == nullptr) throw Refused("no definition of " + kernel::text(e));
  if (is_exact) throw Refused("no operation of a field: " + kernel::text(e));
  if (is_pi) {
    functions.insert("atan");
    return {"(Number(4) * atan(Number(1)))", around(nearest(pi()), nearest(pi()))};
  }
  const Expr x = e.arg(0);
  if (e.name() == "sqrt" && x.op() == Op::Pow && x.exponent() == 2) {
    functions.insert("abs");
    const Printed of = print(x.arg(0));
    return {"abs(" + without_brackets(of.text) + ")", magnitude(of.range)};
  }
  functions.insert(function->name);
  const Printed of = print(x);
  return checked(e.name() + "(" + without_brackets(of.text) + ")", e, function->range(of.range));
}
Printed PlainPrinter::print(Expr e, bool in_product) {
  if (const auto found = names.find(e); found != names.end()) return found->second;
  switch (e.op()) {
    case Op::Num:
      return number(e.value());
    case Op::Add:
      return sum(e, in_product);
    case Op::Mul:
      return product(e);
    case Op::Pow:
      return power(e);
    case Op::Fun:
      return call(e);
    default:
      throw Refused("no plain form of " + kernel::text(e));
  }
}
}  // namespace codegen
