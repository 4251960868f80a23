// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas in presentation MathML, as browsers draw it.
#pragma once
#include <string>

#include "kernel/expr.hpp"

namespace render {
/// One <math> element, in a line of text or on a line of its own.
std::string mathml(kernel::Expr e, bool is_block);
}  // namespace render
