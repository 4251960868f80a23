// SPDX-License-Identifier: GPL-2.0-or-later
// The reader of what people type: one function for each level of binding.
#include "notation/typed.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "notation/operations.hpp"
#include "notation/tokens.hpp"

namespace notation {
using namespace kernel;
namespace {
using Kind = Token::Kind;
constexpr int deepest = 200;
constexpr std::size_t npos = std::string::npos;
const std::string wrong_comma =
    "unexpected comma; decimals are written 0.5, matrices [[a, b], [c, d]]";

class Parser : Words {
public:
  Parser(std::string_view text, const std::set<std::string>& the_factors, bool column)
      : Words(tokens(text)), factors(the_factors), is_column(column) {
    if (words.size() == 1) refuse("the expression is empty");
    part_names();
  }
  Typed whole(bool may_be_equation) {
    const Expr e = expression();
    const Expr right = may_be_equation && takes("=") ? expression() : Expr();
    if (is_relation())
      refuse_at(now().column, "one expression is expected here, without " + now().text);
    expect_end();
    return {e, notes, right};
  }
  std::vector<Comparison> comparisons() {
    std::vector<Comparison> out;
    Expr left = sum();
    while (is_relation()) {
      const std::string relation = words[place++].text;
      const Expr right = sum();
      out.push_back({left, relation, right});
      left = right;
    }
    if (out.empty()) refuse_at(now().column, "a relation is missing, as in 0 < alpha");
    expect_end();
    return out;
  }

private:
  const std::set<std::string>& factors;
  bool is_column;
  int depth = 0;
  int bars = 0;
  std::size_t comma = 0;  // where the last one was
  std::vector<std::string> notes;

  bool is_relation() const {
    static const std::set<std::string> signs{"=", "<", ">", "<=", ">=", "!="};
    return signs.contains(now().text);
  }
  // M_2u_2, as LaTeX has it, becomes two words: a power belongs to the last one.
  void part_names() {
    std::vector<Token> all;
    for (Token word : words) {
      const std::string names = word.text.find('_') == npos ? "" : parted(word.text, factors);
      if (names.find(' ') == npos) {
        all.push_back(word);
        continue;
      }
      note(word.text + " is read as " + names);
      word.typed = "";
      for (std::istringstream each(names); each >> word.text; word.is_spaced = true)
        all.push_back(word);
    }
    words = all;
  }
  void expect_end() const {
    if (now().kind == Kind::End) return;
    if (is(")") || is("}")) refuse_at(now().column, "a ( is missing for this " + now().text);
    if (is(",")) refuse_at(now().column, wrong_comma);
    refuse_at(now().column, "an operator is missing before " + now().text);
  }
  void deeper() {
    if (++depth > deepest) refuse_at(now().column, "nested more than 200 deep");
  }
  void note(const std::string& how) {
    if (std::ranges::find(notes, how) == notes.end()) notes.push_back(how);
  }
  std::string typed(std::size_t from, std::size_t to) const {
    std::string out;
    for (std::size_t i = from; i < to; ++i) {
      const bool are_two =
          i > from && words[i].kind == Kind::Name && words[i - 1].kind != Kind::Sign;
      out += (i > from && words[i].is_spaced) || are_two ? " " : "";
      out += words[i].text;
    }
    return out;
  }
  void close(std::string_view sign, std::size_t opened) {
    if (takes(sign)) return;
    const std::string name(sign);
    if (now().kind == Kind::End) refuse_at(opened, "the " + name + " for this one is missing");
    if (is(",")) refuse_at(now().column, wrong_comma);
    refuse_at(now().column, "unexpected " + now().text + " where " + name + " is expected");
  }

  // A number, or rows as a, b; c, d.
  Expr expression() {
    const std::size_t column = now().column;
    const std::vector<Exprs> all = rows();
    if (all.size() > 1) return grid_of(all, column);
    if (all[0].size() == 1) return all[0][0];
    if (!is_column) refuse_at(comma, wrong_comma);
    if (depth == 0) refuse("a column is written with semicolons: [a; b; c]");
    return matrix(1, entries(grid_of(all, column)));
  }
  Expr sum() {
    Expr e = term();
    Exprs terms{e};
    while (is("+") || is("-")) {
      const std::size_t column = now().column;
      const bool minus = words[place++].text == "-";
      const Expr next = minus ? negative(term()) : term();
      if (is_matrix(next) != is_matrix(e))
        refuse_at(column, "a matrix and a number cannot be added");
      if (is_matrix(e)) e = added(e, next, column);
      terms.push_back(next);
    }
    return is_matrix(e) || terms.size() == 1 ? e : kernel::sum(terms);
  }

  bool starts_factor() const {
    if (is("|")) return bars == 0;
    return now().kind == Kind::Name || now().kind == Kind::Number || is("(") || is("{") ||
           is("[") || now().kind == Kind::Command;
  }
  // 2 of 2\frac{19}{64}: a mixed number to some, a product to others.
  void refuse_mixed(std::size_t from) const {
    const bool mixed = place == from + 1 && words[from].kind == Kind::Number &&
                       now().kind == Kind::Command && now().text == "frac" &&
                       place + 6 < words.size() && words[place + 2].kind == Kind::Number &&
                       words[place + 5].kind == Kind::Number;
    if (!mixed) return;
    const std::string number = words[from].text;
    const std::string part = words[place + 2].text + "/" + words[place + 5].text;
    refuse_at(now().column,
              "a sum or a product? write " + number + " + " + part + " or " + number + "*" + part);
  }
  Expr term() {
    std::size_t from = place;  // of the quotient that was read last
    while (words[from].text == "+" || words[from].text == "-") ++from;
    std::size_t slash = 0;
    Expr e = signed_factor();
    for (;;) {
      if (is("*") || is("/")) {
        const std::size_t column = now().column;
        const bool divides = words[place++].text == "/";
        slash = divides ? place - 1 : 0;
        e = divides ? quotient(e, signed_factor(), column) : times(e, signed_factor(), column);
      } else if (starts_factor()) {
        if (now().kind == Kind::Number)
          refuse_at(now().column, "an operator is missing before " + now().text);
        refuse_mixed(from);
        if (slash != 0 && !is_matrix_ahead()) read_after_slash(from, slash);
        slash = 0;
        e = times(e, power(), now().column);
      } else {
        return e;
      }
    }
  }
  // 1/2 M_1, L/V sin(...) and a/(b)^2 (c) have one usual reading; 1/2(1+alpha) and a/b c have two.
  void read_after_slash(std::size_t from, std::size_t slash) {
    const bool numbers = slash == from + 1 && place == slash + 2 &&
                         words[from].kind == Kind::Number && words[slash + 1].kind == Kind::Number;
    const bool is_power = words[place - 2].text == "^";
    const bool brackets =
        words[slash + 1].text == "(" && words[is_power ? place - 3 : place - 1].text == ")";
    if (!now().is_spaced || (!numbers && !brackets && !is_call_ahead()))
      refuse_at(now().column,
                "is " + now().text + " above or below the fraction line? write a * or parentheses");
    const std::string left = typed(from, place);
    note(left + " " + now().text + "... is read as (" + left + ")*" + now().text + "...");
  }

  Expr signed_factor() {
    bool minus = false;
    while (is("+") || is("-")) minus = minus != (words[place++].text == "-");
    return minus ? negative(power()) : power();
  }
  Expr power() {
    const Expr base = primary();
    const std::size_t column = now().column;
    if (!takes("^")) return base;
    deeper();
    const Expr exponent = signed_factor();
    --depth;
    if (!free_variables(exponent).empty()) note_base(base);
    return raised_to(base, exponent, column);
  }
  void note_base(Expr e) {  // e^x, log(e)
    if (name_of(e) == "e")
      note("e is read as the coefficient of restitution; the exponential function is exp(x)");
  }
  Expr primary() {
    deeper();
    const Expr e = operand();
    --depth;
    return e;
  }
  // A number, a name, a function of something, or what is in brackets.
  Expr operand() {
    const Token token = now();
    if (token.kind == Kind::End) refuse_at(token.column, "the expression ends too early");
    ++place;
    if (token.kind == Kind::Number) return Expr(number_of(token));
    if (token.kind == Kind::Name) return name(token);
    if (token.kind == Kind::Command) return command(token);
    if (token.text == "(" || token.text == "{") return inside(token);
    if (token.text == "[") return grid(token);
    if (token.text == "|") {
      ++bars;
      const Expr e = sum();
      close("|", token.column);
      --bars;
      return notation::call("abs", e);
    }
    refuse_at(token.column, "unexpected " + token.text);
  }
  Expr inside(const Token& opened) {
    const int outer = std::exchange(bars, 0);
    const Expr e = expression();
    bars = outer;
    close(opened.text == "(" ? ")" : "}", opened.column);
    return e;
  }
  // {a + b}, or the one character that LaTeX takes.
  Expr group() {
    const Token token = now();
    if (token.kind == Kind::Number && token.text.size() > 1) {  // \frac12
      words[place].text = token.text.substr(1);
      return Expr(int(token.text[0] - '0'));
    }
    return primary();
  }
  Expr command(const Token& token) {
    if (token.text == "frac") {
      const Expr above = group();
      return quotient(above, group(), token.column);
    }
    if (!takes("[")) return kernel::sqrt(group());
    const Expr order = sum();
    close("]", token.column);
    return ordered_root(order, group(), token.column);
  }
  // [[a, b], [c, d]] or [a, b; c, d], and \begin{pmatrix} a & b \\ c & d \end{pmatrix}
  Expr grid(const Token& token) {
    std::vector<Exprs> all;
    if (!is("[")) all = rows();
    while (all.empty() || takes(",") || takes(";")) {
      const std::size_t column = now().column;
      if (!takes("[")) refuse_at(column, "a row is written [a, b, c]");
      std::ranges::copy(rows(), std::back_inserter(all));
      close("]", column);
    }
    close("]", token.column);
    return grid_of(all, token.column);
  }
  std::vector<Exprs> rows() {
    std::vector<Exprs> out{list()};
    while (takes(";"))
      if (!is("]")) out.push_back(list());
    return out;
  }
  Exprs list() {
    Exprs out{sum()};
    while (is(",")) {
      comma = words[place++].column;
      out.push_back(sum());
    }
    return out;
  }
  bool is_factor(const std::string& name) const {
    static const std::set<std::string> usual{"x", "y", "z", "t", "u", "V", "L",
                                             "M", "m", "e", "n", "k", "j"};
    return factors.contains(name) || usual.contains(name) || is_greek_name(name) ||
           (name.find('_') != name.npos && !name.ends_with("_prime"));
  }
  Expr name(const Token& token) {
    const std::string& word = token.text;
    if (is_function(word) || has_base(word)) return function(token);
    if (word == "pi" || word == "Pi" || word == "PI") return kernel::pi();
    if (const std::string meant = hidden_function(word); !meant.empty() && !factors.contains(word))
      refuse_at(token.column, word + ": is " + meant + " meant?");
    if (!factors.contains(word)) refuse_function(token);
    if (word == "i" && !factors.contains(word)) note("i is read as a real number of its own");
    if (!token.typed.empty()) note(token.typed + " is read as " + word);
    const bool is_word = word.size() > 1 && word.find('_') == word.npos && !is_greek_name(word);
    const std::string product = word.size() == 2 ? word.substr(0, 1) + "*" + word[1] : "with *";
    if (is_word && !factors.contains(word))
      note(word + " is read as one name; a product is written " + product);
    return symbol(word);
  }
  // sin_2 and f(x): no functions here.
  void refuse_function(const Token& token) const {
    static const std::set<std::string> rounding{"ceil", "floor", "round", "trunc", "int"};
    const std::string& word = token.text;
    const std::size_t mark = word.find('_');
    const std::string stem = word.substr(0, mark);
    if (mark != word.npos && is_function(stem)) refuse_at(token.column, "unknown function " + word);
    if (!is("(") || is_factor(word)) return;
    if (rounding.contains(word))
      refuse_at(token.column, word + ": there are no rounding functions here");
    std::string meant = alike(word, factors);
    std::string small = word;
    for (char& c : small) c = char(c | 0x20);
    if (meant.empty() && is_function(small)) meant = small;  // SQRT of a spreadsheet
    std::string hint = meant.empty() ? "" : "; is " + meant + " meant?";
    if (word.size() == 1) hint = "; write * for a product, and " + word + "_n for " + word + "(n)";
    refuse_at(token.column, "unknown function " + typed_text(symbol(word)) + hint);
  }
  // Of the brackets that begin here.
  bool has_comma_ahead() const {
    int open = 0;
    for (std::size_t i = place; i < words.size(); ++i) {
      const std::string& text = words[i].text;
      open += text == "(" ? 1 : text == ")" ? -1 : 0;
      if (open == 0) return false;
      if (open == 1 && text == ",") return true;
    }
    return false;
  }
  bool is_matrix_ahead() const {  // which is never below a line
    return is("[") || has_comma_ahead();
  }
  bool is_call_ahead() const { return now().kind == Kind::Name && is_function(now().text); }
  Expr function(const Token& token) {
    const std::size_t column = now().column;
    Expr exponent;
    if (takes("^")) {  // sin^2(x)
      exponent = signed_factor();
      const auto value = rational_value(exponent);
      if (!value || *value < 1 || cln::denominator(*value) != 1)
        refuse_at(column, token.text + "^-1 has two readings: write " +
                              (is_function("a" + token.text)
                                   ? "a" + token.text + "(x) for the inverse function, "
                                   : "") +
                              "1/" + token.text + "(x) for the quotient");
    }
    const Expr value = token.text == "root"   ? root_call(token)
                       : has_base(token.text) ? logarithm_to_base(token)
                                              : applied(token.text, argument(token));
    if (value == call("log", symbol("e"))) note_base(value.arg(0));
    return exponent ? raised_to(value, exponent, column) : value;
  }
  Expr root_call(const Token& token) {
    const Exprs args = takes("(") ? list() : Exprs();
    if (args.size() != 2) refuse_at(now().column, "write root(x, n)");
    close(")", token.column);
    return ordered_root(args[1], args[0], token.column);
  }
  // log_2(8), log2(8)
  bool has_base(const std::string& word) const {
    return word.starts_with("log_") || ((word == "log2" || word == "log10") && is("("));
  }
  Expr logarithm_to_base(Token token) {
    const std::string base = token.text.substr(token.text[3] == '_' ? 4 : 3);
    const bool is_number = base.find_first_not_of("0123456789") == npos;
    const bool is_name = base.size() == 1 || is_greek_name(base) || factors.contains(base);
    const bool is_decimal = now().kind == Kind::Number && now().text[0] == '.';
    if ((!is_number && !is_name) || is_decimal)
      refuse_at(token.column, "unknown function " + token.text +
                                  "; write log(x)/log(b) for the logarithm to base b");
    note(token.text + " is read as the logarithm to base " + base);
    token.text = "log";
    const Expr x = argument(token);
    token.text = base;
    return logarithm(x, is_number ? Expr(number_of(token)) : name(token), token.column);
  }
  // What a function is taken of. Without brackets: cos theta, \cos n\psi, sin 2 x, sqrt 2.
  Expr argument(const Token& token) {
    if (is("(") || is("{")) {
      const Token opened = words[place++];
      const Expr e = inside(opened);
      if (is_matrix(e)) refuse_at(opened.column, token.text + " of a matrix");
      return e;
    }
    if (now().kind == Kind::Command || is("|") || is_call_ahead()) return primary();
    if (now().kind != Kind::Name && now().kind != Kind::Number)
      refuse_at(now().column, "a ( is missing after " + token.text);
    const std::size_t from = place;
    const bool is_root = token.text == "sqrt" || token.text == "cbrt";
    Expr e = primary();
    const bool many = token.is_latex || words[from].kind == Kind::Number;
    while (!is_root && many && now().kind == Kind::Name && !is_call_ahead() &&
           (token.is_latex || place == from + 1))
      e = e * primary();
    const std::string taken = typed(from, place);
    const bool goes_on = (starts_factor() && !is_call_ahead()) || is("^") || (is("/") && !is_root);
    if (goes_on)
      refuse_at(now().column, token.text + " " + typed(from, place + 1) +
                                  "... has two readings: write " + token.text + "(" +
                                  typed(from, place + 1) + "...) or " + token.text + "(" + taken +
                                  ")" + now().text + "...");
    if (place > from + 1)
      note(token.text + " " + taken + " is read as " + token.text + "(" + taken + ")");
    return e;
  }
};
}  // namespace

Typed read_typed(std::string_view text, const std::set<std::string>& factors) {
  return Parser(text, factors, false).whole(false);
}
Typed read_equation(std::string_view text, const std::set<std::string>& factors, bool is_column) {
  return Parser(text, factors, is_column).whole(true);
}
std::vector<Comparison> read_comparisons(std::string_view text) {
  return Parser(text, {}, false).comparisons();
}
}  // namespace notation
