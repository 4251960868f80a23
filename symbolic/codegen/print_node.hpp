// SPDX-License-Identifier: GPL-2.0-or-later
// Nodes as C++ expressions of a number type N with plain numbers T.
#pragma once

#include <string>

#include "codegen/program.hpp"

namespace codegen {
std::string as_plain(const Program& p, int k);   ///< an exact node, as a T
std::string as_number(const Program& p, int k);  ///< any node, as an N
std::string right_side(const Program& p, const Node& n);
/// The line that both functions of an angle come from.
std::string sine_and_cosine(const Program& p, const Node& n);
/// "3 sums, 2 products, ..."
std::string operation_counts(const Program& p);
}  // namespace codegen
