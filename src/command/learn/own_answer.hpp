// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "command/learn/exercise.hpp"

namespace magicmass::command {

/// What magicmass itself answers to these arguments. An argument that names a file of `folder` becomes a copy of it
/// with the values filled in. Throws InvalidInput where it refuses them.
std::string own_answer(const std::vector<std::string>& arguments, const std::string& format,
                       const std::filesystem::path& folder, const Values& values);

/// The JSON pointer's value in a JSON text, as an expression: exact fractions stay, doubles are their shortest
/// decimals. Throws InvalidInput where there is none.
std::string field_of(const std::string& json, const std::string& pointer);

/// The exercise's fields, from its own `run`; nothing where it has none.
Values computed_values(const Exercise& exercise, const Values& variant);

}  // namespace magicmass::command
