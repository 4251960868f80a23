#include "notation/tokens.hpp"

#include <bit>
#include <cstdio>

namespace notation {
namespace {
using Characters = std::u32string_view;
constexpr std::size_t longest = 20000;

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_letter(char32_t c) { return (c | 0x20U) >= U'a' && (c | 0x20U) <= U'z'; }
bool is_plain(char32_t c) { return is_letter(c) || is_digit(c); }
// Also what word processors write between a function and its argument, or two factors.
bool is_blank(char32_t c) {
  return c == U' ' || c == U'\t' || c == U'\n' || c == U'\r' || c == 0xa0 || c == 0x202f ||
         (c >= 0x2000 && c <= 0x200d) || (c >= 0x205f && c <= 0x2064);
}
struct Script {
  Characters characters, meanings;
  char32_t at(char32_t c, char32_t otherwise = 0) const {
    const std::size_t i = characters.find(c);
    return i == characters.npos ? otherwise : meanings[i];
  }
};
constexpr Script superscripts{U"⁰¹²³⁴⁵⁶⁷⁸⁹⁻ⁿ", U"0123456789-n"};
constexpr Script subscripts{
    U"₀₁₂₃₄₅₆₇₈₉"
    U"ₙₜₖⱼₐₘₓ",
    U"0123456789ntkjamx"};
constexpr Script lookalikes{U"−–÷∕⁄≈〖〗′’ɑℎ", U"--///=()''αh"};

// The character of which c is a shape: mathematical bold and italic ones, full width.
char32_t unstyled(char32_t c) {
  if (c > 0xff00 && c < 0xff5f) return c - 0xfee0;
  if (c < 0x1d400 || c > 0x1d7ff) return lookalikes.at(c, c);
  if (c >= 0x1d7ce) return U'0' + (c - 0x1d7ce) % 10;
  const char32_t latin = (c - 0x1d400) % 52, greek = (c - 0x1d6a8) % 58;
  if (c < 0x1d6a4) return latin < 26 ? U'A' + latin : U'a' + (latin - 26);
  return c < 0x1d6a8 || greek > 50 ? c : greek < 26 ? U'Α' + greek : U'α' + (greek - 26);
}
const std::map<char32_t, std::string>& greek_names() {
  static const std::map<char32_t, std::string> table = [] {
    std::map<char32_t, std::string> names{{U'Γ', "Gamma"}, {U'Λ', "Lambda"}};
    std::istringstream small(
        "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho "
        "sigma sigma tau upsilon phi chi psi omega");
    char32_t letter = U'α';
    for (std::string name; small >> name; ++letter) names.emplace(letter, name);
    return names;
  }();
  return table;
}
std::string shown(char32_t c) {
  char name[16];
  std::snprintf(name, sizeof name, c > 0x20 && c < 0x7f ? "%c" : "U+%04X", unsigned(c));
  return name;
}
// And where each character begins, and the text ends.
std::u32string decoded(std::string_view text, std::vector<std::size_t>& starts) {
  constexpr char32_t least[]{0, 0, 0x80, 0x800, 0x10000};
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    starts.resize(out.size());
    starts.push_back(i);
    const auto byte = static_cast<unsigned char>(text[i]);
    const int ones = std::countl_one(byte);
    bool good = ones != 1 && ones < 5;
    char32_t c = byte & (0xffU >> ones);
    for (const std::size_t end = ++i + std::size_t(std::max(ones, 1)) - 1; good && i < end; ++i) {
      const unsigned next = i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
      good = (next & 0xc0U) == 0x80;
      c = (c << 6U) | (next & 0x3fU);
    }
    if (!good || c < least[ones] || c > 0x10ffff || (c >= 0xd800 && c < 0xe000))
      refuse_at(out.size() + 1, "not valid UTF-8");
    if (c != 0xfeff || i > 3) out += unstyled(c);  // a byte order mark
    if (out.size() > longest) kernel::refuse("longer than 20000 characters");
  }
  starts.resize(out.size());
  starts.push_back(text.size());
  return out;
}

class Scanner {
public:
  explicit Scanner(std::string_view typed) : source(typed), text(decoded(source, starts)) {}
  std::vector<Token> scan() {
    while (at < text.size()) step();
    add(Kind::End, "", text.size() + 1);
    return std::move(out);
  }

private:
  std::string_view source;
  std::vector<std::size_t> starts;
  std::u32string text;
  std::size_t at = 0;
  bool spaced = false, latex = false;
  std::vector<Token> out;

  char32_t peek(std::size_t ahead = 0) const { return text[std::min(at + ahead, text.size())]; }
  bool takes(Characters word) {
    const bool follows = Characters(text).substr(std::min(at, text.size())).starts_with(word);
    if (follows) at += word.size();
    return follows;
  }
  std::string run(bool (*belongs)(char32_t)) {
    std::string found;
    while (belongs(peek())) found += char(text[at++]);
    return found;
  }
  std::string run(const Script& script) {
    std::string found;
    while (script.at(peek()) != 0) found += char(script.at(text[at++]));
    return found;
  }
  void add(Kind kind, const std::string& word, std::size_t column) {
    out.push_back({kind, word, column, spaced, latex, {}, as_typed(column)});
    spaced = latex = false;
  }

  std::string as_typed(std::size_t column) const {
    return std::string(source.substr(starts[column - 1], starts[at] - starts[column - 1]));
  }
  void step() {
    // Characters that stand for a sign or a word of ours.
    static const std::map<char32_t, std::string> spellings{
        {U'·', "*"},   {U'⋅', "*"},   {U'×', "*"},    {U'∗', "*"},    {U'≤', "<="},
        {U'≥', ">="},  {U'≠', "!="},  {U'√', "sqrt"}, {U'∛', "cbrt"}, {U'½', "1/2"},
        {U'⅓', "1/3"}, {U'¼', "1/4"}, {U'¾', "3/4"},  {U'⅔', "2/3"}};
    const char32_t c = peek();
    const std::size_t column = at + 1;
    if (is_digit(c) || (c == U'.' && is_digit(peek(1)))) return number(column);
    if (is_letter(c) || greek_names().contains(c)) return indexed_name(plain_word(), column);
    if (superscripts.at(c) != 0) return superscript(column);
    ++at;
    if (c == U'\\') return is_letter(peek()) ? command(column) : escaped(column);
    if (const auto it = spellings.find(c); it != spellings.end())
      spelled(it->second, column);
    else if (is_blank(c) || c == U'$')
      spaced = true;
    else
      sign(c, column);
  }
  // What stands for others, as they are typed in ASCII.
  void spelled(const std::string& word, std::size_t column) {
    const bool is_fraction = is_digit(char32_t(word[0]));
    if (is_fraction && !out.empty() && out.back().kind == Kind::Number && !spaced)
      refuse_at(column, "a sum or a product? write " + out.back().text + "+" + word + " or " +
                            out.back().text + "*" + word);
    const std::string ascii = is_fraction ? "(" + word + ")" : word;
    for (const Token& part : Scanner(ascii).scan()) {
      if (part.kind == Kind::End) continue;
      add(part.kind, part.text, column);
      if (part.column > 1) out.back().quoted.clear();
    }
  }

  void number(std::size_t column) {
    std::string word = run(is_digit);
    if (takes(U".")) word += "." + run(is_digit);
    if (peek() == U'.') refuse_at(at + 1, "a second decimal point in a number");
    const char32_t base = peek() | 0x20U;
    const bool has_base = base == U'x' ? is_plain(peek(1)) : is_digit(peek(1));
    if (word == "0" && has_base && (base == U'x' || base == U'b' || base == U'o'))
      refuse_at(column, std::string("a number of another base? write it in decimal, or 0*") +
                            char(base) + " for a product");
    if (text.substr(at, 4) == U"x10^")
      refuse_at(column, "is x a symbol? write " + word + "*10^ for a power of ten");
    const bool has_sign = peek(1) == U'+' || peek(1) == U'-';
    if ((peek() | 0x20U) == U'e' && is_digit(peek(has_sign ? 2 : 1))) {
      const bool is_small = text[at++] == U'e';
      std::string power = has_sign ? std::string(1, char(text[at++])) : "";
      power += run(is_digit);
      if (is_small)
        refuse_at(column, word + "e" + power + " has two readings: write " + word + "E" + power +
                              " for the number, " + word + (has_sign ? "*e" : "*e*") + power +
                              " with e");
      word += "E" + power;
    }
    add(Kind::Number, word, column);
  }

  std::string plain_word() {
    const std::string word = run(is_plain), f = word.substr(0, word.find_first_of("0123456789"));
    const auto greek = greek_names().find(peek());
    const bool joins = word.empty() || (f != word && is_function(f));  // cos2θ is refused
    if (greek == greek_names().end() || !joins) return word;
    ++at;
    return word + greek->second;
  }
  // \rm, \text, \textit, \mathrm, \mathit...
  bool skips_font() {
    const bool skips = takes(U"\\rm") || takes(U"\\text") || takes(U"\\math");
    if (skips) run(is_letter);
    return skips;
  }
  // _n, _{n}, _{\rm CM}, _{\mathrm{CM}}, and subscript characters.
  std::string index() {
    std::string found = "_" + run(subscripts);
    if (found.size() > 1) return found;
    if (!takes(U"_")) return "";
    skips_font();
    const std::size_t column = at + 1;
    if (!takes(U"{")) {
      found += plain_word();
      if (found.size() == 1 && peek() == U'(') refuse_index();
      return found + index();  // T_1T_{next} is parted later
    }
    for (int depth = 1; depth > 0;) {
      if (at >= text.size()) refuse_at(column, "the } for a { is missing");
      if (skips_font()) continue;
      const std::string word = takes(U"_") ? "_" : plain_word();
      found += word;
      if (!word.empty()) continue;
      const char32_t c = peek();
      depth += c == U'{' ? 1 : c == U'}' ? -1 : 0;
      if (c != U'{' && c != U'}' && !is_blank(c)) refuse_index();
      ++at;
    }
    return found;
  }
  [[noreturn]] void refuse_index() const {
    refuse_at(at + 1, "an index is a name or a number: T_m, T_2, or T_next for T_(m+1)");
  }
  std::string prime() {
    return takes(U"'") || takes(U"^\\prime") || takes(U"^{\\prime}") ? "_prime" : "";
  }
  void indexed_name(const std::string& word, std::size_t column) {
    const std::size_t digit = word.find_first_of("0123456789");
    const bool is_short = digit == 1 || is_greek_name(word.substr(0, digit));
    const std::size_t letters = is_short ? digit : word.npos;
    const std::string number = letters == word.npos ? "" : "_" + word.substr(letters);  // M1
    const std::string first = prime();
    const std::string index_1 = number + index();
    const std::string whole =  // c_n' is c'_n
        word.substr(0, letters) + (first.empty() ? prime() : first) + index_1;
    if (index_1.ends_with('_')) refuse_at(column, "an index is missing behind " + word + "_");
    if (whole.size() > 40) refuse_at(column, "a name of more than 40 characters");
    add(Kind::Name, whole, column);
    if (!number.empty()) out.back().typed = word;
  }

  void superscript(std::size_t column) {
    const std::string word = run(superscripts);
    if (word.ends_with('-') || word.find('n') < word.size() - 1)
      refuse_at(column, "a superscript that is no whole number");
    spelled("^(" + word + ")", column);
  }

  void escaped(std::size_t column) {
    const char32_t c = peek();
    ++at;
    if (c == U'\\' && peek() == U'[')  // a row of a matrix, with the space behind it: \\[4pt]
      at = std::min(text.find(U']', at), text.size() - 1) + 1;
    if (c == U'\\') return add(Kind::Sign, ";", column);
    if (c == U'{' || c == U'}') return add(Kind::Sign, c == U'{' ? "(" : ")", column);
    if (Characters(U"()[],;!: ").find(c) == Characters::npos)
      refuse_at(column, "a backslash before a character that is no command");
    spaced = true;
  }
  void command(std::size_t column) {
    static const std::set<std::string> ignored{
        "left", "right",        "big",          "Big",   "bigl",   "bigr",
        "Bigl", "Bigr",         "quad",         "qquad", "text",   "mathrm",
        "rm",   "operatorname", "displaystyle", "boxed", "mathbf", "mathit"};
    static const std::map<std::string, std::string> signs{
        {"cdot", "*"},   {"times", "*"},  {"ast", "*"},   {"div", "/"},   {"le", "<="},
        {"leq", "<="},   {"ge", ">="},    {"geq", ">="},  {"ne", "!="},   {"neq", "!="},
        {"lbrace", "("}, {"rbrace", ")"}, {"lvert", "|"}, {"rvert", "|"}, {"vert", "|"},
        {"top", "T"},    {"approx", "="}};
    std::string word = run(is_letter);
    latex = true;
    if (word.starts_with("var") && is_greek_name(word.substr(3))) word.erase(0, 3);
    if (word == "dfrac" || word == "tfrac" || word == "cfrac") word = "frac";
    if (word == "frac" || word == "sqrt") return add(Kind::Command, word, column);
    if (word == "over") return add(Kind::Sign, word, column);
    if (word == "begin" || word == "end") return bracket(word, column);
    if (is_function(word) || is_greek_name(word)) return indexed_name(word, column);
    if (const auto it = signs.find(word); it != signs.end())
      spelled(it->second, column);
    else if (word.ends_with("floor") || word.ends_with("ceil"))
      refuse_at(column, "\\" + word + no_rounding);
    else if (!ignored.contains(word))
      refuse_at(column, "unknown command \\" + word);
    spaced = true;
    const std::size_t end = at;
    const std::string inner = takes(U"{") ? run(is_plain) : "";  // \operatorname{sech}
    if (is_function(inner) && takes(U"}"))
      add(Kind::Name, inner, column);
    else
      at = end;
  }
  // {pmatrix} of \begin or \end, {array}{cc}; {align*} and the like are left out.
  void bracket(const std::string& word, std::size_t column) {
    static const std::set<std::string> empty{"align",    "aligned", "equation", "gather",
                                             "gathered", "math",    "split",    "displaymath"};
    const bool has_columns = word == "begin" && takes(U"{array}");
    std::string kind;
    if (takes(U"{")) kind = run([](char32_t c) { return c != U'}' && c != U'\0'; });
    if (!takes(U"}")) refuse_at(column, "a } is missing for this \\" + word);
    if (kind.ends_with('*')) kind.pop_back();
    if (empty.contains(kind)) return;
    const bool is_matrix = kind.ends_with("matrix") && (kind[0] | 0x20) != 'v';  // a determinant
    if (!is_matrix && !has_columns && kind != "array")
      refuse_at(column, "unknown environment " + kind);
    add(Kind::Sign, word == "begin" ? "[" : "]", column);
  }

  void sign(char32_t c, std::size_t column) {
    if (c == U'&' && peek() == U'=') return;  // where equations are aligned
    if (c == U':' && !out.empty())
      refuse_at(column,
                "unexpected :; a formula has no words before it, a ratio is written with /");
    if (Characters(U"⌊⌋⌈⌉").find(c) != Characters::npos)
      refuse_at(column, as_typed(column) + no_rounding);
    if (c == U'°') refuse_at(column, "angles are in radians; 180 degrees are pi");
    const bool is_visible = (c >= 0x370 && c < 0x400) || (c >= 0x2190 && c < 0x2c00);
    const bool is_two = (c == U'<' || c == U'>' || c == U'!') && takes(U"=");
    if (!is_two && Characters(U"+-*/^()[]{},;<>=|&").find(c) == Characters::npos)
      refuse_at(column, "unexpected character " + (is_visible ? as_typed(column) : shown(c)));
    const std::string word = c == U'&' ? "," : c == U'*' && takes(U"*") ? "^" : shown(c);
    add(Kind::Sign, word + (is_two ? "=" : ""), column);
  }
};
}  // namespace

std::string Words::typed(std::size_t from, std::size_t to) const {
  std::string out = words[from].quoted;
  for (std::size_t i = from + 1; i < to; ++i)
    out += (words[i].is_spaced && words[i].text != ")" ? " " : "") + words[i].quoted;
  return out;
}
void refuse_at(std::size_t column, const std::string& why) {
  kernel::refuse("column " + std::to_string(column) + ": " + why);
}
bool is_greek_name(const std::string& name) {
  return std::ranges::any_of(greek_names(), [&](const auto& one) { return one.second == name; });
}
bool is_whole(std::string_view digits) {
  return !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos;
}
std::vector<Token> tokens(std::string_view text) { return Scanner(text).scan(); }
}  // namespace notation
