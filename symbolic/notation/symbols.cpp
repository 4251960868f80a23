// SPDX-License-Identifier: GPL-2.0-or-later
// The names and functions of what people type, kept apart from those of the derivation.
#include <cln/rational.h>

#include "kernel/names.hpp"
#include "kernel/print.hpp"
#include "notation/operations.hpp"
#include "notation/typed.hpp"

namespace notation {
using namespace kernel;
namespace {
constexpr std::string_view mark = "typed_";

// Declared at the first use; the kernel has no axiom of them.
Expr apply(const std::string& name, const Exprs& args) {
  if (!signature(name)) declare(name, {.args = std::vector<Sort>(args.size(), Sort::Real)});
  return fun(name, args);
}
bool is_long(const cln::cl_RA& q, int times = 1) { return bits(q) * std::size_t(times) > 1000; }
std::string without_marks(std::string text) {
  for (std::size_t at = 0; (at = text.find(mark, at)) != text.npos;) text.erase(at, mark.size());
  return text;
}

enum Level { Sum, Product, Power, Atom };
std::string printed(Expr e, Level around);

Level level_of_number(const cln::cl_RA& q) {
  return q < 0 ? Sum : cln::denominator(q) == 1 ? Atom : Product;
}
std::string bracketed(const std::string& text, Level around, Level own) {
  return own < around ? "(" + text + ")" : text;
}
Expr base_of(Expr e) { return e.op() == Op::Pow ? e.arg(0) : e; }
bool is_inverse(Expr e) { return e.op() == Op::Fun && e.name() == "inv"; }
std::string printed_sum(Expr e) {
  std::string out = printed(e.arg(0), Sum);
  for (std::size_t i = 1; i < e.size(); ++i) {
    const std::string next = printed(e.arg(i), Sum);
    out += next[0] == '-' ? " - " + next.substr(1) : " + " + next;
  }
  return out;
}
std::string printed_product(Expr e) {
  std::string over;
  std::string under;
  for (Expr factor : e.op() == Op::Mul ? e.args() : Exprs{e}) {
    const Expr base = base_of(factor);
    const bool power = factor.op() == Op::Pow;
    const bool below = is_inverse(base);
    std::string one = printed(below ? base.arg(0) : base, power ? Atom : below ? Power : Product);
    if (power) one += "^" + std::to_string(factor.exponent());
    if (factor == Expr(-1) && over.empty() && e.op() == Op::Mul) {
      over = "-";
      continue;
    }
    if (over.empty() && factor.op() == Op::Num) one = digits(factor.value());
    std::string& side = below ? under : over;
    side += below ? "/" + one : (side.empty() || side == "-" ? "" : "*") + one;
  }
  return (over.empty() || over == "-" ? over + "1" : over) + under;
}
std::string printed_function(Expr e, Level around) {
  const std::string name = e.name();
  if (name == "raised")
    return bracketed(printed(e.arg(0), Atom) + "^" + printed(e.arg(1), Atom), around, Power);
  if (e.size() == 0) return without_marks(kernel::text(e));
  std::string inside;
  for (Expr arg : e.args()) inside += (inside.empty() ? "" : ", ") + printed(arg, Sum);
  return (name == "nth_root" ? "root" : name) + "(" + inside + ")";
}
std::string printed(Expr e, Level around) {
  if (is_inverse(base_of(e)) || e.op() == Op::Mul)
    return bracketed(printed_product(e), around, Product);
  switch (e.op()) {
    case Op::Num:
      return bracketed(digits(e.value()), around, level_of_number(e.value()));
    case Op::Add:
      return bracketed(printed_sum(e), around, Sum);
    case Op::Pow:
      return bracketed(printed(e.arg(0), Atom) + "^" + std::to_string(e.exponent()), around, Power);
    case Op::Fun:
      return printed_function(e, around);
    default:
      return without_marks(kernel::text(e));
  }
}
}  // namespace

std::optional<cln::cl_RA> rational_value(Expr e) {
  if (e.op() == Op::Num) return e.value();
  if (e.op() == Op::Pow) {
    const auto base = rational_value(e.arg(0));
    if (!base || is_long(*base, e.exponent())) return {};
    return cln::expt(*base, e.exponent());
  }
  if (e.op() != Op::Add && e.op() != Op::Mul && !is_inverse(e)) return {};
  const bool is_sum = e.op() == Op::Add;
  cln::cl_RA out = is_sum ? 0 : 1;
  for (Expr arg : e.args()) {
    const auto value = rational_value(arg);
    if (!value || is_long(*value)) return {};
    out = is_sum ? out + *value : out * *value;
  }
  if (!is_inverse(e)) return out;
  return out == 0 ? std::nullopt : std::optional(1 / out);
}

Expr symbol(const std::string& name) { return real(std::string(mark) + name); }
std::string name_of(Expr e) {
  if (e.op() != Op::Var || !e.name().starts_with(mark)) return "";
  return e.name().substr(mark.size());
}
std::string alike(const std::string& name, const std::set<std::string>& names) {
  const auto plain = [](const std::string& text) {
    std::string out;
    for (const char c : text)
      if (c != '_') out += c >= 'A' && c <= 'Z' ? char(c | 0x20) : c;
    return out;
  };
  if (name.size() == 1) return "";  // M and m are two masses
  for (const std::string& other : names)
    if (plain(other) == plain(name)) return other;
  return "";
}
std::string parted(const std::string& word, const std::set<std::string>& names) {
  if (names.contains(word)) return word;
  for (const std::string& name : names) {
    const std::size_t before = name.find_last_not_of("0123456789");  // u2 is u_2
    std::string plain = name;
    if (before < name.size() - 1 && name[before] == '_') plain.erase(before, 1);
    for (const std::string& form : {name, plain}) {
      if (!word.starts_with(form)) continue;
      if (word == form) return name;
      const std::string rest = parted(word.substr(form.size()), names);
      if (!rest.empty()) return name + " " + rest;
    }
  }
  return {};
}
std::set<std::string> symbols_of(Expr e) {
  std::set<std::string> out;
  for (Expr v : free_variables(e))
    if (const std::string name = name_of(v); !name.empty()) out.insert(name);
  return out;
}
Expr raised(Expr base, Expr exponent) { return apply("raised", {base, exponent}); }
Expr root(int order, Expr x) {
  return order == 2 ? kernel::sqrt(x) : apply("nth_root", {x, Expr(order)});
}
Expr call(const std::string& name, Expr x) { return apply(name, {x}); }
std::string typed_text(Expr e) { return printed(e, Sum); }
}  // namespace notation
