// SPDX-License-Identifier: GPL-2.0-or-later
// The header that computes what was asked for and nothing else: by the names of quantities, or for a scene.
#pragma once

#include <string>
#include <vector>

#include "codegen/generate.hpp"
#include "codegen/specialised.hpp"
#include "proof/theorem.hpp"

namespace magicmass::command {

/// What the header is to hold: known before anything is derived.
struct SpecialisedHeader {
  std::vector<codegen::QuantityGroup> groups;
  std::string scope;    ///< a namespace of its own; empty: none
  std::string made_by;  ///< the command that writes it
  std::string words;    ///< what it computes

  codegen::GeneratedFile file(const std::vector<proof::Theorem>& theorems) const {
    return codegen::specialised_header(groups, scope, made_by, {words}, theorems);
  }
};

/// "a_t,rho": quantities of one set of inputs. Throws InvalidInput for a name that is none, with the nearest, and where inputs differ.
SpecialisedHeader header_of_quantities(const std::string& names);

/// What the outputs of a scene file need, a function for each set of inputs. Throws InvalidInput as read_scene does.
SpecialisedHeader header_of_scene(const std::string& path);

}  // namespace magicmass::command
