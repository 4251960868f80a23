// SPDX-License-Identifier: GPL-2.0-or-later
// The paper's labels, so that none is forgotten.
#pragma once
#include <string>
#include <vector>

namespace derivation {
struct PaperLabel {
  std::string label;
  std::string reason;  ///< why no statement has it; empty: some statement has
};
/// The labels of all equations and tables of the paper, of two sections whose equations have
/// none of their own (sec:nx, sec:nhx), and the one label that the paper's source has in a comment
/// (eq:inelastic, of four equations), in its order.
std::vector<PaperLabel> paper_labels();
}  // namespace derivation
