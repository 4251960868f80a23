// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/steps.hpp"

#include <algorithm>

namespace magicmass::render {
std::vector<proof::Step> steps_of(const derivation::Derivation& derivation) {
  std::vector<proof::Step> steps;
  for (const proof::Theorem& theorem : derivation.theorems) steps.push_back(theorem.step());
  if (derivation.refused) steps.push_back(derivation.refused->step);
  return steps;
}

std::string chapter_of(const proof::Step& step) { return step.id.substr(0, step.id.find('.')); }

std::size_t count_verdict(const std::vector<proof::Step>& steps, const std::string& verdict) {
  return static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(),
                    [&](const proof::Step& step) { return step.verdict == verdict; }));
}

}  // namespace magicmass::render
