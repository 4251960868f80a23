// SPDX-License-Identifier: GPL-2.0-or-later
// DoubleDouble evaluators, as C++ templates over a tier and a number type: a header, its cases as
// structs of three stages, their nodes.
#pragma once

#include <string>
#include <vector>

#include "codegen/lower.hpp"
#include "codegen/manifest.hpp"

namespace codegen {
struct EmittedCase {
  std::string code;
  std::string errors;
  Words bounds;  ///< of Accurate's outputs, in words
};
inline const std::string inlined = "  [[gnu::always_inline]] ";
/// "  double a, b;"
std::string fields(const std::string& type, const Words& names);
/// Both ends as C++, with what stands between them; a wide domain's where that is so.
std::string range_in_code(Interval narrow, Interval wide, const std::string& is_wide,
                          const std::string& between);
EmittedCase emit_case(const Quantity& q, const Case& c);
/// "in.alpha >= 0x1p-300 && ..." of the case, in both domains.
std::string condition(const Quantity& q, const Case& c);
std::string as_plain(const Program& p, int k);   ///< an exact node, as a T
std::string as_number(const Program& p, int k);  ///< any node, as an N
std::string right_side(const Program& p, const Node& n);
/// The line that both functions of an angle come from.
std::string sine_and_cosine(const Program& p, const Node& n);
/// "3 sums, 2 products, ..."
std::string operation_counts(const Program& p);
Emitted emit_evaluator(const Quantity& q, const Ids& ids = {});
}  // namespace codegen
