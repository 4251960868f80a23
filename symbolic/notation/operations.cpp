
#include "kernel/names.hpp"
#include "notation/tokens.hpp"
#include "notation/typed.hpp"

namespace notation {
using namespace kernel;
namespace {
constexpr int largest_exponent = 10000;
constexpr std::size_t most_bits = 70000;

const std::map<std::string, std::string>& definitions() {
  static const auto table = [] {
    std::map<std::string, std::string> all;
    for (const std::string name :
         {"sqrt", "abs", "sin", "cos", "asin", "acos", "atan", "exp", "log"})
      all.emplace(name, "");
    std::istringstream others(
        "cbrt root(x,3) tan sin(x)/cos(x) cot cos(x)/sin(x) sec 1/cos(x) csc 1/sin(x) "
        "sinh (exp(x)-exp(-x))/2 cosh (exp(x)+exp(-x))/2 "
        "tanh (exp(x)-exp(-x))/(exp(x)+exp(-x)) coth (exp(x)+exp(-x))/(exp(x)-exp(-x)) "
        "sech 2/(exp(x)+exp(-x)) csch 2/(exp(x)-exp(-x)) asinh log(x+sqrt(x^2+1)) "
        "acosh log(x+sqrt(x^2-1)) atanh (log(1+x)-log(1-x))/2 "
        "arcsin asin(x) arccos acos(x) arctan atan(x) arctg atan(x) tg tan(x) ctg cot(x) "
        "cosec csc(x) ln log(x) arsinh asinh(x) arcosh acosh(x) artanh atanh(x) "
        "arcsinh asinh(x) arccosh acosh(x) arctanh atanh(x) "
        "asec acos(1/x) acsc asin(1/x) arcsec acos(1/x) arccsc asin(1/x) acoth atanh(1/x) "
        "arcoth atanh(1/x) asech acosh(1/x) arsech acosh(1/x) acsch asinh(1/x) arcsch asinh(1/x)");
    for (std::string other, what; others >> other >> what;) all.emplace(other, what);
    return all;
  }();
  return table;
}
Expr scaled(Expr scalar, Expr grid) {
  Exprs out;
  for (Expr e : entries(grid)) out.push_back(scalar * e);
  return matrix(grid.cols(), out);
}

// The names and functions of what people type, kept apart from those of the derivation.
constexpr std::string_view mark = "typed_";

// Declared at the first use; the kernel has no axiom of them.
Expr apply(const std::string& name, const Exprs& args) {
  if (!signature(name)) declare(name, {.args = std::vector<Sort>(args.size(), Sort::Real)});
  return fun(name, args);
}
bool is_long(const cln::cl_RA& q, int times = 1) { return bits(q) * std::size_t(times) > 1000; }

// x^y is a power with an exponent from here on, which nobody can type: so the kernel prints it.
constexpr int first_mark = 500000;
std::string bracketed(Expr e) {
  const std::string text = typed_text(e);
  const bool is_word = e.op() == Op::Var || (e.op() == Op::Fun && !is_call(e, "raised"));
  return (is_word && !is_call(e, "inv")) || is_whole(text) ? text : "(" + text + ")";
}
// As the operators make it, without inv(2).
Expr printable(Expr e, std::vector<std::string>& exponents) {
  if (is_call(e, "raised")) {
    const Expr base = printable(e.arg(0), exponents);
    exponents.push_back(bracketed(e.arg(1)));
    return kernel::power(base, first_mark + int(exponents.size()) - 1);
  }
  if (e.size() == 0) return e;
  Exprs args;
  for (Expr arg : e.args()) args.push_back(printable(arg, exponents));
  return is_call(e, "inv") ? Expr(1) / args[0] : with_args(e, args);
}
}  // namespace

std::size_t bits(const cln::cl_RA& q) {
  return cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
}

bool is_function(const std::string& name) { return name == "root" || definitions().contains(name); }
const std::string& definition_of(const std::string& function) { return definitions().at(function); }
std::string why_no_symbol(const std::string& word, bool is_before_bracket,
                          const std::set<std::string>& factors) {
  static const std::set<std::string> rounding{"ceil", "floor", "round", "trunc", "int"};
  static const std::set<std::string> usual{"x", "y", "z", "t", "u", "V", "L",
                                           "M", "m", "e", "n", "k", "j"};
  if (factors.contains(word)) return "";
  if (rounding.contains(word)) return word + no_rounding;
  if (word == "acot" || word == "arccot" || word == "arcctg")
    return word + " has two readings: write atan(1/x) or pi/2 - atan(x)";
  for (const auto& [function, definition] : definitions()) {
    if (!word.starts_with(function) || word == function) continue;
    const std::string rest = word.substr(function.size());
    const auto name = rest.substr(std::min(rest.find_first_not_of("0123456789"), rest.size()));
    if (name.empty() && is_before_bracket) return word + " is not read; allowed: " + function;
    if (name.size() <= 1 || is_greek_name(name))
      return word + ": is " + function + "(" + rest + ") meant?";
    if (!why_no_symbol(name.substr(1), false, {}).empty())  // sinxcosx
      return word + ": is " + function + "(" + name[0] + ")... meant?";
  }
  const std::size_t bar = word.find('_');
  if (bar != word.npos && is_function(word.substr(0, bar))) return "unknown function " + word;
  const bool has_index = bar != word.npos && !word.ends_with("_prime");
  if (!is_before_bracket || has_index || usual.contains(word) || is_greek_name(word)) return "";
  const std::string unknown = "unknown function " + typed_text(symbol(word));
  if (word.size() == 1)
    return unknown + "; write * for products, " + word + "_n for " + word + "(n)";
  std::string meant = alike(word, factors);
  for (const auto& [function, definition] : definitions())  // SQRT of a spreadsheet
    if (meant.empty()) meant = alike(word, {function});
  return unknown + (meant.empty() ? "" : "; is " + meant + " meant?");
}

cln::cl_RA number_of(const Token& token) {
  const std::size_t end = token.text.find('E');
  std::string digits = "0" + token.text.substr(0, end);
  const std::string power = end == token.text.npos ? "0" : token.text.substr(end + 1);
  int exponent = power.size() > 6 ? largest_exponent + 1 : std::stoi(power);
  if (std::abs(exponent) > largest_exponent) refuse_at(token.column, "an exponent above 10000");
  if (const std::size_t point = digits.find('.'); point != digits.npos) {
    exponent -= int(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return cln::cl_RA(cln::cl_I(digits.c_str())) * cln::expt(cln::cl_RA(10), exponent);
}

Expr negative(Expr e) { return is_matrix(e) ? scaled(-1, e) : -e; }
Expr sum_of(const Exprs& terms, std::size_t column) {
  if (std::ranges::none_of(terms, is_matrix)) return kernel::sum(terms);
  const Expr first = terms[0];
  std::vector<Exprs> parts(first.size());
  for (Expr e : terms) {
    if (is_matrix(e) != is_matrix(first))
      refuse_at(column, "a matrix and a number cannot be added");
    if (e.rows() != first.rows() || e.cols() != first.cols())
      refuse_at(column, "matrices of different shapes");
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].push_back(e.arg(i));
  }
  Exprs out;
  for (const Exprs& part : parts) out.push_back(kernel::sum(part));
  return matrix(first.cols(), out);
}
Expr times(Expr a, Expr b, std::size_t column) {
  if (!is_matrix(a) && !is_matrix(b)) return a * b;
  if (!is_matrix(a)) return scaled(a, b);
  if (!is_matrix(b)) return scaled(b, a);
  if (a.cols() != b.rows()) refuse_at(column, "matrices of these shapes have no product");
  return matrix(b.cols(), entries(kernel::times(a, b)));
}
Expr quotient(Expr a, Expr b, std::size_t column) {
  if (is_matrix(b)) refuse_at(column, "division by a matrix");
  if (b == Expr(0)) refuse_at(column, "division by zero");
  return is_matrix(a) ? scaled(Expr(1) / b, a) : a / b;
}

Expr raised_to(Expr base, Expr exponent, std::size_t column) {
  if (is_matrix(base) || is_matrix(exponent)) refuse_at(column, "a power of a matrix");
  const auto number = rational_value(exponent);
  if (!number) return raised(base, exponent);
  if (cln::denominator(*number) > 1000)
    refuse_at(column, "an exponent that is a fraction with a denominator above 1000");
  if (cln::abs(cln::numerator(*number)) > largest_exponent)
    refuse_at(column, "an exponent with a number above 10000");
  const int above = cln::cl_I_to_int(cln::numerator(*number));
  const int below = cln::cl_I_to_int(cln::denominator(*number));
  if (const auto value = rational_value(base)) {
    if (*value == 0 && above <= 0) refuse_at(column, "a power of 0 that has no value");
    if (bits(*value) * std::size_t(std::abs(above)) > most_bits)
      refuse_at(column, "a number of more than 70000 bits");
  }
  if (above == 0) return 1;
  if (below > 2) return raised(base, Expr(*number));
  const Expr whole = kernel::power(below == 2 ? kernel::sqrt(base) : base, std::abs(above));
  return above > 0 ? whole : Expr(1) / whole;
}

Expr ordered_root(Expr order, Expr x, std::size_t column) {
  const auto value = rational_value(order);
  if (value && *value < 0) return quotient(1, ordered_root(Expr(-*value), x, column), column);
  const bool is_usual = value && *value >= 2 && *value <= 1000 && cln::denominator(*value) == 1;
  if (!is_usual) return raised_to(x, quotient(1, order, column), column);
  return root(cln::cl_I_to_int(cln::numerator(*value)), x);
}
Expr grid_of(const std::vector<Exprs>& rows, std::size_t column) {
  const Expr first = rows[0][0];
  const bool is_stack = is_matrix(first);
  const int cols = is_stack ? first.cols() : int(rows[0].size());
  Exprs all;
  for (const Exprs& row : rows)
    for (Expr e : row) {
      if (is_stack != is_matrix(e))
        refuse_at(column, is_stack ? "a row is written [a, b, c]" : "a matrix inside of a matrix");
      if ((is_stack ? e.cols() : int(row.size())) != cols)
        refuse_at(column, "rows of different lengths");
      std::ranges::copy(is_stack ? entries(e) : Exprs{e}, std::back_inserter(all));
    }
  if (all.size() > 100) refuse_at(column, "a matrix of more than 100 entries");
  return matrix(cols, all);
}

std::optional<cln::cl_RA> rational_value(Expr e) {
  if (e.op() == Op::Num) return e.value();
  if (e.op() == Op::Pow) {
    const auto base = rational_value(e.arg(0));
    if (!base || is_long(*base, e.exponent())) return {};
    return cln::expt(*base, e.exponent());
  }
  if (e.op() != Op::Add && e.op() != Op::Mul && !is_call(e, "inv")) return {};
  const bool is_sum = e.op() == Op::Add;
  cln::cl_RA out = is_sum ? 0 : 1;
  for (Expr arg : e.args()) {
    const auto value = rational_value(arg);
    if (!value || is_long(*value)) return {};
    out = is_sum ? out + *value : out * *value;
  }
  if (!is_call(e, "inv")) return out;
  return out == 0 ? std::nullopt : std::optional(1 / out);
}

Expr symbol(const std::string& name) { return real(std::string(mark) + name); }
std::string name_of(Expr e) {
  return e.op() == Op::Var && e.name().starts_with(mark) ? e.name().substr(mark.size()) : "";
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
  for (Expr v : free_variables(e)) out.insert(name_of(v));
  out.erase("");
  return out;
}
Expr raised(Expr base, Expr exponent) { return apply("raised", {base, exponent}); }
Expr root(int order, Expr x) { return order == 2 ? sqrt(x) : apply("root", {x, Expr(order)}); }
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
