// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derivation/laws.hpp"
#include "derivation/paper.hpp"
#include "proof/theorem.hpp"

namespace magicmass::derivation {

// Everything that was derived, in order, up to the end or to the first step that was refused.
struct Derivation {
  std::vector<proof::Theorem> theorems;
  std::optional<proof::NotProved> refused;

  // Throws std::out_of_range for an id that is not there.
  const proof::Theorem& at(const std::string& id) const;
};

// The chapters' names in order: "contact", "cycle", ...
const std::vector<std::string>& chapter_names();

// Laws in, theorems out. Never throws NotProved: see Derivation::refused.
Derivation derive(const Laws& laws, const Paper& paper);
Derivation derive();  // the real laws, the paper as printed

}  // namespace magicmass::derivation
