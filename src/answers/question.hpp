// SPDX-License-Identifier: GPL-2.0-or-later
// Questions of exercises and of the table of the paper's numbers, written as a command's words.
#pragma once

#include <map>
#include <string>

namespace answers {

/// "count --alpha 3/25": the cells of the last row of its answer, by their columns' names. Besides
/// commands: "angle --alpha 1", and "extremum --near magic:2 --restitution 9/10" of rho. Throws
/// InvalidInput where the command is none of those that answer in numbers.
std::map<std::string, std::string> answer_to(const std::string& question);

/// Whether two numbers are equal that are written as a scene writes them: exactly, but as doubles
/// where the second has a decimal point.
bool are_equal(const std::string& one, const std::string& other);

}  // namespace answers
