// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "derivation/laws.hpp"
#include "derivation/paper.hpp"
#include "proof/kernel.hpp"
#include "proof/theorem.hpp"

namespace magicmass::derivation {

/// Everything that was derived, in order, up to the end or to the first step that was refused.
struct Derivation {
  std::vector<proof::Theorem> theorems;     ///< in the order of their proofs
  std::optional<proof::NotProved> refused;  ///< the first step that did not hold, if one did not

  /// Throws InvalidInput for an id that is not there.
  const proof::Theorem& at(const std::string& id) const;
};

/// The chapters' names in order: "contact", "cycle", ...
const std::vector<std::string>& chapter_names();

/// Laws in, theorems out. Never throws NotProved: see Derivation::refused.
Derivation derive(const Laws& laws, const Paper& paper);
Derivation derive();  ///< the real laws, the paper as printed
/// No further than to the end of this chapter. Throws InvalidInput for one that is not there.
Derivation derive_up_to(const std::string& chapter);

/// The derivation up to a chapter, to be gone on with: the tests spoil one formula after another and need
/// not prove again what comes before it.
class Beginning {
public:
  /// Throws InvalidInput for a chapter that is not there, NotProved when a step before it is refused.
  Beginning(const std::string& next_chapter, const Laws& laws, const Paper& paper);
  Beginning(const Laws& laws, const Paper& paper);  ///< all chapters
  /// Goes on to the end. Never throws NotProved.
  Derivation completed(const Laws& laws, const Paper& paper) const;
  /// No further than to the end of this chapter. Throws InvalidInput for one that is not there.
  Derivation up_to(const std::string& chapter, const Laws& laws, const Paper& paper) const;
  /// What is proved so far.
  const proof::Kernel& kernel() const;

private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace magicmass::derivation
