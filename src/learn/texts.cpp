// SPDX-License-Identifier: GPL-2.0-or-later
#include "learn/texts.hpp"

#include <sstream>

#include "magicmass/scenes/keys.hpp"

namespace learn {

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

std::string meant(const std::string& name, const Texts& names, const std::string& otherwise) {
  const std::string nearest = magicmass::scenes::nearest_name(name, names);
  return nearest.empty() ? otherwise : "; is " + nearest + " meant?";
}

}  // namespace learn
