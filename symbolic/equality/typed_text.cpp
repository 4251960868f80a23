// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/typed_text.hpp"

#include <array>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "equality/tokens.hpp"

namespace magicmass::equality {
namespace {

constexpr std::size_t longest = 20000;
constexpr int deepest = 100;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

const std::map<std::string, std::string>& symbols() {
  static const std::map<std::string, std::string> table{
      {"cdot", "*"},         {"times", "*"},    {"ast", "*"},         {"div", "/"},
      {"le", "<="},          {"leq", "<="},     {"ge", ">="},         {"geq", ">="},
      {"ne", "!="},          {"neq", "!="},     {"left", ""},         {"right", ""},
      {"big", ""},           {"Big", ""},       {"bigl", ""},         {"bigr", ""},
      {"Bigl", ""},          {"Bigr", ""},      {"displaystyle", ""}, {"quad", " "},
      {"qquad", " "},        {"prime", "'"},    {"ln", "log"},        {"varepsilon", "epsilon"},
      {"vartheta", "theta"}, {"varphi", "phi"}, {"arcsin", "asin"},   {"arccos", "acos"},
      {"arctan", "atan"},    {"lbrace", "("},   {"rbrace", ")"},
  };
  return table;
}

const std::set<std::string>& names() {  // the command is the name
  static const std::set<std::string> set{
      "alpha", "beta",  "gamma",  "delta", "epsilon", "eta", "theta", "kappa", "lambda",
      "mu",    "nu",    "xi",     "rho",   "sigma",   "tau", "phi",   "chi",   "psi",
      "omega", "Gamma", "Lambda", "pi",    "sin",     "cos", "tan",   "sec",   "csc",
      "cot",   "sinh",  "cosh",   "tanh",  "exp",     "log"};
  return set;
}

class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::string whole() {
    const std::string result = until('\0');
    if (at_ < text_.size()) refuse("} without {");
    return result;
  }

private:
  [[noreturn]] void refuse(const std::string& reason) const { refuse_at(at_ + 1, reason); }

  std::string until(char end) {
    if (++depth_ > deepest) refuse("braces nested more than 100 deep");
    std::string result;
    while (at_ < text_.size() && text_[at_] != end) {
      const char c = text_[at_];
      if (c == '}') break;
      if (c == '{') {
        result += '(';
        result += group();
        result += ')';
      } else if (c == '\\') {
        result += command();
      } else if (c == '_') {
        ++at_;
        result += '_';
        result += index();
      } else {
        if (c != '$') result += c;
        ++at_;
      }
    }
    --depth_;
    return result;
  }

  std::string group() {  // {...}, the braces left out
    ++at_;
    std::string inside = until('}');
    if (at_ >= text_.size()) refuse("the } for a { is missing");
    ++at_;
    return inside;
  }

  std::string index() {  // of a name: _n, _{n}, _{\rm CM}
    if (at_ >= text_.size() || text_[at_] != '{') return {};
    std::string kept;
    for (const char c : group())
      if (is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_') kept += c;
    return kept;
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  std::string argument() {  // {..}, a command, or one character
    skip_blanks();
    if (at_ >= text_.size()) refuse("an argument is missing");
    if (text_[at_] == '{') return group();
    if (text_[at_] == '\\') return command();
    return std::string(1, text_[at_++]);
  }

  std::string command() {
    ++at_;
    if (at_ >= text_.size()) refuse("a backslash at the end");
    if (!is_letter(text_[at_])) {
      const char c = text_[at_++];
      if (c == '(' || c == ')' || c == '[' || c == ']') return "";  // \( ... \)
      if (c == '{' || c == '}' || c == ',' || c == ';' || c == '!' || c == ':' || c == ' ')
        return c == '{' ? "(" : c == '}' ? ")" : " ";
      refuse(c > ' ' && c <= '~' ? std::string("unknown command \\") + c
                                 : "a backslash before a character that is no command");
    }
    std::string name;
    while (at_ < text_.size() && is_letter(text_[at_])) name += text_[at_++];
    if (name == "frac" || name == "dfrac" || name == "tfrac") {
      const std::string above = argument();
      return "((" + above + ")/(" + argument() + "))";
    }
    if (name == "sqrt") return root();
    if (name == "text" || name == "mathrm" || name == "operatorname" || name == "rm")
      return name == "rm" ? "" : argument();
    if (const auto found = symbols().find(name); found != symbols().end())
      return found->second == "*" || found->second.empty() ? found->second : found->second + " ";
    if (!names().contains(name)) refuse("unknown command \\" + name);
    const bool is_indexed = at_ < text_.size() && (text_[at_] == '_' || text_[at_] == '\'');
    return " " + name + (is_indexed ? "" : " ");
  }

  std::string root() {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != '[') return " sqrt(" + argument() + ")";
    ++at_;
    const std::string order = until(']');
    if (at_ >= text_.size()) refuse("the ] for a [ is missing");
    ++at_;
    return " root(" + argument() + ", " + order + ")";
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::vector<std::string> split(const std::string& text, const std::string& separators) {
  std::vector<std::string> parts{""};
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth == 0 && separators.find(c) != std::string::npos)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

std::string without_environment(std::string text) {  // rows separated by ; and entries by ,
  for (const char* mark : {"\\begin", "\\end"})
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;) {
      const std::size_t close = text.find('}', at);
      if (close == std::string::npos) refuse_at(at + 1, "a } is missing");
      text.erase(at, close + 1 - at);
    }
  return replaced(replaced(text, "\\\\", ";"), "&", ",");
}

}  // namespace

std::string plain_text(std::string_view typed) {
  if (typed.size() > longest)
    throw NotAnExpression("longer than " + std::to_string(longest) + " characters");
  std::string text(typed);
  static const std::array<std::pair<const char*, const char*>, 7> spellings{{{"½", "(1/2)"},
                                                                             {"¼", "(1/4)"},
                                                                             {"¾", "(3/4)"},
                                                                             {"⅓", "(1/3)"},
                                                                             {"c^\\prime", "c'"},
                                                                             {"c^{\\prime}", "c'"},
                                                                             {"\\\\", " "}}};
  for (const auto& [from, to] : spellings) text = replaced(text, from, to);
  return Reader(text).whole();
}

std::vector<std::vector<std::string>> matrix_entries(std::string_view typed) {
  if (typed.size() > longest)
    throw NotAnExpression("longer than " + std::to_string(longest) + " characters");
  std::string text(typed);
  if (text.find("\\begin") != std::string::npos) text = without_environment(text);
  text = plain_text(text);
  for (const auto& [from, to] : {std::pair{"[", "("}, {"]", ")"}}) text = replaced(text, from, to);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  std::vector<std::string> rows;
  const std::size_t second =
      first == std::string::npos ? first : text.find_first_not_of(" \t\r\n", first + 1);
  if (second != std::string::npos && text[first] == '(' && text[second] == '(' &&
      typed.find('[') != std::string::npos) {  // ((a, b), (c, d)): the outer pair, then rows
    const std::size_t last = text.find_last_of(')');
    for (std::string row : split(text.substr(first + 1, last - first - 1), ",")) {
      const std::size_t open = row.find('(');
      const std::size_t close = row.rfind(')');
      if (open == std::string::npos || close == std::string::npos || close < open)
        throw NotAnExpression("a row is written [a, b, c]");
      rows.push_back(row.substr(open + 1, close - open - 1));
    }
  } else {
    for (const std::string& row : split(text, ";\n"))
      if (!is_blank(row)) rows.push_back(row);
  }
  std::vector<std::vector<std::string>> entries;
  for (const std::string& row : rows) {
    entries.push_back(split(row, ","));
    if (entries.back().size() != entries.front().size())
      throw NotAnExpression("row " + std::to_string(entries.size()) + " has " +
                            std::to_string(entries.back().size()) + " entries, row 1 has " +
                            std::to_string(entries.front().size()));
  }
  if (entries.empty()) throw NotAnExpression("a matrix is written [[a, b], [c, d]]");
  return entries;
}

}  // namespace magicmass::equality
