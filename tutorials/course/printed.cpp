// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/printed.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "course/refusal.hpp"

namespace magicmass::course {
namespace {

bool is_name(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](unsigned char letter) {
           return std::isalnum(letter) != 0 || letter == '_';
         });
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos
             ? ""
             : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

}  // namespace

std::vector<Printed> read_printed(const std::string& output,
                                  const std::string& program) {
  std::vector<Printed> all;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.starts_with("  ") && !all.empty() && all.back().is_block) {
      all.back().lines.push_back(line.substr(2));
      continue;
    }
    const auto colon = line.find(':');
    const std::string name = line.substr(0, colon);
    if (colon == std::string::npos || !is_name(name))
      throw Refusal(program + ": printed \"" + line +
                    "\"; allowed are \"name: value\", \"name:\" above indented "
                    "lines, and \"# ...\"");
    if (std::any_of(all.begin(), all.end(),
                    [&](const Printed& p) { return p.name == name; }))
      throw Refusal(program + ": printed the name " + name + " twice");
    const std::string value = trimmed(line.substr(colon + 1));
    all.push_back({.name = name, .value = value, .is_block = value.empty()});
  }
  return all;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::size_t from = 0;
  for (std::size_t bar = 0; bar != std::string::npos; from = bar + 3) {
    bar = line.find(" | ", from);
    result.push_back(
        trimmed(line.substr(from, bar == std::string::npos ? bar : bar - from)));
    if (bar == std::string::npos) break;
  }
  return result;
}

}  // namespace magicmass::course
