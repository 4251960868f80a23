// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "command/learn/exercise.hpp"

namespace magicmass::command {

/// The values of one student's variant: a row of the explicit list, and one value of each range, by the seed.
Values variant_of(const Exercise& exercise, std::uint64_t seed);

/// {name} replaced by its value, {ordinal:name} by "third"; other braces, and {{, stay.
std::string filled(const std::string& text, const Values& values);

/// The exercise with its variant's values in all that is compared.
Exercise filled(Exercise exercise, const Values& values);

/// "k = 3": the variant for a reader; empty where there is none.
std::string shown_variant(const Values& values);

/// "first" to "twelfth", then "13th".
std::string ordinal(long number);

}  // namespace magicmass::command
