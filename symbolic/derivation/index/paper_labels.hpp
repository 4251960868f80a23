// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

// What the paper states, and what here goes beyond it: the two lists behind `magicmass derive --list`. Which
// theorem proves what is not listed: that is read off the labels of the steps.
namespace magicmass::derivation {

/// A displayed equation or a table of the paper, by its label; one that has none, by its section's label and a
/// name: "app:Vn, Gamma_A".
struct PaperEquation {
  std::string_view label;             ///< "eq:Lambda"
  std::string_view place;             ///< "Sec. III B"
  std::string_view same_as = {};      ///< the label under which the paper states the same
  std::string_view not_claimed = {};  ///< why no theorem claims it
};

/// All of them, in the paper's order.
const std::vector<PaperEquation>& paper_equations();

/// A chapter or a single theorem that the paper does not have, and what it says.
struct BeyondPaper {
  std::string_view name;   ///< a chapter's or a theorem's
  std::string_view words;  ///< what it says
};
/// All of them, in the derivation's order.
const std::vector<BeyondPaper>& beyond_the_paper();

/// Where the paper says something in its text, without displaying it: "sec:comparison, projection".
struct PaperSection {
  std::string_view label;  ///< "sec:comparison, projection"
  std::string_view place;  ///< "Sec. III B"
};
/// All of them, in the paper's order.
const std::vector<PaperSection>& paper_sections();

/// A step's label is this listed one, or a part of it: "table:trig, cos psi", "sec:nhx, sin 1/2".
bool speaks_of(std::string_view label, std::string_view listed);

/// "eq:Lam-G-G, Lam-GAM" as two labels, "app:Vn, Gamma_A" as one: a label has a colon, or the list has it.
std::vector<std::string> split_labels(const std::string& labels);

}  // namespace magicmass::derivation
