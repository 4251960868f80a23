// SPDX-License-Identifier: MIT
// A theorem of the derivation, and a question of one's own. Needs magicmass::symbolic.
#include <iostream>

#include "derivation/derivation.hpp"
#include "equality/bounded.hpp"

int main() {
  const auto derivation = magicmass::derivation::derive();  // proves every step
  const auto& step = derivation.at("power.b").step();
  std::cout << step.from << " " << step.relation << " " << step.to << ": " << step.verdict << "\n";

  const auto verdict = magicmass::equality::answer_within({"sec(pi/5) - 1", "sqrt(5) - 2", {}});
  const bool equal = verdict.answer == magicmass::equality::Answer::equal;
  std::cout << (equal ? "equal" : "not equal") << "\n";
}
