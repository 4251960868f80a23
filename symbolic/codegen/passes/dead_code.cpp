// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/dead_code.hpp"

#include <algorithm>

namespace magicmass::codegen {

Program dead_code(const Program& program, const std::vector<std::string>& wanted) {
  Program kept = program;
  std::erase_if(kept.outputs, [&](const Output& output) {
    return std::find(wanted.begin(), wanted.end(), output.name) == wanted.end();
  });
  return rebuilt(kept, [](Program& result, const Node& node) { return append(result, node); });
}

}  // namespace magicmass::codegen
