// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/contestant.hpp"

namespace magicmass::report {

/// Inputs of one kind of difficulty, reported by themselves.
struct Family {
  std::string name;         ///< "magic neighbours"
  std::string description;  ///< one line for the report
  std::string quantity;     ///< Quantity::name
  std::vector<Input> inputs;
};

/// The families of a quantity, hardest first; `size` inputs or fewer each. The same inputs on every run and machine.
std::vector<Family> families(const std::string& quantity, std::size_t size);

/// The last of them alone: for what takes alpha, the everyday ones.
Family easiest_family(const std::string& quantity, std::size_t size);

}  // namespace magicmass::report
