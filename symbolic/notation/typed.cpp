// The reader of what people type: one function for each level of binding.
#include "notation/typed.hpp"

#include "notation/readings.hpp"

namespace notation {
using namespace kernel;
namespace {
class Parser : Readings {
public:
  Parser(std::string_view text, const std::set<std::string>& the_factors, bool column, Expr of = {})
      : Readings(text, the_factors), is_column(column), x(of) {
    if (words.size() == 1) refuse("the expression is empty");
    part_names();
  }
  Typed whole(bool may_be_equation) {
    const Expr e = expression();
    const Expr right = may_be_equation && takes("=") ? expression() : Expr();
    if (is_relation()) refuse_here("one expression is expected here, without " + now().text);
    expect_end();
    return {e, notes, right};
  }
  std::vector<Comparison> comparisons(std::vector<std::string>* said) {
    std::vector<Comparison> out;
    Expr left = sum();
    while (is_relation()) {
      const std::string relation = next().text;
      const std::size_t from = place;
      out.push_back({left, relation, sum()});
      left = out.back().right;
      if (is_relation()) refuse_two_conditions(from);
    }
    if (out.empty()) refuse_here("a relation is missing, as in 0 < alpha");
    expect_end();
    if (said) said->insert(said->end(), notes.begin(), notes.end());
    return out;
  }

private:
  bool is_column;
  Expr x;  // in a function's definition
  int depth = 0, bars = 0;
  std::size_t comma = 0;  // the last one

  void expect_end() const {
    if (now().kind == Kind::End) return;
    if (is(")") || is("}")) refuse_here("a ( is missing for this " + now().text);
    if (is(",")) refuse_comma(place);
    refuse_here("an operator is missing before " + now().quoted);
  }
  Expr nested(Expr (Parser::*part)()) {
    if (++depth > 200) refuse_here("nested more than 200 deep");
    const Expr e = (this->*part)();
    --depth;
    return e;
  }
  void close(const std::string& sign, std::size_t opened) {
    if (takes(sign)) return;
    if (now().kind == Kind::End) refuse_at(opened, "the " + sign + " for this one is missing");
    if (is(",")) refuse_comma(place);
    refuse_here("unexpected " + now().quoted + " where " + sign + " is expected");
  }

  // A number, or rows as a, b; c, d.
  Expr expression() {
    const std::size_t column = now().column;
    const std::vector<Exprs> all = rows();
    if (all.size() > 1) return grid_of(all, column);
    if (all[0].size() == 1) return all[0][0];
    if (!is_column) refuse_comma(comma);
    if (depth == 0) refuse("a column is written with semicolons: [a; b; c]");
    return matrix(1, entries(grid_of(all, column)));
  }
  std::vector<Exprs> rows() {
    std::vector<Exprs> out{list()};
    while (takes(";"))
      if (!is("]")) out.push_back(list());
    return out;
  }
  Exprs list() {
    Exprs out{sum()};
    while (takes(",")) {
      comma = place - 1;
      out.push_back(sum());
    }
    return out;
  }
  Expr sum() {
    const std::size_t column = now().column;
    Exprs terms{term()};
    while (is("+") || is("-")) terms.push_back(next().text == "-" ? negative(term()) : term());
    return sum_of(terms, column);
  }

  bool starts_factor() const {
    if (now().kind != Kind::Sign) return now().kind != Kind::End;
    return is("(") || is("{") || is("[") || (is("|") && bars == 0);
  }
  Expr term() {
    std::size_t from = place;
    while (words[from].text == "+" || words[from].text == "-") ++from;
    std::size_t slash = 0;
    Expr e = signed_factor();
    for (;;) {
      const Token& sign = now();
      if (takes("*")) {
        slash = 0;
        e = times(e, signed_factor(), sign.column);
      } else if (takes("/")) {
        slash = place - 1;
        note_fraction_after_power();
        e = quotient(e, signed_factor(), sign.column);
      } else if (starts_factor()) {
        if (sign.kind == Kind::Number) refuse_here("an operator is missing before " + sign.text);
        if (is_remark()) refuse_here("a remark or a factor? leave it out, or write a *");
        if (is("|")) refuse_bars(from);
        const std::size_t there = place;
        const Expr factor = power();
        if (slash != 0 && !is_matrix(factor)) read_after_slash(from, slash, there);
        slash = 0;
        e = times(e, factor, now().column);
      } else {
        return e;
      }
    }
  }
  Expr signed_factor() {
    bool minus = false;
    while (is("+") || is("-")) minus = minus != (next().text == "-");
    return minus ? negative(power()) : power();
  }
  Expr power() {
    const std::size_t from = place;
    const Expr base = primary();
    const std::size_t column = now().column;
    if (!takes("^")) return base;
    const Expr exponent = nested(&Parser::signed_factor);
    if (from > 1 && words[from - 1].text == "^")  // x^y^z
      note(typed(from - 1, place) + " is read as ^(" + typed(from, place) + ")");
    if (is_matrix(base) && exponent == symbol("T")) {  // (a, b) is a column already
      std::size_t inner = from;
      while (words[inner].text == "(") ++inner;
      const bool is_list = base.cols() == 1 && inner > from && words[inner].text != "[";
      return is_list ? base : matrix(base.rows(), entries(transpose(base)));
    }
    return raised_to(base, exponent, column);
  }
  Expr primary() { return nested(&Parser::operand); }
  // A number, a name, a function of something, or what is in brackets.
  Expr operand() {
    if (now().kind == Kind::End) refuse_here("the expression ends too early");
    const Token& token = next();
    if (token.kind == Kind::Number) return Expr(number_of(token));
    if (token.kind == Kind::Name) return name(token);
    if (token.kind == Kind::Command) return command(token);
    if (token.text == "(" || token.text == "{" || token.text == "[") return inside(token);
    if (token.text != "|") refuse_at(token.column, "unexpected " + token.quoted);
    ++bars;
    const Expr e = sum();
    close("|", token.column);
    --bars;
    if (is_matrix(e)) refuse_at(token.column, "abs of a matrix");
    return notation::call("abs", e);
  }
  Expr inside(const Token& opened) {
    const int outer = std::exchange(bars, 0);
    Expr e = opened.text == "[" ? square(opened) : expression();
    if (opened.text == "{" && takes("over")) e = quotient(e, expression(), opened.column);
    bars = outer;
    close(opened.text == "[" ? "]" : opened.text == "(" ? ")" : "}", opened.column);
    return e;
  }
  // A matrix, or brackets round brackets; the [a] in [[a], [b]] is a row.
  Expr square(const Token& opened) {
    const std::string before = place > 1 ? words[place - 2].text : "";
    const std::vector<Exprs> all = rows();
    const std::string after = is("]") ? words[place + 1].text : "";
    const bool is_row = (before == "[" || before == ",") && (after == "," || after == "]");
    const bool is_one = all.size() == 1 && all[0].size() == 1 && !is_matrix(all[0][0]);
    return is_one && !is_row ? all[0][0] : grid_of(all, opened.column);
  }
  // {a + b}, or the one character that LaTeX takes.
  Expr group() {
    std::string& text = words[place].text;
    if (now().kind != Kind::Number || text.size() == 1) return primary();
    const char first = text[0];  // \frac12
    text.erase(0, 1);
    return Expr(int(first - '0'));
  }
  Expr command(const Token& token) {
    if (token.text == "frac") return fraction(token);
    if (!takes("[")) return kernel::sqrt(group());
    const Expr order = sum();
    close("]", token.column);
    return ordered_root(order, group(), token.column);
  }
  // 2\frac{19}{64}: a mixed number to some, a product to others.
  Expr fraction(const Token& token) {
    const bool is_power = place > 2 && words[place - 3].text == "^";
    const Token before = place > 1 && !is_power ? words[place - 2] : Token();
    const Expr above = group(), below = group();
    if (before.kind == Kind::Number && above.op() == Op::Num && below.op() == Op::Num) {
      const std::string part = digits(above.value()) + "/" + digits(below.value());
      refuse_at(token.column, "a sum or a product? write " + before.text + " + " + part + " or " +
                                  before.text + "*" + part);
    }
    return quotient(above, below, token.column);
  }

  Expr name(const Token& token) {
    const std::string& word = token.text;
    if (is_function(word) || has_base(word)) return function(token);
    if (word == "x" && x) return x;
    if (word == "pi" || word == "Pi" || word == "PI") return kernel::pi();
    const std::string why = why_no_symbol(word, is("("), factors);
    if (!why.empty()) refuse_at(token.column, why);
    if (!token.typed.empty()) note(token.typed + " is read as " + typed_text(symbol(word)));
    if (factors.contains(word)) return symbol(word);
    if (word == "e")
      note("e is read as the coefficient of restitution; the exponential function is exp(x)");
    if (word == "i") note("i is read as a real number of its own");
    if ((word == "zeta" || word == "Gamma") && is("("))
      note(word + "(...) is read as a product, " + word + "*(...)");
    const std::string product = word.size() == 2 ? word.substr(0, 1) + "*" + word[1] : "with *";
    const std::string index = word.substr(word.find('_') + 1);
    const bool runs_on = index == word || (is_whole(index.substr(0, 1)) && !is_whole(index));
    if (word.size() > 1 && runs_on && !is_greek_name(word))
      note(word + " is read as one name; a product is written " + product);
    return symbol(word);
  }
  Expr function(Token token) {
    const std::size_t column = now().column, from = place - 1;
    Expr exponent;
    if (takes("^")) {  // sin^2(x)
      exponent = signed_factor();
      const auto value = rational_value(exponent);
      const std::string inverse = "a" + token.text;
      if (value && *value == -1 && is_function(inverse)) {
        note(typed(from, place) + " is read as " + inverse);
        token.text = token.quoted = inverse;
        exponent = {};
      } else if (!value || *value < 1 || cln::denominator(*value) != 1) {
        refuse_at(column, "write (" + token.text + "(x))" + typed(from + 1, place));
      }
    }
    const Expr value = token.text == "root"   ? root_call(token)
                       : has_base(token.text) ? logarithm_to_base(token)
                                              : applied(token.text, argument(token));
    if (token.text == "log") note("log is read as the natural logarithm");
    return exponent ? raised_to(value, exponent, column) : value;
  }
  Expr applied(const std::string& function, Expr of) const {
    const std::string& definition = definition_of(function);
    return definition.empty() ? call(function, of) : Parser(definition, {}, false, of).sum();
  }
  Expr root_call(const Token& token) {
    const Exprs args = takes("(") ? list() : Exprs();
    if (args.size() != 2) refuse_here("write root(x, n)");
    close(")", token.column);
    return ordered_root(args[1], args[0], token.column);
  }
  // log_2(8), log2(8)
  bool has_base(const std::string& word) const {
    return word.starts_with("log_") || ((word == "log2" || word == "log10") && is("("));
  }
  Expr logarithm_to_base(Token token) {
    const std::string base = token.text.substr(token.text[3] == '_' ? 4 : 3);
    const bool is_short = base.size() == 1 || is_greek_name(base) || factors.contains(base);
    const bool is_decimal = now().kind == Kind::Number && now().text[0] == '.';
    if ((!is_whole(base) && !is_short) || is_decimal)
      refuse_at(token.column, "unknown function " + token.text +
                                  "; write log(x)/log(b) for the logarithm to base b");
    note(token.text + " is read as the logarithm to base " + base);
    token.text = "log";
    const Expr above = call("log", argument(token));
    token.text = base;
    const Expr b = is_whole(base) ? Expr(number_of(token)) : name(token);
    if (b == Expr(1)) refuse_at(token.column, "there is no logarithm to base 1");
    return above / call("log", b);
  }
  // What a function is taken of. Without brackets: cos theta, \cos n\psi, sin 2 x, sin ½(x+1)y.
  Expr argument(const Token& token) {
    const std::size_t from = place;
    const bool is_half = is("(") && words[from + 1].quoted.empty();
    const bool is_bracket = !is_half && now().kind == Kind::Sign && !is("|");
    const bool is_of_call = is_call(now()) || now().text == "sqrt";
    const bool is_term = now().kind == Kind::Command || is("|") || is_of_call;
    const bool is_root = token.text == "sqrt" || token.text == "cbrt";
    const std::string& f = token.quoted;
    if (!starts_factor() && !is("|")) refuse_here("a ( is missing after " + f);
    Expr e = is_bracket ? inside(next()) : primary();
    const std::size_t first = place;
    const bool is_fraction = is_half || (words[from].text == "frac" && e.op() == Op::Num);
    const bool is_index = words[from].kind == Kind::Name && is_of_indices(e);  // cos nψ
    const bool is_number = is_fraction || is_index || words[from].kind == Kind::Number;
    const bool many = !is_root && !is_bracket && (is_number || (token.is_latex && !is_term));
    if (many && is_fraction && (is("(") || now().kind == Kind::Command))
      e = times(e, primary(), now().column);
    while (many && is_name() && (token.is_latex || place == first))
      e = times(e, primary(), now().column);
    if (is_matrix(e)) refuse_at(words[from].column, f + " of a matrix");
    const std::string taken = typed(from, place), more = typed(from, place + 1);
    if (is_bracket && !is_root) read_after_bracket(token, taken, e);
    if (is_bracket) return e;
    const bool is_alone = token.is_latex && !(is_number && place == first);
    const bool is_product = is("*") && !is_alone && !is_call(words[place + 1]);
    const bool goes_on = !is_root && (is("/") || is_product);
    const bool is_root_next = is_of_call && now().text == "sqrt";  // arctan √m √M
    const bool has_factor = starts_factor() && (!is_call(now()) || is_root_next);
    if (is("^") || ((goes_on || has_factor) && (!is_term || is_of_call || is_fraction)))
      refuse_here(f + " " + more + "... has two readings: write " + f + "(" + more + "...) or " +
                  f + "(" + taken + ")" + now().quoted + "...");
    if (words[from].text == "frac" && has_factor)  // \sin\frac{x}{2}y
      note(f + " " + more + "... is read as " + f + "(" + taken + ")*" + now().quoted + "...");
    if (place > first) note(f + " " + taken + " is read as " + f + "(" + taken + ")");
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
std::vector<Comparison> read_comparisons(std::string_view text, std::vector<std::string>* notes) {
  return Parser(text, {"e"}, false).comparisons(notes);
}
}  // namespace notation
