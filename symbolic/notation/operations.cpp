// SPDX-License-Identifier: GPL-2.0-or-later
#include "notation/operations.hpp"

#include <functional>
#include <map>
#include <sstream>

#include <cln/integer_io.h>
#include <cln/rational.h>

#include "notation/typed.hpp"

namespace notation {
using namespace kernel;
namespace {
constexpr int largest_exponent = 10000;
constexpr std::size_t most_bits = 70000;

// e^x + e^-x and e^x - e^-x
Expr sum_of_two(Expr x) { return call("exp", x) + call("exp", -x); }
Expr difference_of_two(Expr x) { return call("exp", x) - call("exp", -x); }
using Function = std::function<Expr(Expr)>;
const std::map<std::string, Function>& functions() {
  static const auto table = [] {
    std::map<std::string, Function> all{
        {"cbrt", [](Expr x) { return root(3, x); }},
        {"tan", [](Expr x) { return kernel::sin(x) / kernel::cos(x); }},
        {"sec", [](Expr x) { return Expr(1) / kernel::cos(x); }},
        {"csc", [](Expr x) { return Expr(1) / kernel::sin(x); }},
        {"cot", [](Expr x) { return kernel::cos(x) / kernel::sin(x); }},
        {"sinh", [](Expr x) { return difference_of_two(x) / Expr(2); }},
        {"cosh", [](Expr x) { return sum_of_two(x) / Expr(2); }},
        {"tanh", [](Expr x) { return difference_of_two(x) / sum_of_two(x); }},
        {"csch", [](Expr x) { return Expr(2) / difference_of_two(x); }},
        {"sech", [](Expr x) { return Expr(2) / sum_of_two(x); }},
        {"asinh", [](Expr x) { return call("log", x + kernel::sqrt(power(x, 2) + 1)); }},
        {"acosh", [](Expr x) { return call("log", x + kernel::sqrt(power(x, 2) - 1)); }},
        {"atanh", [](Expr x) { return call("log", (1 + x) / (1 - x)) / Expr(2); }},
        {"coth", [](Expr x) { return sum_of_two(x) / difference_of_two(x); }},
    };
    for (const std::string name :
         {"sqrt", "abs", "sin", "cos", "asin", "acos", "atan", "exp", "log"})
      all.emplace(name, [name](Expr x) { return call(name, x); });
    std::istringstream others(
        "arcsin asin arccos acos arctan atan arctg atan tg tan ctg cot cosec csc ln log arsinh "
        "asinh arcosh acosh "
        "artanh atanh arcsinh asinh arccosh acosh arctanh atanh");
    for (std::string other, name; others >> other >> name;) all.emplace(other, all.at(name));
    return all;
  }();
  return table;
}
Expr scaled(Expr scalar, Expr grid) {
  Exprs out;
  for (Expr e : entries(grid)) out.push_back(scalar * e);
  return matrix(grid.cols(), out);
}
}  // namespace

std::size_t bits(const cln::cl_RA& q) {
  return cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
}

bool is_function(const std::string& name) { return name == "root" || functions().contains(name); }

std::string hidden_function(const std::string& name) {
  for (const auto& [function, make] : functions()) {
    if (!name.starts_with(function) || name == function) continue;
    const std::string rest = name.substr(function.size());
    if (rest.size() == 1 || is_greek_name(rest) ||
        rest.find_first_not_of("0123456789") == rest.npos)
      return function + "(" + rest + ")";
  }
  return "";
}

Expr applied(const std::string& name, Expr x) { return functions().at(name)(x); }

cln::cl_RA number_of(const Token& token) {
  const std::size_t mark = token.text.find('E');
  std::string digits = token.text.substr(0, mark);
  if (digits.size() > 20000) refuse_at(token.column, "a number of more than 20000 digits");
  const std::string word = mark == token.text.npos ? "0" : token.text.substr(mark + 1);
  int exponent = word.size() > 6 ? largest_exponent + 1 : std::stoi(word);
  if (std::abs(exponent) > largest_exponent) refuse_at(token.column, "an exponent above 10000");
  if (const std::size_t point = digits.find('.'); point != digits.npos) {
    exponent -= int(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return cln::cl_RA(cln::cl_I(("0" + digits).c_str())) * cln::expt(cln::cl_RA(10), exponent);
}

Expr negative(Expr e) { return is_matrix(e) ? scaled(-1, e) : -e; }
Expr added(Expr a, Expr b, std::size_t column) {
  if (a.rows() != b.rows() || a.cols() != b.cols())
    refuse_at(column, "matrices of different shapes");
  Exprs out = entries(a);
  const Exprs more = entries(b);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = out[i] + more[i];
  return matrix(a.cols(), out);
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
  if (bits(*number) > 40 || cln::abs(cln::numerator(*number)) > largest_exponent ||
      cln::denominator(*number) > 1000)
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
  const Expr root = below == 2 ? kernel::sqrt(base) : base;
  const int size = std::abs(above);
  const Expr whole = size == 1 ? root : kernel::power(root, size);
  return above > 0 ? whole : Expr(1) / whole;
}

Expr ordered_root(Expr order, Expr x, std::size_t column) {
  const auto value = rational_value(order);
  if (value && *value < 0) return quotient(1, ordered_root(Expr(-*value), x, column), column);
  const bool is_usual = value && *value >= 2 && *value <= 1000 && cln::denominator(*value) == 1;
  if (!is_usual) return raised_to(x, quotient(1, order, column), column);
  return root(cln::cl_I_to_int(cln::numerator(*value)), x);
}
Expr logarithm(Expr x, Expr base, std::size_t column) {
  if (is_matrix(x) || is_matrix(base)) refuse_at(column, "log of a matrix");
  if (base == Expr(1)) refuse_at(column, "there is no logarithm to base 1");
  return call("log", x) / call("log", base);
}

Expr grid_of(const std::vector<Exprs>& rows, std::size_t column) {
  Exprs all;
  for (const Exprs& row : rows) {
    if (row.size() != rows[0].size()) refuse_at(column, "rows of different lengths");
    all.insert(all.end(), row.begin(), row.end());
  }
  for (Expr e : all)
    if (is_matrix(e)) refuse_at(column, "a matrix inside of a matrix");
  if (all.size() > 100) refuse_at(column, "a matrix of more than 100 entries");
  return matrix(int(rows[0].size()), all);
}
}  // namespace notation
