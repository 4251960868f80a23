// SPDX-License-Identifier: GPL-2.0-or-later
// The header that computes what was asked for and nothing else: by the names of quantities, or for a scene.
#pragma once

#include <string>
#include <vector>

#include "codegen/generate.hpp"
#include "proof/theorem.hpp"

namespace magicmass::command {

/// "a_t,rho": quantities of one set of inputs. Throws InvalidInput for a name that is none, with the nearest, and where inputs differ.
codegen::GeneratedFile header_of_quantities(const std::string& names,
                                            const std::vector<proof::Theorem>& theorems);

/// What the outputs of a scene file need, a function for each set of inputs. Throws InvalidInput as read_scene does.
codegen::GeneratedFile header_of_scene(const std::string& path,
                                       const std::vector<proof::Theorem>& theorems);

}  // namespace magicmass::command
