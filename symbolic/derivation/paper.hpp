// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>

#include "proof/statement.hpp"

namespace magicmass::derivation {

/// The equations that Ee & Lee display, as they stand in the paper, by label. They are claims to be proved
/// equal to what the laws give; no result is taken from here. Equations without a label of their own go
/// by the section's label and a name: "app:Vn, Gamma_A".
class Paper {
public:
  /// By their labels.
  explicit Paper(std::map<std::string, proof::Statement> equations)
      : equations_(std::move(equations)) {}

  /// Throws InvalidInput for a label that is not there.
  const proof::Statement& at(const std::string& label) const;
  /// All of them, by label.
  const std::map<std::string, proof::Statement>& equations() const { return equations_; }

private:
  std::map<std::string, proof::Statement> equations_;
};

/// All of them as the paper has them.
Paper paper();

/// The same by the chapter of the derivation that proves them.
const std::map<std::string, std::map<std::string, proof::Statement>>& paper_chapters();

}  // namespace magicmass::derivation
