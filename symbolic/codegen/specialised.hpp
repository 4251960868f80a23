// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "codegen/generate.hpp"
#include "proof/theorem.hpp"

// Headers that compute what was asked for and nothing else.
namespace magicmass::codegen {

/// What may be asked for, by its name in the paper.
struct PaperQuantity {
  std::string name;    ///< "a_t", "alpha_k"
  std::string inputs;  ///< "alpha and n"; those of one kernel have the same
  std::string kernel;  ///< "terminal": its row in kernel_forms()
  std::string
      member;  ///< of that kernel's outputs; empty for a count, which decides and is not computed
  std::string words;  ///< "velocity of A after the last collision, in units of V"
};
/// All of them, in the order in which `generate --quantity` lists them.
const std::vector<PaperQuantity>& paper_quantities();

/// Quantities that one function gives, in the table's order.
using QuantityGroup = std::vector<PaperQuantity>;

/// Names of paper_quantities() by their inputs, each once: as few groups as there are sets of inputs. psi needs alpha alone, so it
/// goes to the first group that has alpha. Throws InvalidInput for another name.
std::vector<QuantityGroup> grouped(const std::vector<std::string>& names);

/// One header with a function for each group. `scope` is the namespace inside magicmass::generated that they are in, empty for
/// that one itself; `command` is what writes the header again; `remarks` are further lines of its first comment.
GeneratedFile specialised_header(const std::vector<QuantityGroup>& groups, const std::string& scope,
                                 const std::string& command,
                                 const std::vector<std::string>& remarks,
                                 const std::vector<proof::Theorem>& theorems);

}  // namespace magicmass::codegen
