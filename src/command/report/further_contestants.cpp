// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/further_contestants.hpp"

#include "command/report/ginac_contestants.hpp"
#include "command/report/sympy_contestants.hpp"
#include "derivation/derivation.hpp"

namespace magicmass::command {

std::vector<report::Contestant> further_contestants(bool peers,
                                                    const std::vector<std::string>& quantities,
                                                    std::vector<std::string>& remarks) {
  const derivation::Derivation derivation = derivation::derive();
  if (derivation.refused) {
    remarks.push_back(std::string("skipped: GiNaC and peers, because ") +
                      derivation.refused->what());
    return {};
  }
  std::vector<report::Contestant> all = ginac_contestants(derivation.theorems, quantities, remarks);
  if (peers)
    for (report::Contestant& one : sympy_contestants(derivation.theorems, quantities, remarks))
      all.push_back(std::move(one));
  return all;
}

}  // namespace magicmass::command
