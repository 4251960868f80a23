// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/parse.hpp"

#include <algorithm>

#include "equality/arithmetic.hpp"
#include "equality/paper_names.hpp"

namespace magicmass::equality {
namespace {

using TokenKind = Token::Kind;

constexpr std::size_t longest_name = 40;

bool is_function_name(const std::string& name) {
  const auto& names = function_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string allowed_functions() {
  std::string list;
  for (const std::string& name : function_names()) list += (list.empty() ? "" : " ") + name;
  return list;
}

// x(...) is a product where x cannot be meant as a function.
bool is_certainly_no_function(const std::string& name) {
  return name == "pi" || name == "Pi" || name == "PI" || is_paper_name(name) || name == "x" ||
         name == "y" || name == "z";
}

class Parser {
public:
  Parser(std::string_view text, const Limits& limits)
      : limits_(limits), arithmetic_(limits), tokens_(tokens(text, limits.characters)) {
    if (tokens_.size() == 1) throw NotAnExpression("the expression is empty");
  }

  Tree whole() {
    const Tree tree = sum();
    if (is_sign("=") || is_sign("<") || is_sign(">") || is_sign("<=") || is_sign(">=") ||
        is_sign("!="))
      refuse_at(now().column, "one expression is expected here, without " + now().text);
    expect_end();
    return tree;
  }

  std::vector<Comparison> comparisons() {
    std::vector<Comparison> result;
    Tree left = sum();
    while (is_sign("<") || is_sign(">") || is_sign("<=") || is_sign(">=") || is_sign("!=") ||
           is_sign("=")) {
      const std::string relation = now().text;
      ++at_;
      const Tree right = sum();
      result.push_back({left, relation, right});
      left = right;
    }
    if (result.empty()) refuse_at(now().column, "a relation is missing, as in 0 < alpha");
    expect_end();
    return result;
  }

private:
  const Token& now() const { return tokens_[at_]; }
  const Token& next() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  bool is_sign(const char* sign) const {
    return now().kind == TokenKind::sign && now().text == sign;
  }
  bool accept(const char* sign) {
    if (!is_sign(sign)) return false;
    ++at_;
    return true;
  }

  void expect_end() const {
    if (now().kind == TokenKind::end) return;
    if (is_sign(")")) refuse_at(now().column, "a ( is missing for this )");
    if (is_sign(",")) refuse_at(now().column, "unexpected comma; decimals are written 0.5");
    refuse_at(now().column, "an operator is missing before " + now().text);
  }

  class Deeper {  // counts nesting while it lives
  public:
    explicit Deeper(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > parser_.limits_.nesting)
        refuse_at(parser_.now().column,
                  "nested more than " + std::to_string(parser_.limits_.nesting) + " deep");
    }
    Deeper(const Deeper&) = delete;
    Deeper(Deeper&&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    Deeper& operator=(Deeper&&) = delete;
    ~Deeper() { --parser_.depth_; }

  private:
    Parser& parser_;
  };

  Tree sum() {
    const std::size_t column = now().column;
    std::vector<Tree> terms{term()};
    while (is_sign("+") || is_sign("-")) {
      const bool minus = is_sign("-");
      ++at_;
      const Tree next_term = term();
      terms.push_back(minus ? arithmetic_.product({number(-1), next_term}, {}, column) : next_term);
    }
    return terms.size() == 1 ? terms[0] : arithmetic_.sum(terms, column);
  }

  bool starts_factor() const {
    return now().kind == TokenKind::name || is_sign("(") || now().kind == TokenKind::number;
  }

  Tree term() {
    const std::size_t column = now().column;
    std::vector<Tree> above{signed_factor()};
    std::vector<Tree> below;
    for (;;) {
      if (accept("*")) {
        above.push_back(signed_factor());
      } else if (is_sign("/")) {
        const std::size_t slash = now().column;
        ++at_;
        below.push_back(signed_factor());
        if (is_number(below.back(), 0)) refuse_at(slash, "division by zero");
        if (starts_factor() && now().kind != TokenKind::number)
          refuse_at(
              now().column,
              "is " + now().text + " above or below the fraction line? write a * or parentheses");
      } else if (starts_factor()) {
        if (now().kind == TokenKind::number)
          refuse_at(now().column, "an operator is missing before " + now().text);
        above.push_back(power());
      } else {
        break;
      }
    }
    if (above.size() == 1 && below.empty()) return above[0];
    return arithmetic_.product(above, below, column);
  }

  Tree signed_factor() {
    const std::size_t column = now().column;
    bool minus = false;
    while (is_sign("+") || is_sign("-")) {
      minus = minus != is_sign("-");
      ++at_;
    }
    const Tree factor = power();
    return minus ? arithmetic_.product({number(-1), factor}, {}, column) : factor;
  }

  Tree power() {
    const Deeper deeper(*this);
    const Tree base = primary();
    const std::size_t column = now().column;
    return accept("^") ? arithmetic_.power(base, signed_factor(), column) : base;
  }

  Tree primary() {
    const Token token = now();
    if (token.kind == TokenKind::end) refuse_at(token.column, "the expression ends too early");
    ++at_;
    if (token.kind == TokenKind::number)
      return number(arithmetic_.read_number(token.text, token.column));
    if (token.kind == TokenKind::name) return name(token);
    if (token.text == "(") {
      const Tree inside = sum();
      close(token);
      return inside;
    }
    refuse_at(token.column, "unexpected " + token.text);
  }

  void close(const Token& opening) {
    if (accept(")")) return;
    if (is_sign(",")) refuse_at(now().column, "unexpected comma; decimals are written 0.5");
    if (now().kind == TokenKind::end) refuse_at(opening.column, "the ) for this ( is missing");
    refuse_at(now().column, "unexpected " + now().text + " where an operator or ) is expected");
  }

  Tree name(const Token& token) {
    if (is_function_name(token.text)) return call(token);
    const auto& factors = limits_.symbols;
    const bool is_factor = is_certainly_no_function(token.text) ||
                           std::find(factors.begin(), factors.end(), token.text) != factors.end();
    if (is_sign("(") && !is_factor) {
      if (is_paper_name(token.text + "_n"))
        refuse_at(token.column, "write " + token.text + "_n for " + token.text + "(n), or " +
                                    token.text + "*( for a product");
      refuse_at(token.column, "unknown function " + token.text +
                                  "; write * for a product; functions: " + allowed_functions());
    }
    if (token.text == "pi" || token.text == "Pi" || token.text == "PI") return pi();
    if (token.text.size() > longest_name)
      refuse_at(token.column,
                "a name of more than " + std::to_string(longest_name) + " characters");
    return symbol(token.text);
  }

  Tree call(const Token& token) {
    Tree exponent;  // sin^2(x)
    std::size_t column = now().column;
    if (accept("^")) {
      const Deeper deeper(*this);
      exponent = primary();
      if (!is_number(exponent) || !is_integer(exponent->value) || exponent->value < 1)
        refuse_at(column, "write " + token.text + "(...)^n, or a" + token.text +
                              "(...) for the inverse function");
    }
    std::vector<Tree> arguments;
    const Token opening = now();
    if (accept("(")) {
      arguments.push_back(sum());
      while (accept(",")) arguments.push_back(sum());
      close(opening);
    } else if (now().kind == TokenKind::name && is_function_name(now().text)) {
      const Deeper deeper(*this);
      arguments.push_back(primary());  // atan sqrt(alpha)
    } else if ((token.text == "sqrt" || token.text == "cbrt") && now().kind != TokenKind::end &&
               now().kind != TokenKind::sign) {
      arguments.push_back(primary());  // the root sign before a number or a name
    } else if (now().kind == TokenKind::name) {
      arguments.push_back(
          primary());  // cos theta, where nothing that follows can belong to the argument
      if ((starts_factor() && !(now().kind == TokenKind::name && is_function_name(now().text))) ||
          is_sign("^"))
        refuse_at(now().column, "does " + now().text + " belong to what " + token.text +
                                    " is taken of? write " + token.text + "(...)");
    } else {
      refuse_at(now().column, "a ( is missing after " + token.text);
    }
    const Tree value = arithmetic_.call(token.text, arguments, token.column);
    return exponent ? arithmetic_.power(value, exponent, column) : value;
  }

  Limits limits_;
  Arithmetic arithmetic_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names{"sqrt", "cbrt", "root",   "abs",    "sin",    "cos",
                                              "tan",  "sec",  "csc",    "cosec",  "cot",    "asin",
                                              "acos", "atan", "arcsin", "arccos", "arctan", "exp",
                                              "log",  "ln",   "cosh",   "sinh",   "tanh"};
  return names;
}

Tree parse(std::string_view text, const Limits& limits) { return Parser(text, limits).whole(); }

std::vector<Comparison> parse_comparisons(std::string_view text, const Limits& limits) {
  return Parser(text, limits).comparisons();
}

}  // namespace magicmass::equality
