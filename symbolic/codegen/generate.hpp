// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "proof/theorem.hpp"

namespace magicmass::codegen {

/// A file as it is to be written.
struct GeneratedFile {
  std::string path;     ///< below generated/: "magicmass/velocities_product.hpp", "manifest.json"
  std::string content;  ///< all of it
};

/// Every file of generated/, from theorems alone, in order of path; the same bytes on every run.
/// Throws InvalidInput when a theorem that a form needs is not among them.
std::vector<GeneratedFile> generate(const std::vector<proof::Theorem>& theorems);

}  // namespace magicmass::codegen
