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
  derivation::PaperEquation equation;
  std::vector<std::string> theorems;  // ids; for a repeated equation those of the other label
};

/// A result beyond the paper, with its theorems: the one, or those of a chapter that nothing else in it rests on.
struct IndexedResult {
  derivation::BeyondPaper result;
  std::vector<std::string> theorems;
};

/// What the paper says in its text: the label with its section's, and the theorems that carry it.
struct IndexedRemark {
  std::string label;
  std::string place;
  std::vector<std::string> theorems;
};

struct TheoremIndex {
  std::vector<proof::Step> steps;
  std::vector<IndexedEquation> equations;  // in the paper's order
  std::vector<IndexedRemark> in_the_text;
  std::vector<IndexedResult> beyond;
};

TheoremIndex theorem_index(const std::vector<proof::Step>& steps);

/// "same as eq:ac", the reason why nothing claims it, or "not proved yet"; empty for what is proved under its own label.
std::string remark(const IndexedEquation& indexed);

std::string index_text(const TheoremIndex& index, const TextStyle& style);  ///< 80 columns
std::string index_markdown(const TheoremIndex& index);
std::string index_html(const TheoremIndex& index);
/// {theorems: [{id, verdict, labels}], equations: [{label, place, theorems, remark}], beyond: [{name, words, theorems}]}
std::string index_json(const TheoremIndex& index);
/// One line an equation of the paper.
std::string index_csv(const TheoremIndex& index);

}  // namespace magicmass::render
