// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/tokens.hpp"

#include <cctype>
#include <map>

namespace magicmass::equality {
namespace {

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_letter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

// What a character stands for, in ASCII.
const std::map<char32_t, std::string>& spellings() {
  static const std::map<char32_t, std::string> table{
      {U'−', "-"},       {U'–', "-"},      {U'·', "*"},     {U'⋅', "*"},     {U'×', "*"},
      {U'∗', "*"},       {U'÷', "/"},      {U'∕', "/"},     {U'√', "sqrt"},  {U'∛', "cbrt"},
      {U'π', "pi"},      {U'α', "alpha"},  {U'β', "beta"},  {U'γ', "gamma"}, {U'δ', "delta"},
      {U'ε', "epsilon"}, {U'η', "eta"},    {U'θ', "theta"}, {U'κ', "kappa"}, {U'λ', "lambda"},
      {U'μ', "mu"},      {U'ν', "nu"},     {U'ξ', "xi"},    {U'ρ', "rho"},   {U'σ', "sigma"},
      {U'τ', "tau"},     {U'φ', "phi"},    {U'χ', "chi"},   {U'ψ', "psi"},   {U'ω', "omega"},
      {U'Γ', "Gamma"},   {U'Λ', "Lambda"}, {U'≤', "<="},    {U'≥', ">="},    {U'≠', "!="},
      {U'′', "'"},       {U'’', "'"},
  };
  return table;
}

const std::map<char32_t, char>& superscripts() {
  static const std::map<char32_t, char> table{
      {U'⁰', '0'}, {U'¹', '1'}, {U'²', '2'}, {U'³', '3'}, {U'⁴', '4'}, {U'⁵', '5'},
      {U'⁶', '6'}, {U'⁷', '7'}, {U'⁸', '8'}, {U'⁹', '9'}, {U'⁻', '-'},
  };
  return table;
}

std::string unicode_name(char32_t c) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string name;
  for (int shift = c > 0xffff ? 20 : 12; shift >= 0; shift -= 4)
    name += hex[(c >> static_cast<unsigned>(shift)) & 15U];
  return "U+" + name;
}

// Strict: no overlong forms, no surrogates, nothing past U+10FFFF.
std::u32string decoded(std::string_view text, std::size_t longest) {
  std::u32string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
    const bool starts = byte < 0x80 || (byte >= 0xc2 && byte <= 0xf4);
    char32_t c = length == 1 ? byte : byte & (0x7fU >> length);
    bool good = starts && i + length <= text.size();
    for (std::size_t k = 1; good && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      good = (next & 0xc0U) == 0x80;
      c = (c << 6U) | (next & 0x3fU);
    }
    good = good && !(length == 3 && c < 0x800) && !(length == 4 && (c < 0x10000 || c > 0x10ffff)) &&
           !(c >= 0xd800 && c < 0xe000);
    if (!good) refuse_at(result.size() + 1, "not valid UTF-8");
    result += c;
    if (result.size() > longest)
      throw NotAnExpression("longer than " + std::to_string(longest) + " characters");
    i += length;
  }
  return result;
}

class Scanner {
public:
  explicit Scanner(std::u32string text) : text_(std::move(text)) {}

  std::vector<Token> scan() {
    while (at_ < text_.size()) step();
    add(Token::Kind::end, "", text_.size() + 1);
    return std::move(tokens_);
  }

private:
  char32_t peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : U'\0';
  }
  void add(Token::Kind kind, std::string text, std::size_t column) {
    tokens_.push_back({kind, std::move(text), column});
  }

  void step() {
    const char32_t c = peek();
    const std::size_t column = at_ + 1;
    if (c == U' ' || c == U'\t' || c == U'\n' || c == U'\r' || c == 0xa0) {
      ++at_;
    } else if (is_digit(c) || (c == U'.' && is_digit(peek(1)))) {
      scan_number(column);
    } else if (is_letter(c) || is_greek(c)) {
      scan_name(column);
    } else if (superscripts().contains(c)) {
      scan_superscript(column);
    } else if (const auto spelling = spellings().find(c); spelling != spellings().end()) {
      ++at_;
      const bool is_word = is_letter(static_cast<unsigned char>(spelling->second[0]));
      if (spelling->second == "'") refuse_at(column, "unexpected '; write c_prime_n for c'_n");
      add(is_word ? Token::Kind::name : Token::Kind::sign, spelling->second, column);
    } else {
      scan_sign(c, column);
    }
  }

  bool is_greek(char32_t c) const {
    const auto found = spellings().find(c);
    return found != spellings().end() && c > 0x370 && c < 0x400;
  }

  void scan_number(std::size_t column) {
    std::string digits;
    while (is_digit(peek())) digits += static_cast<char>(text_[at_++]);
    if (peek() == U'.') {
      digits += '.';
      ++at_;
      while (is_digit(peek())) digits += static_cast<char>(text_[at_++]);
      if (peek() == U'.') refuse_at(at_ + 1, "a second decimal point in a number");
    }
    const char32_t mark = peek();
    const bool is_signed = peek(1) == U'+' || peek(1) == U'-';
    if ((mark == U'E' || mark == U'e') && is_digit(peek(is_signed ? 2 : 1))) {
      std::string exponent = is_signed ? std::string(1, static_cast<char>(peek(1))) : "";
      std::size_t end = is_signed ? 2 : 1;
      while (is_digit(peek(end))) exponent += static_cast<char>(peek(end++));
      if (mark == U'e')  // e^2-2e+1 is a square, 2e+1 may be 20
        refuse_at(column, digits + "e" + exponent + " can be read in two ways: write " + digits +
                              "E" + exponent + " for the number, " + digits + "*e" +
                              (is_signed ? exponent : "*" + exponent) +
                              " for a product with the coefficient of restitution e");
      digits += "E" + exponent;
      at_ += end;
    }
    add(Token::Kind::number, digits, column);
  }

  void scan_name(std::size_t column) {
    std::string name;
    const bool begins_greek = is_greek(peek());
    for (;; ++at_) {
      const char32_t c = peek();
      if (begins_greek && is_letter(c) && name.find('_') == std::string::npos)
        break;  // αV is a product
      if (is_letter(c) || is_digit(c) || c == U'_')
        name += static_cast<char>(c);
      else if (is_greek(c) && (name.empty() || name.back() == '_'))
        name += spellings().at(c);
      else
        break;
    }
    if ((peek() == U'\'' || peek() == U'′' || peek() == U'’') && name == "c") {  // c'_n
      name += "_prime";
      ++at_;
      for (; is_letter(peek()) || is_digit(peek()) || peek() == U'_'; ++at_)
        name += static_cast<char>(peek());
    }
    add(Token::Kind::name, name, column);
  }

  void scan_superscript(std::size_t column) {
    std::string digits;
    for (; superscripts().contains(peek()); ++at_) digits += superscripts().at(peek());
    const std::size_t minus = digits.rfind('-');
    if (digits == "-" || (minus != std::string::npos && minus != 0))
      refuse_at(column, "a superscript that is no whole number");
    add(Token::Kind::sign, "^", column);
    add(Token::Kind::sign, "(", column);
    if (minus == 0) add(Token::Kind::sign, "-", column);
    add(Token::Kind::number, minus == 0 ? digits.substr(1) : digits, column);
    add(Token::Kind::sign, ")", column);
  }

  void scan_sign(char32_t c, std::size_t column) {
    ++at_;
    const char32_t next = peek();
    if (c == U'*' && next == U'*') {
      ++at_;
      add(Token::Kind::sign, "^", column);
    } else if ((c == U'<' || c == U'>' || c == U'!') && next == U'=') {
      ++at_;
      add(Token::Kind::sign, std::string(1, static_cast<char>(c)) + "=", column);
    } else if (c < 0x80 && std::string_view("+-*/^(),<>=").find(static_cast<char>(c)) !=
                               std::string_view::npos) {
      add(Token::Kind::sign, std::string(1, static_cast<char>(c)), column);
    } else if (c > 0x20 && c < 0x7f) {
      refuse_at(column, std::string("unexpected character ") + static_cast<char>(c));
    } else {
      refuse_at(column, "unexpected character " + unicode_name(c));
    }
  }

  std::u32string text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

void refuse_at(std::size_t column, const std::string& reason) {
  throw NotAnExpression("column " + std::to_string(column) + ": " + reason);
}

std::vector<Token> tokens(std::string_view text, std::size_t longest) {
  return Scanner(decoded(text, longest)).scan();
}

}  // namespace magicmass::equality
