// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "codegen/emit.hpp"
#include "codegen/specialised.hpp"
#include "proof/theorem.hpp"

namespace magicmass::codegen {

// A function of a specialised header: the group's kernel with these outputs alone. No kernel where only counts are asked for.
struct Specialised {
  QuantityGroup group;
  std::vector<Kernel> kernel;  // one, or none

  std::string name() const;  // "a_t_rho"
  bool has(const std::string& quantity) const;
};
Specialised specialised(const QuantityGroup& group, const std::vector<proof::Theorem>& theorems);

// The function's part of that header.
std::string emit_specialised(const Specialised& made);

}  // namespace magicmass::codegen
