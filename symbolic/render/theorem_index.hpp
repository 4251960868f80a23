// SPDX-License-Identifier: GPL-2.0-or-later
// Which theorem proves which equation of the paper, read off the steps' labels.
#pragma once

#include <string>
#include <vector>

#include "derivation/index/paper_labels.hpp"
#include "proof/theorem.hpp"
#include "render/formula_text.hpp"

namespace magicmass::render {

/// An equation of the paper with what speaks of it.
struct IndexedEquation {
  derivation::PaperEquation equation;  ///< the paper's
  std::vector<std::string> theorems;   ///< ids; for a repeated equation those of the other label
};

/// A result beyond the paper, with its theorems: the one, or those of a chapter that nothing else in it rests on.
struct IndexedResult {
  derivation::BeyondPaper result;     ///< what goes beyond the paper
  std::vector<std::string> theorems;  ///< ids
};

/// What the paper says in its text: the label with its section's, and the theorems that carry it.
struct IndexedRemark {
  std::string label;                  ///< "sec:comparison, projection"
  std::string place;                  ///< "Sec. III B"
  std::vector<std::string> theorems;  ///< ids
};

/// The index as a whole.
struct TheoremIndex {
  std::vector<proof::Step> steps;          ///< every step of the derivation
  std::vector<IndexedEquation> equations;  ///< in the paper's order
  std::vector<IndexedRemark> in_the_text;  ///< in the paper's order
  std::vector<IndexedResult> beyond;       ///< in the derivation's order
};

/// Made from the steps' labels.
TheoremIndex theorem_index(const std::vector<proof::Step>& steps);

/// "the same as eq:ac", "not claimed: " and why, or "not proved yet"; empty for what is proved under its own label.
std::string remark(const IndexedEquation& indexed);

std::string index_text(const TheoremIndex& index, const TextStyle& style);  ///< 80 columns
/// A document of its own.
std::string index_markdown(const TheoremIndex& index);
/// A page of its own.
std::string index_html(const TheoremIndex& index);
/// {theorems: [{id, verdict, labels}], equations: [{label, place, theorems, remark}], beyond: [{name, words, theorems}]}
std::string index_json(const TheoremIndex& index);
/// One line an equation of the paper.
std::string index_csv(const TheoremIndex& index);

}  // namespace magicmass::render
