// SPDX-License-Identifier: GPL-2.0-or-later
// The names and functions of what people type, kept apart from those of the derivation.

#include "kernel/names.hpp"
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
bool is_function(Expr e, std::string_view name) { return e.op() == Op::Fun && e.name() == name; }

// x^y is a power with an exponent from here on, which nobody can type: so the kernel prints it.
constexpr int first_mark = 500000;
std::string bracketed(Expr e) {
  const std::string text = typed_text(e);
  const bool is_word = e.op() == Op::Var || (e.op() == Op::Fun && !is_function(e, "raised"));
  return (is_word && !is_function(e, "inv")) || is_whole(text) ? text : "(" + text + ")";
}
// As the operators make it, without inv(2).
Expr printable(Expr e, std::vector<std::string>& exponents) {
  if (is_function(e, "raised")) {
    const Expr base = printable(e.arg(0), exponents);
    exponents.push_back(bracketed(e.arg(1)));
    return kernel::power(base, first_mark + int(exponents.size()) - 1);
  }
  if (e.size() == 0) return e;
  Exprs args;
  for (Expr arg : e.args()) args.push_back(printable(arg, exponents));
  return is_function(e, "inv") ? Expr(1) / args[0] : with_args(e, args);
}
}  // namespace

std::optional<cln::cl_RA> rational_value(Expr e) {
  if (e.op() == Op::Num) return e.value();
  if (e.op() == Op::Pow) {
    const auto base = rational_value(e.arg(0));
    if (!base || is_long(*base, e.exponent())) return {};
    return cln::expt(*base, e.exponent());
  }
  if (e.op() != Op::Add && e.op() != Op::Mul && !is_function(e, "inv")) return {};
  const bool is_sum = e.op() == Op::Add;
  cln::cl_RA out = is_sum ? 0 : 1;
  for (Expr arg : e.args()) {
    const auto value = rational_value(arg);
    if (!value || is_long(*value)) return {};
    out = is_sum ? out + *value : out * *value;
  }
  if (!is_function(e, "inv")) return out;
  return out == 0 ? std::nullopt : std::optional(1 / out);
}

Expr symbol(const std::string& name) { return real(std::string(mark) + name); }
std::string name_of(Expr e) {
  if (e.op() != Op::Var || !e.name().starts_with(mark)) return "";
  return e.name().substr(mark.size());
}
std::string alike(const std::string& name, const std::set<std::string>& names) {
  const auto plain = [](std::string text) {
    std::erase(text, '_');
    for (char& c : text) c = char(c | 0x20);  // small
    return text;
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
  return order == 2 ? kernel::sqrt(x) : apply("root", {x, Expr(order)});
}
Expr call(const std::string& name, Expr x) { return apply(name, {x}); }
std::string typed_text(Expr e) {
  std::vector<std::string> exponents;
  std::string text = kernel::text(printable(e, exponents));
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    const std::string number = std::to_string(first_mark + int(i));
    text.replace(text.find("^" + number) + 1, number.size(), exponents[i]);
  }
  for (std::size_t at = 0; (at = text.find(mark, at)) != text.npos;) {
    const std::size_t end = text.find_first_of(" +-*/^(),", at);
    std::string name = text.substr(at, end - at).substr(mark.size()) + "_";
    if (const std::size_t prime = name.find("_prime_"); prime != name.npos)
      name.replace(prime, 6, "'");  // as it was typed
    text.replace(at, end - at, name, 0, name.size() - 1);
  }
  return text;
}
}  // namespace notation
