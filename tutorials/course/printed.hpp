// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace magicmass::course {

/// What a tutorial program printed under one name.
struct Printed {
  std::string name;
  std::string value = {};  // of "name: value"
  std::vector<std::string> lines =
      {};  // of "name:" with indented lines below, without their indentation
  bool is_block = false;
};

/// Takes what a program printed: lines "name: value"; "name:" above lines indented by two blanks; and lines that begin
/// with "#", which are for the terminal alone. Throws Refusal for any other line, and for a name printed twice.
std::vector<Printed> read_printed(const std::string& output,
                                  const std::string& program);

/// Cells of a line "a | b | c", without the blanks around them; one cell where there is no "|".
std::vector<std::string> cells(const std::string& line);

}  // namespace magicmass::course
