// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/factored.hpp"

namespace magicmass::proof {

GiNaC::ex factored(const GiNaC::ex& polynomial) {
  constexpr std::size_t most = 4096;  // a bound on memory, larger than what the derivation needs
  static GiNaC::exmap known;
  if (const auto found = known.find(polynomial); found != known.end()) return found->second;
  if (known.size() == most) known.clear();
  return known[polynomial] = GiNaC::factor(polynomial);
}

}  // namespace magicmass::proof
