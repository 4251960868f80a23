// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas in LaTeX.
#pragma once
#include <string>

#include "kernel/expr.hpp"

namespace render {
/// For math mode, without its delimiters: \frac{...}{...}, \begin{pmatrix}, \psi, c'_{n}.
std::string latex(kernel::Expr e);
}  // namespace render
