// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/source.hpp"

namespace generate {
using kernel::Theorem;
using kernel::Theorems;

Theorem Source::taken(const std::string& id, const Theorem& t) {
  const Theorem special = kernel::instantiate(t, units);
  ids.insert({special.conclusion(), id});
  return special;
}
Theorem Source::part(const std::string& id, std::size_t i) {
  const Theorem t = book[id];
  return taken(id, kernel::tautology(t.conclusion().arg(i), {t}));
}
Theorems Source::all(const std::string& chapter, std::initializer_list<const char*> names) {
  Theorems out;
  for (const char* name : names) out.push_back((*this)[chapter + "." + name]);
  return out;
}
Theorems operator+(Theorems a, const Theorems& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
}  // namespace generate
