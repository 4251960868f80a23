// SPDX-License-Identifier: GPL-2.0-or-later
#include "learn/spelling.hpp"

#include "answers/shown_text.hpp"
#include "notation/tokens.hpp"
#include "notation/typed.hpp"

namespace learn {

Texts parts(const std::string& text, char separator) {
  Texts all{""};
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view brackets = "([{)]}";
    const std::size_t bracket = brackets.find(text[i]);
    depth += bracket == brackets.npos ? 0 : bracket < 3 ? 1 : -1;
    if (text[i] == separator && depth == 0) {
      all.emplace_back();
      continue;
    }
    all.back() += text[i];
    if (text[i] == '\\' && i + 1 < text.size()) all.back() += text[++i];  // \; is a space
  }
  return all;
}

namespace {
/// The inside of parentheses around all of it; else nothing.
std::string inside(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  if (begin == text.npos || text[begin] != '(' || text[end] != ')') return {};
  const std::string within = text.substr(begin + 1, end - begin - 1);
  int depth = 0;
  for (const char c : within)
    if ((depth += c == '(' ? 1 : c == ')' ? -1 : 0) < 0) return {};
  return within;
}
}  // namespace

std::string bracketed(const std::string& text, bool is_column) {
  const std::string within = inside(text);
  Texts rows = parts(within, ';');
  if (rows.size() == 1 && is_column) rows = parts(within, ',');
  if (rows.size() == 1) rows = parts(text, ';');
  if (rows.size() == 1 && is_column && parts(text, ',').size() > 1)
    kernel::refuse("a column is written with semicolons: [a; b; c]");
  if (rows.size() == 1) return text;
  return "[[" + answers::joined(rows, "], [") + "]]";
}

std::string parted(const std::string& word, const std::set<std::string>& names) {
  if (names.contains(word)) return word;
  for (const std::string& name : names) {
    if (!word.starts_with(name)) continue;
    const std::string rest = parted(word.substr(name.size()), names);
    if (!rest.empty()) return name + " " + rest;
  }
  return {};
}

std::string with_spaces(const std::string& text, const std::set<std::string>& names, Texts& notes) {
  std::string all, word, plain;
  for (const char c : text + " ") {
    const bool is_letter = (c | 0x20) >= 'a' && (c | 0x20) <= 'z';
    const bool is_brace =
        (c == '{' && word.ends_with('_')) || (c == '}' && plain.size() < word.size());
    if (is_letter || is_brace || (!word.empty() && (c == '_' || (c >= '0' && c <= '9')))) {
      word += c;
      if (!is_brace) plain += c;
      continue;
    }
    const std::string apart = plain.find('_') == plain.npos ? "" : parted(plain, names);
    if (apart.find(' ') != apart.npos) {
      notes.push_back(word + " is read as " + apart);
      word = apart;
    }
    all += word + c;
    word = plain = "";
  }
  all.pop_back();
  return all;
}

std::string unit(const std::string& text, const std::set<std::string>& symbols) {
  static const std::set<std::string> units{"m", "cm", "km", "s",   "ms",      "h",       "kg",
                                           "g", "J",  "N",  "rad", "seconds", "degrees", "meters"};
  std::vector<notation::Token> words = notation::tokens(text);
  words.pop_back();  // the end
  std::erase_if(words, [](const auto& word) { return word.text == "{" || word.text == "}"; });
  const auto is_unit = [&](std::size_t i) {
    return units.contains(words[i].text) && !symbols.contains(words[i].text);
  };
  std::size_t first = words.size();
  if (first > 2 && words[first - 2].text == "^") first -= 2;  // m/s^2
  const std::size_t last = first;
  while (first > 0 && is_unit(first - 1))
    first -= first > 2 && words[first - 2].text == "/" && is_unit(first - 3) ? 2 : 1;
  if (first == 0 || first == last) return {};
  const notation::Token& before = words[first - 1];
  if (before.kind == notation::Token::Kind::Sign && before.text != ")") return {};
  std::string all;
  for (std::size_t i = first; i < words.size(); ++i) all += words[i].text;
  return all;
}

}  // namespace learn
