// SPDX-License-Identifier: GPL-2.0-or-later
// Ids to theorems.
#include "generate/source.hpp"

#include <sstream>

namespace generate {
kernel::Theorems Source::operator()(const std::string& words) {
  kernel::Theorems out;
  std::istringstream in(words);
  std::string chapter;
  for (std::string word; in >> word;) {
    const std::size_t dot = word.find('.');
    if (dot != std::string::npos) chapter = word.substr(0, dot + 1);
    const std::string name = word.substr(dot == std::string::npos ? 0 : dot + 1);
    const std::size_t slash = name.find('/');
    const std::string id = chapter + name.substr(0, slash);
    kernel::Theorem t = derivation::the_book()[id];
    if (slash != std::string::npos) {
      t = kernel::tautology(t.conclusion().arg(std::stoul(name.substr(slash + 1))), {t});
    }
    out.push_back(kernel::instantiate(t, units));
    ids.insert({out.back().conclusion(), id});
  }
  return out;
}
}  // namespace generate
