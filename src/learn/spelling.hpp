// SPDX-License-Identifier: GPL-2.0-or-later
// What students type and the reader does not know: (a; b), M_2u_2, units.
#pragma once

#include <set>

#include "learn/exercise.hpp"

namespace learn {

/// What stands between separators that are in no brackets.
Texts parts(const std::string& text, char separator);
/// "a, b; c, d" in brackets, (a; b) too; and (a, b) where a column is asked for.
std::string bracketed(const std::string& text, bool is_column);
/// The names of which a word is made, with spaces: "M_2u_2" is "M_2 u_2"; "" where it is not.
std::string parted(const std::string& word, const std::set<std::string>& names);
/// M_2u_2, as LaTeX has it, in two words where both are names: a power belongs to the last one.
std::string with_spaces(const std::string& text, const std::set<std::string>& names, Texts& notes);
/// The unit at the end, m/s, where there is no such symbol; else nothing.
std::string unit(const std::string& text, const std::set<std::string>& symbols);

}  // namespace learn
