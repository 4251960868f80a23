// SPDX-License-Identifier: GPL-2.0-or-later
#include <regex>
#include <sstream>

#include "learn/exercise.hpp"
#include "magicmass/scenes/keys.hpp"

namespace learn {
namespace {

/// Each once. No other file includes <regex>, which takes seconds to compile.
const std::regex& compiled(const std::string& pattern) {
  static std::map<std::string, std::regex> all;
  return all.try_emplace(pattern, pattern).first->second;
}

}  // namespace

Texts fields(const std::string& text, char separator) {
  std::istringstream stream(text);
  Texts all;
  for (std::string field; std::getline(stream, field, separator);) all.push_back(field);
  return all;
}

Texts split(const std::string& text, char separator) {
  constexpr const char* blanks = " \t\r";
  Texts parts;
  for (const std::string& part : fields(text, separator))
    if (const std::size_t begin = part.find_first_not_of(blanks); begin != part.npos)
      parts.push_back(part.substr(begin, part.find_last_not_of(blanks) + 1 - begin));
  return parts;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

Texts matched(const std::string& text, const std::string& pattern) {
  std::smatch part;
  if (!std::regex_match(text, part, compiled(pattern))) return {};
  return {part.begin(), part.end()};
}

std::string replaced(const std::string& text, const std::string& pattern,
                     const std::function<std::string(const Texts& part)>& by) {
  std::string out;
  auto rest = text.begin();
  for (std::sregex_iterator it(rest, text.end(), compiled(pattern)), end; it != end; ++it) {
    out.append(rest, it->prefix().second).append(by({it->begin(), it->end()}));
    rest = it->suffix().first;
  }
  return out.append(rest, text.end());
}

std::string meant(const std::string& name, const Texts& names, const std::string& otherwise) {
  const std::string nearest = magicmass::scenes::nearest_name(name, names);
  return nearest.empty() ? otherwise : "; is " + nearest + " meant?";
}

}  // namespace learn
