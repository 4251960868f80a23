// SPDX-License-Identifier: GPL-2.0-or-later
// Printing, from the tree and nothing else. What is printed is read back as the same tree.
#pragma once

#include <string>

#include "kernel/expr.hpp"

namespace kernel {
/// Refused: a tree of more than 200,000 nodes, or with a loose index.
std::string text(Expr e);
/// For messages: cut after some 200 characters, never Refused.
std::string brief(Expr e);
std::string digits(const cln::cl_RA& q);  ///< "-2/3"
}  // namespace kernel
