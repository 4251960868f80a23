// SPDX-License-Identifier: GPL-2.0-or-later
// The labels are those of the paper's source, which is not in this repository:
//   sed 's/%.*//' magic-mass-ratios.tex | grep -oE '\\(begin\{(equation|eqnarray)\}|label\{[^}]*\})'
// A displayed equation without a label was given a name by hand.
#include "derivation/index/paper_labels.hpp"

#include <algorithm>

namespace magicmass::derivation {
namespace {

constexpr std::string_view printed_decimals =
    "decimal values: `magicmass ratios --digits` computes certified ones, and the demo compares "
    "every digit that is printed";

}  // namespace

const std::vector<PaperEquation>& paper_equations() {
  static const std::vector<PaperEquation> equations{
      {"NA-range", "Sec. II B"},
      {"NB-range", "Sec. II B"},
      {"def:Vn", "Sec. III A", {}, "names a column; the theorems about V_n have its components"},
      {"eq:conservation", "Sec. III B", "eq:ac"},
      {"eq:ac", "Sec. III B"},
      {"eq:Euc-Pn", "Sec. III B"},
      {"eq:bcp", "Sec. III B"},
      {"eq:Euc-Qn", "Sec. III B"},
      {"eq:energy-conservation-PnQn", "Sec. III B"},
      {"eq:Euc-Pn-linear", "Sec. III B"},
      {"eq:Euc-Qn-linear", "Sec. III B"},
      {"eq:V2", "Sec. III B"},
      {"eq:V-n", "Sec. III B"},
      {"eq:V-n-0", "Sec. III B"},
      {"eq:Lam-G-G", "Sec. III D"},
      {"sec:Lambda, Gamma_A", "Sec. III D", "app:Vn, Gamma_A"},
      {"sec:Lambda, Gamma_B", "Sec. III D", "app:Vn, Gamma_B"},
      {"theta-txt", "Sec. III D"},
      {"eq:Lambda", "Sec. III D"},
      {"eq:Lambda-n-final-txt", "Sec. III E"},
      {"def:psi", "Sec. III E"},
      {"sec:Lambda-n, R", "Sec. III E", "eq:R-app"},
      {"eq:a-final", "Sec. IV"},
      {"eq:b-final", "Sec. IV"},
      {"eq:c-final", "Sec. IV"},
      {"eq:c'-final", "Sec. IV"},
      {"sec:result, V_CM", "Sec. IV"},
      {"eq:NANB-ans-txt", "Sec. IV"},
      {"eq:Naatcritical", "Sec. IV"},
      {"eq:Nbatcritical", "Sec. IV"},
      {"exact:ak", "Sec. IV"},
      {"exact:bk", "Sec. IV"},
      {"eq:a-terminal", "Sec. IV"},
      {"eq:b-terminal", "Sec. IV"},
      {"eq:ct", "Sec. IV"},
      {"sec:result, inelastic P momentum", "Sec. IV"},
      {"sec:result, inelastic P restitution", "Sec. IV"},
      {"sec:result, inelastic Q momentum", "Sec. IV"},
      {"sec:result, inelastic Q restitution", "Sec. IV"},
      {"app:orthogonal, lambda", "App. A"},
      {"eq:lambda-1", "App. A"},
      {"eq:lambda-2", "App. A"},
      {"eq:lambda-3", "App. A"},
      {"eq:lambda-n", "App. A"},
      {"def:R", "App. A"},
      {"eq:abc-n", "App. B"},
      {"eq:abcp-n", "App. B"},
      {"eq:Gamma", "App. B"},
      {"def:gamma", "App. B"},
      {"def:theta", "App. B"},
      {"eq:V-n-app", "App. B"},
      {"eq:V-n-0-app", "App. B"},
      {"Lam-GAM", "App. B"},
      {"app:Vn, Gamma_A", "App. B"},
      {"app:Vn, Gamma_B", "App. B"},
      {"eq:Lambda-app", "App. B"},
      {"eq-app:lambda-R", "App. C"},
      {"app:lam-n, power", "App. C", "eq:Lambda-n-final"},
      {"app:lam-n, Lambda", "App. C"},
      {"eq:Lambda-n-final", "App. C"},
      {"app:lam-n, invariant axis", "App. C"},
      {"app:lam-n, axis", "App. C"},
      {"eq:R-app", "App. C"},
      {"def:psi-app", "App. C"},
      {"sec:nx, cos", "App. D 1"},
      {"sec:nx, sin", "App. D 1"},
      {"sec:nhx, cos", "App. D 2"},
      {"sec:nhx, sin", "App. D 2"},
      {"def:ceil", "App. E"},
      {"def:floor", "App. E"},
      {"def:sawtooth", "App. E"},
      {"eq:NA-constraint", "App. E"},
      {"eq:NA-constraint-simple", "App. E"},
      {"eq:NA-ans", "App. E"},
      {"eq:NB-constraint", "App. E"},
      {"eq:NB-constraint-simple", "App. E"},
      {"eq:NB-ans", "App. E"},
      {"eq:NANB-ans", "App. E"},
      {"eq:NA-approx", "App. E"},
      {"eq:magic-b-cond", "App. F"},
      {"eq:magic-b-cond-simple", "App. F"},
      {"app:deficient, momentum", "App. G"},
      {"app:deficient, energy", "App. G"},
      {"app:deficient, a_t", "App. G"},
      {"eq:defb-terminal", "App. G"},
      {"eq:def-b-cond", "App. G"},
      {"app:deficient, N_B", "App. G"},
      {"table:trig", "Table I"},
      {"table:akbk", "Table II", {}, printed_decimals},
  };
  return equations;
}

const std::vector<BeyondPaper>& beyond_the_paper() {
  static const std::vector<BeyondPaper> results{
      {"rotation.psi_half_angle", "psi without overflow and without cancellation"},
      {"power.a_product", "a_n as a product: its zeros and its sign can be read off"},
      {"power.b_product", "b_n as a product"},
      {"power.c_product", "c_n as a product"},
      {"power.c_prime_product", "c'_n as a product"},
      {"chebyshev", "velocities as polynomials in cos(psi/2): rational functions of alpha"},
      {"counting.N", "the number of all collisions in one formula"},
      {"ratios.alpha_k_stable", "magic ratios without cancellation"},
      {"ratios.beta_k_stable", "deficient ratios without cancellation"},
      {"minima.least", "B never gets less than it would share with C at one velocity"},
      {"minima.rises", "between a deficient and the next magic ratio b_t rises, without calculus"},
      {"small_alpha.psi_further", "further terms of psi for light balls"},
      {"small_alpha.cycles_further", "and of the number of cycles"},
      {"unfolding", "times and distances from one straight line"},
      {"chain", "transfer through a chain of balls of any magic ratios, and back from a wall"},
      {"restitution.energy_lost", "how much energy a contact with restitution e loses"},
      {"restitution.characteristic", "the eigenvalues of one inelastic cycle"},
      {"wedge", "any three masses, any restitution, or a wall: speeds, times, distances, count"},
      {"special_cases",
       "equal blocks, elastic contacts and the wall as cases of the wedge theorem; the digits of "
       "pi"},
      {"collapse", "where the collisions never end, and in what time"},
      {"inelastic_end", "terminal velocities with restitution, and the time of the collapse"},
      {"times", "when each collision happens, and how far apart the blocks are then"},
  };
  return results;
}

const std::vector<PaperSection>& paper_sections() {
  static const std::vector<PaperSection> sections{
      {"subsec:model", "Sec. II A"},
      {"subsec:term", "Sec. II B"},
      {"subsec:conjecture", "Sec. II C"},
      {"subsec:Euclid", "Sec. III A"},
      {"sec:rec", "Sec. III B"},
      {"sec:comparison", "Sec. III C"},
      {"sec:Lambda", "Sec. III D"},
      {"sec:Lambda-n", "Sec. III E"},
      {"sec:result", "Sec. IV"},
      {"app:orthogonal", "App. A"},
      {"app:Vn", "App. B"},
      {"app:lam-n", "App. C"},
      {"sec:nx", "App. D 1"},
      {"sec:nhx", "App. D 2"},
      {"sec:N-app", "App. E"},
      {"app:magic", "App. F"},
      {"app:deficient", "App. G"},
  };
  return sections;
}

bool speaks_of(std::string_view label, std::string_view listed) {
  if (!label.starts_with(listed)) return false;
  const std::string_view rest = label.substr(listed.size());
  return rest.empty() || rest.starts_with(' ') || rest.starts_with(", ");
}

std::vector<std::string> split_labels(const std::string& labels) {
  const auto is_label = [](std::string_view label) {
    const auto& all = paper_equations();
    return label.find(':') != std::string_view::npos ||
           std::any_of(all.begin(), all.end(),
                       [&](const PaperEquation& equation) { return equation.label == label; });
  };
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin < labels.size();) {
    const std::size_t end = std::min(labels.find(", ", begin), labels.size());
    const std::string label = labels.substr(begin, end - begin);
    if (result.empty() || is_label(label))
      result.push_back(label);
    else
      result.back() += ", " + label;
    begin = end + 2;
  }
  return result;
}

}  // namespace magicmass::derivation
