// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "equality/expression.hpp"

namespace magicmass::equality {

// The paper's symbols: alpha, V, n, e, ..., and those that it defines: psi, theta, V_CM, a_n, ...
bool is_paper_name(const std::string& name);

// What a defined name stands for, from the paper's equations that the derivation proves; nothing for any other.
std::optional<Tree> meaning(const std::string& name);

// The same for a reader, in the kernel's notation and with other defined names left in.
std::string meaning_as_printed(const std::string& name);

// What is assumed of a symbol where nothing is said: "0 < alpha", "n integer, n >= 1"; empty: real.
std::string usual_condition(const std::string& name);

// A name of the paper that is one letter away, of more than four letters two, from a name that is none; empty where there is none.
std::string nearest_paper_name(const std::string& name);

// The paper's equations that define names: (name, label).
const std::vector<std::pair<std::string, std::string>>& defined_names();

}  // namespace magicmass::equality
