// SPDX-License-Identifier: GPL-2.0-or-later
// What people type, cut into words: plain text, Unicode and LaTeX give the same words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace notation {
struct Token {
  enum class Kind { Number, Name, Command, Sign, End };
  Kind kind = Kind::End;
  std::string text = {};   ///< in ASCII: "c_prime_n", "0.5", "<=", "frac"
  std::size_t column = 0;  ///< in characters, from 1
  bool is_spaced = false;  ///< a blank stands before it
  bool is_latex = false;   ///< it began with a backslash
  std::string typed = {};  ///< where it was changed: "M1" of M_1
};
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
bool is_whole(std::string_view digits);
}  // namespace notation
