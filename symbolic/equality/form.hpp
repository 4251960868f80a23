// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "equality/expression.hpp"

namespace magicmass::equality {

// Forms that an answer can be asked for in; they are about how it is written, not what it is worth.
const std::vector<std::string>& form_names();

// Empty where the tree has the form, else why not: "it is a sum of 2 terms". Throws std::out_of_range for a name
// that is none of form_names().
std::string what_lacks_form(const Tree& tree, const std::string& form);

}  // namespace magicmass::equality
