// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/paper.hpp"

#include <sstream>

namespace derivation {
std::vector<PaperLabel> paper_labels() {
  std::istringstream with_statements(
      "NA-range NB-range def:Vn eq:conservation eq:ac eq:Euc-Pn eq:bcp eq:Euc-Qn "
      "eq:energy-conservation-PnQn eq:Euc-Pn-linear eq:Euc-Qn-linear eq:V2 eq:V-n eq:V-n-0 "
      "eq:Lam-G-G theta-txt eq:Lambda eq:Lambda-n-final-txt def:psi eq:a-final eq:b-final "
      "eq:c-final eq:c'-final eq:NANB-ans-txt eq:Naatcritical eq:Nbatcritical exact:ak "
      "exact:bk eq:a-terminal eq:b-terminal eq:ct eq:inelastic eq:lambda-1 eq:lambda-2 eq:lambda-3 "
      "eq:lambda-n def:R eq:abc-n eq:abcp-n eq:Gamma def:gamma def:theta eq:V-n-app "
      "eq:V-n-0-app Lam-GAM eq:Lambda-app eq-app:lambda-R eq:Lambda-n-final eq:R-app "
      "def:psi-app sec:nx sec:nhx def:ceil def:floor def:sawtooth eq:NA-constraint "
      "eq:NA-constraint-simple eq:NA-ans eq:NB-constraint eq:NB-constraint-simple "
      "eq:NB-ans eq:NANB-ans eq:NA-approx eq:magic-b-cond eq:magic-b-cond-simple "
      "eq:defb-terminal eq:def-b-cond table:trig");
  std::vector<PaperLabel> out;
  for (std::string label; with_statements >> label;) out.push_back({label, ""});
  out.push_back({"table:akbk", "decimals, computed from the formulas of exact:ak and exact:bk"});
  return out;
}
}  // namespace derivation
