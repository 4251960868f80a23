// What people type, cut into the same words from plain text, Unicode and LaTeX; what they become.
#pragma once

#include <algorithm>
#include <sstream>
#include <utility>

#include <cln/integer_io.h>

#include "kernel/expr.hpp"

namespace notation {
using kernel::Expr;
struct Token {
  enum class Kind { Number, Name, Command, Sign, End };
  Kind kind = Kind::End;
  std::string text = {};    ///< in ASCII: "c_prime_n", "0.5", "<=", "frac"
  std::size_t column = 0;   ///< in characters, from 1
  bool is_spaced = false;   ///< a blank stands before it
  bool is_latex = false;    ///< it began with a backslash
  std::string typed = {};   ///< where it was changed: "M1" of M_1
  std::string quoted = {};  ///< as it stands there: "ω" of omega
};
using Kind = Token::Kind;
/// A place among words, for readers that take one after the other.
class Words {
protected:
  explicit Words(std::vector<Token> all) : words(std::move(all)) {}
  const Token& now() const { return words[place]; }
  const Token& next() { return words[place++]; }
  bool is(std::string_view text) const { return now().text == text; }
  bool takes(std::string_view text) {
    if (!is(text)) return false;
    ++place;
    return true;
  }
  std::string typed(std::size_t from, std::size_t to) const;  ///< these, with blanks
  std::vector<Token> words;
  std::size_t place = 0;
};
/// The last one is the End. Refused (kernel::Refused, "column 7: ..."): bytes that are not UTF-8,
/// characters and commands that belong to no formula, more than 20,000 characters.
std::vector<Token> tokens(std::string_view text);
[[noreturn]] void refuse_at(std::size_t column, const std::string& why);
bool is_greek_name(const std::string& name);
inline const std::string no_rounding = " is not read: there are no rounding functions here";
bool is_whole(std::string_view digits);

// What the operators and functions of typed expressions make of numbers and matrices. All throw
// kernel::Refused, "column 7: ...", for what has no value or would be too large.
bool is_function(const std::string& name);
/// Of sinx, sin_2 and f in f(x): why it is no name of a number, and what may be meant; else "".
std::string why_no_symbol(const std::string& word, bool is_before_bracket,
                          const std::set<std::string>& factors);
/// What a function is of x, as one types it: "sin(x)/cos(x)"; "" of those that stay as they are.
const std::string& definition_of(const std::string& function);
cln::cl_RA number_of(const Token& token);
std::size_t bits(const cln::cl_RA& q);

Expr negative(Expr e);
Expr sum_of(const kernel::Exprs& terms, std::size_t column);
Expr times(Expr a, Expr b, std::size_t column);
Expr quotient(Expr a, Expr b, std::size_t column);
Expr raised_to(Expr base, Expr exponent, std::size_t column);
Expr ordered_root(Expr order, Expr x, std::size_t column);
/// Of numbers, or of matrices, one below the other: [[a, b], [c, d]].
Expr grid_of(const std::vector<kernel::Exprs>& rows, std::size_t column);
}  // namespace notation
