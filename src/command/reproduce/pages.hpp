// SPDX-License-Identifier: GPL-2.0-or-later
// Figures and comparisons as pages. Figures are named as they lie beside the page: counts.svg, counts.png, ...
#pragma once

#include <string>
#include <vector>

#include "command/reproduce/comparison.hpp"

namespace magicmass::command {

struct ShownFigure {
  std::string name;
  std::string title;
  std::string description;
};

/// A page of well-formed XML that needs no network and no script; links to cradle.html, too.
std::string reproduction_html(const std::vector<ComparisonSection>& sections,
                              const std::vector<ShownFigure>& figures);
std::string reproduction_markdown(const std::vector<ComparisonSection>& sections,
                                  const std::vector<ShownFigure>& figures);
/// section, place, quantity, paper, ours, verdict, reason.
std::string comparison_csv(const std::vector<ComparisonSection>& sections);

}  // namespace magicmass::command
