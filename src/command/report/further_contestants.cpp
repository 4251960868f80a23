// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/further_contestants.hpp"

#include "command/report/ginac_contestants.hpp"
#include "command/report/own_function.hpp"
#include "command/report/sympy_contestants.hpp"
#include "derivation/derivation.hpp"

namespace magicmass::command {

std::vector<DerivedForm> forms_from_derivation(const std::vector<std::string>& quantities,
                                               std::vector<std::string>& remarks) {
  const derivation::Derivation derivation = derivation::derive();
  if (!derivation.refused) return derived_forms(derivation.theorems, quantities);
  remarks.push_back(std::string("skipped: GiNaC and peers, because ") + derivation.refused->what());
  return {};
}

std::vector<report::Contestant> further_contestants(const std::vector<DerivedForm>& forms,
                                                    const ReportRequest& request,
                                                    std::vector<std::string>& remarks) {
  std::vector<report::Contestant> all = ginac_contestants(forms, remarks);
  if (request.peers)
    for (report::Contestant& one : sympy_contestants(forms, remarks)) all.push_back(std::move(one));
  if (!request.function.empty()) all.push_back(own_function(request.function));
  return all;
}

}  // namespace magicmass::command
