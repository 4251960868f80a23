// Files that CMake puts into the program: the gnuplot scripts, the paper's numbers, exercises.
#pragma once

#include <map>
#include <string>

namespace host {

/// By their paths below src/command, src/classroom or the project.
const std::map<std::string, std::string>& embedded();

}  // namespace host
