// SPDX-License-Identifier: GPL-2.0-or-later
// The derivation for a reader (text, Markdown, LaTeX, HTML) and for a program (JSON).
#pragma once

#include <string>
#include <vector>

#include "proof/theorem.hpp"
#include "render/formula_text.hpp"
#include "render/premises.hpp"

namespace magicmass::render {

/// A verdict, coloured where `colourful`.
std::string verdict_text(const std::string& verdict, bool colourful);

/// A step's words, with the symbols among them as symbols where there is Unicode; for wrapped(), which keeps its
/// formulas on one line.
std::string prose_text(const std::string& words, const TextStyle& style);

/// Chapter by chapter, each step with its words, equation, conditions, label, rule, premises and verdict; 80 columns.
std::string derivation_text(const std::vector<proof::Step>& steps, const TextStyle& style);
/// What something rests on, with the equations; 80 columns unless it is deeper than 25 levels.
std::string tree_text(const std::vector<TreeLine>& tree, const TextStyle& style);

/// The same as documents of their own. A tree that is not empty goes in front.
std::string derivation_markdown(const std::vector<proof::Step>& steps,
                                const std::vector<TreeLine>& tree = {});
/// For pdflatex.
std::string derivation_latex(const std::vector<proof::Step>& steps,
                             const std::vector<TreeLine>& tree = {});
/// One page with MathML, nothing loaded from elsewhere.
std::string derivation_html(const std::vector<proof::Step>& steps,
                            const std::vector<TreeLine>& tree = {});

/// An array of objects: id, rule, from, relation, to, conditions, label, words, verdict, premises, statement, latex.
std::string derivation_json(const std::vector<proof::Step>& steps);

/// The laws in full, then a chapter at a time its counts and main theorems; 80 columns.
std::string derivation_summary(const std::vector<proof::Step>& steps, const TextStyle& style);

}  // namespace magicmass::render
