// SPDX-License-Identifier: GPL-2.0-or-later
#include "notation/tokens.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>

#include "notation/operations.hpp"

namespace notation {
namespace {
using Kind = Token::Kind;
constexpr std::size_t longest = 20000;

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_letter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }
bool is_plain(char32_t c) { return is_letter(c) || is_digit(c); }
// Also what word processors write between a function and its argument, or two factors.
bool is_blank(char32_t c) {
  return c == U' ' || c == U'\t' || c == U'\n' || c == U'\r' || c == 0xa0 || c == 0x202f ||
         (c >= 0x2000 && c <= 0x200d) || (c >= 0x205f && c <= 0x2064);
}
// The letter or digit of which c is a shape: mathematical bold and italic ones, full width.
char32_t unstyled(char32_t c) {
  if (c > 0xff00 && c < 0xff5f) return c - 0xfee0;
  if (c < 0x1d400 || c > 0x1d7ff) return c;
  if (c >= 0x1d7ce) return U'0' + (c - 0x1d7ce) % 10;
  const char32_t latin = (c - 0x1d400) % 52, greek = (c - 0x1d6a8) % 58;
  if (c < 0x1d6a4) return latin < 26 ? U'A' + latin : U'a' + (latin - 26);
  return c < 0x1d6a8 || greek > 50 ? c : greek < 26 ? U'Α' + greek : U'α' + (greek - 26);
}

// What stands for a sign or a word of ours.
const std::map<char32_t, std::string>& spellings() {
  static const std::map<char32_t, std::string> table = [] {
    std::map<char32_t, std::string> words{
        {U'−', "-"},   {U'–', "-"},    {U'·', "*"},    {U'⋅', "*"},     {U'×', "*"},
        {U'∗', "*"},   {U'÷', "/"},    {U'∕', "/"},    {U'≤', "<="},    {U'≥', ">="},
        {U'≠', "!="},  {U'√', "sqrt"}, {U'∛', "cbrt"}, {U'½', "1/2"},   {U'⅓', "1/3"},
        {U'¼', "1/4"}, {U'¾', "3/4"},  {U'⅔', "2/3"},  {U'Γ', "Gamma"}, {U'Λ', "Lambda"},
        {U'⁄', "/"},   {U'≈', "="},    {U'〖', "("},   {U'〗', ")"},    {U'ɑ', "alpha"},
        {U'ℎ', "h"}};
    std::istringstream greek(
        "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho "
        "sigma sigma tau upsilon phi chi psi omega");
    char32_t letter = U'α';
    for (std::string name; greek >> name; ++letter) words.emplace(letter, name);
    return words;
  }();
  return table;
}
bool is_greek(char32_t c) { return c > 0x370 && c < 0x400 && spellings().contains(c); }
// Characters and what each of them stands for.
struct Script {
  std::u32string_view characters;
  std::string_view meanings;
  bool contains(char32_t c) const { return characters.find(c) != characters.npos; }
  char at(char32_t c) const { return meanings[characters.find(c)]; }
};
constexpr Script superscripts{U"⁰¹²³⁴⁵⁶⁷⁸⁹⁻ⁿ", "0123456789-n"};
constexpr Script subscripts{
    U"₀₁₂₃₄₅₆₇₈₉"
    U"ₙₜₖⱼₐₘₓ",
    "0123456789ntkjamx"};
// LaTeX's commands for signs; "" is left out.
const std::map<std::string, std::string>& commands() {
  static const std::map<std::string, std::string> table{
      {"cdot", "*"},   {"times", "*"},  {"ast", "*"},   {"div", "/"},         {"le", "<="},
      {"leq", "<="},   {"ge", ">="},    {"geq", ">="},  {"ne", "!="},         {"neq", "!="},
      {"lbrace", "("}, {"rbrace", ")"}, {"lvert", "|"}, {"rvert", "|"},       {"vert", "|"},
      {"left", ""},    {"right", ""},   {"big", ""},    {"Big", ""},          {"bigl", ""},
      {"bigr", ""},    {"Bigl", ""},    {"Bigr", ""},   {"quad", ""},         {"qquad", ""},
      {"text", ""},    {"mathrm", ""},  {"rm", ""},     {"operatorname", ""}, {"displaystyle", ""},
      {"boxed", ""},   {"mathbf", ""},  {"mathit", ""}, {"approx", "="}};
  return table;
}

std::string code_point(char32_t c) {
  char name[16];
  std::snprintf(name, sizeof name, "U+%04X", static_cast<unsigned>(c));
  return name;
}
std::u32string decoded(std::string_view text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
    char32_t c = length == 1 ? byte : byte & (0x7fU >> length);
    bool good = (byte < 0x80 || (byte >= 0xc2 && byte <= 0xf4)) && i + length <= text.size();
    for (std::size_t k = 1; good && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      good = (next & 0xc0U) == 0x80;
      c = (c << 6U) | (next & 0x3fU);
    }
    const char32_t least = length == 3 ? 0x800 : length == 4 ? 0x10000 : 0;
    if (!good || c < least || c > 0x10ffff || (c >= 0xd800 && c < 0xe000))
      refuse_at(out.size() + 1, "not valid UTF-8");
    if (c != 0xfeff || i > 0) out += unstyled(c);  // a byte order mark
    if (out.size() > longest) kernel::refuse("longer than 20000 characters");
    i += length;
  }
  return out;
}

class Scanner {
public:
  explicit Scanner(std::u32string typed) : text(std::move(typed)) {}
  std::vector<Token> scan() {
    while (at < text.size()) step();
    add(Kind::End, "", text.size() + 1);
    return std::move(out);
  }

private:
  std::u32string text;
  std::size_t at = 0;
  bool spaced = false;
  bool latex = false;
  std::vector<Token> out;

  char32_t peek(std::size_t ahead = 0) const {
    return at + ahead < text.size() ? text[at + ahead] : U'\0';
  }
  bool follows(std::u32string_view word) const {
    return std::u32string_view(text).substr(std::min(at, text.size())).starts_with(word);
  }
  void add(Kind kind, const std::string& word, std::size_t column) {
    out.push_back({kind, word, column, spaced, latex, {}});
    spaced = latex = false;
  }
  std::string digits() {
    std::string found;
    while (is_digit(peek())) found += char(text[at++]);
    return found;
  }

  void step() {
    const char32_t c = peek();
    const std::size_t column = at + 1;
    if (is_blank(c) || c == U'$') {
      ++at;
      spaced = true;
    } else if (is_digit(c) || (c == U'.' && is_digit(peek(1)))) {
      number(column);
    } else if (is_letter(c) || is_greek(c)) {
      indexed_name(plain_word(), column);
    } else if (superscripts.contains(c)) {
      superscript(column);
    } else if (const auto it = spellings().find(c); it != spellings().end()) {
      ++at;
      spelled(it->second, column);
    } else if (c == U'\\') {
      ++at;
      command(column);
    } else {
      sign(c, column);
    }
  }
  // What is typed in one character, as it is typed in ASCII.
  void spelled(const std::string& word, std::size_t column) {
    const bool is_fraction = is_digit(char32_t(word[0]));
    if (is_fraction && !out.empty() && out.back().kind == Kind::Number && !spaced)
      refuse_at(column, "a sum or a product? write " + out.back().text + "+" + word + " or " +
                            out.back().text + "*" + word);
    const std::string ascii = is_fraction ? "(" + word + ")" : word;
    for (const Token& part : Scanner({ascii.begin(), ascii.end()}).scan())
      if (part.kind != Kind::End) add(part.kind, part.text, column);
  }

  void number(std::size_t column) {
    std::string word = digits();
    if (peek() == U'.') {
      ++at;
      word += "." + digits();
    }
    if (peek() == U'.') refuse_at(at + 1, "a second decimal point in a number");
    if (word == "0" && (peek() == U'x' || peek() == U'X') && is_plain(peek(1)))
      refuse_at(column, "a hexadecimal number? write it in decimal, or 0*x for a product");
    const std::size_t sign = peek(1) == U'+' || peek(1) == U'-' ? 1 : 0;
    if ((peek() == U'e' || peek() == U'E') && is_digit(peek(1 + sign))) {
      const bool is_small = peek() == U'e';
      const std::string mark = sign == 1 ? std::string(1, char(peek(1))) : "";
      at += 1 + sign;
      const std::string exponent = digits();
      if (is_small)
        refuse_at(column, word + "e" + mark + exponent + " has two readings: write " + word + "E" +
                              mark + exponent + " for the number, " + word + "*e" +
                              (mark.empty() ? "*" : mark) + exponent + " with e");
      word += "E" + mark + exponent;
    }
    add(Kind::Number, word, column);
  }

  // A Greek letter, or letters and digits.
  std::string plain_word() {
    if (is_greek(peek())) return spellings().at(text[at++]);
    std::string found;
    while (is_plain(peek())) found += char(text[at++]);
    return found;
  }
  // \rm, \text, \mathrm: letters stand upright.
  bool skips_font() {
    if (!follows(U"\\rm") && !follows(U"\\text") && !follows(U"\\mathrm")) return false;
    for (++at; is_letter(peek());) ++at;
    return true;
  }
  // _n, _{n}, _{\rm CM}, _{\mathrm{CM}}, and subscript characters.
  std::string index() {
    std::string found;
    while (subscripts.contains(peek())) found += subscripts.at(text[at++]);
    if (!found.empty()) return "_" + found;
    if (peek() != U'_') return "";
    ++at;
    skips_font();
    if (peek() != U'{') {
      found = plain_word();
      if (peek() == U'(' && found.empty()) refuse_index();
      return "_" + found + index();  // T_1T_{next} is parted later
    }
    const std::size_t column = at + 1;
    int depth = 0;
    do {
      if (at >= text.size()) refuse_at(column, "the } for a { is missing");
      if (skips_font()) continue;
      const char32_t c = text[at];
      depth += c == U'{' ? 1 : c == U'}' ? -1 : 0;
      if (is_plain(c) || c == U'_')
        found += char(c);
      else if (is_greek(c))
        found += spellings().at(c);
      else if (c != U'{' && c != U'}' && !is_blank(c))
        refuse_index();
      ++at;
    } while (depth > 0);
    return "_" + found;
  }
  [[noreturn]] void refuse_index() const {
    refuse_at(at + 1, "an index is a name or a number, as in T_m and T_2");
  }
  std::string prime() {
    for (const std::u32string_view mark : {U"'", U"′", U"’", U"^\\prime", U"^{\\prime}"})
      if (follows(mark)) {
        at += mark.size();
        return "_prime";
      }
    return "";
  }
  void indexed_name(const std::string& word, std::size_t column) {
    std::string whole = word;
    const std::size_t letters = word.find_first_of("0123456789");
    const bool is_short = letters == 1 || is_greek_name(word.substr(0, letters));
    if (letters != word.npos && is_short) whole.insert(letters, "_");  // M1
    const std::string first = prime();
    const std::string index_1 = index();
    whole += first + index_1 + (first.empty() ? prime() : "");
    if (index_1.ends_with('_')) refuse_at(column, "an index is missing behind " + word + "_");
    if (whole.size() > 40) refuse_at(column, "a name of more than 40 characters");
    add(Kind::Name, whole, column);
    if (whole != word && letters != word.npos) out.back().typed = word;
  }

  void superscript(std::size_t column) {
    std::string word;
    while (superscripts.contains(peek())) word += superscripts.at(text[at++]);
    const std::string rest = word.substr(word[0] == '-' ? 1 : 0);
    if (rest.empty() || rest.find('-') != rest.npos ||
        (rest.size() > 1 && rest.find('n') != rest.npos))
      refuse_at(column, "a superscript that is no whole number");
    spelled("^(" + word + ")", column);
  }

  void command(std::size_t column) {
    const char32_t c = peek();
    if (!is_letter(c)) {
      ++at;
      if (c == U'\\') {  // a row of a matrix, with the space behind it: \\[4pt]
        if (peek() == U'[') at = std::min(text.find(U']', at), text.size() - 1) + 1;
        return add(Kind::Sign, ";", column);
      }
      if (c == U'{' || c == U'}') return add(Kind::Sign, c == U'{' ? "(" : ")", column);
      if (std::u32string_view(U"()[],;!: ").find(c) == std::u32string_view::npos)
        refuse_at(column, "a backslash before a character that is no command");
      spaced = true;
      return;
    }
    std::string word;
    while (is_letter(peek())) word += char(text[at++]);
    latex = true;
    if (const auto it = commands().find(word); it != commands().end()) {
      if (!it->second.empty()) add(Kind::Sign, it->second, column);
      spaced = true;
      const std::size_t end = text.find(U'}', at);  // \operatorname{sech}
      if (peek() != U'{' || end == text.npos) return;
      const auto braced = text.substr(at + 1, end - at - 1);
      const std::string inner(braced.begin(), braced.end());
      if (!is_function(inner)) return;
      at = end + 1;
      return add(Kind::Name, inner, column);
    }
    if (word.starts_with("var") && is_greek_name(word.substr(3))) word.erase(0, 3);
    if (word == "dfrac" || word == "tfrac" || word == "cfrac") word = "frac";
    if (word == "frac" || word == "sqrt") return add(Kind::Command, word, column);
    if (word == "begin" || word == "end") return bracket(word, column);
    if (!is_function(word) && !is_greek_name(word)) refuse_at(column, "unknown command \\" + word);
    indexed_name(word, column);
  }

  // {pmatrix} of \begin or \end, {array}{cc}; {align*} and the like are left out
  void bracket(const std::string& word, std::size_t column) {
    const bool has_columns = word == "begin" && follows(U"{array}");
    const std::size_t start = at;
    for (int groups = has_columns ? 2 : 1; groups > 0; --groups) {
      at = text.find(U'}', at) + 1;
      if (at == 0) refuse_at(column, "a } is missing for this \\" + word);
    }
    std::string kind(text.begin() + long(start) + 1, text.begin() + long(at) - 1);
    if (kind.ends_with('*')) kind.pop_back();
    static const std::set<std::string> empty{"align",    "aligned", "equation", "gather",
                                             "gathered", "math",    "split",    "displaymath"};
    if (empty.contains(kind)) return;
    if (!kind.ends_with("matrix") && !has_columns && kind != "array")
      refuse_at(column, "unknown environment " + kind);
    add(Kind::Sign, word == "begin" ? "[" : "]", column);
  }

  void sign(char32_t c, std::size_t column) {
    ++at;
    if (c == U'*' && peek() == U'*') {
      ++at;
      return add(Kind::Sign, "^", column);
    }
    if ((c == U'<' || c == U'>' || c == U'!') && peek() == U'=') {
      ++at;
      return add(Kind::Sign, std::string(1, char(c)) + "=", column);
    }
    if (c == U'&' && peek() == U'=') return;  // where equations are aligned
    if (c == U'&') return add(Kind::Sign, ",", column);
    if (std::u32string_view(U"+-*/^()[]{},;<>=|").find(c) != std::u32string_view::npos)
      return add(Kind::Sign, std::string(1, char(c)), column);
    const bool printable = c > 0x20 && c < 0x7f;
    refuse_at(column,
              "unexpected character " + (printable ? std::string(1, char(c)) : code_point(c)));
  }
};
}  // namespace

void refuse_at(std::size_t column, const std::string& why) {
  kernel::refuse("column " + std::to_string(column) + ": " + why);
}
bool is_greek_name(const std::string& name) {
  return std::ranges::any_of(spellings(), [&](const auto& spelling) {
    return is_greek(spelling.first) && spelling.second == name;
  });
}
std::vector<Token> tokens(std::string_view text) { return Scanner(decoded(text)).scan(); }
}  // namespace notation
