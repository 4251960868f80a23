// SPDX-License-Identifier: GPL-2.0-or-later
// Reads terms, matrices and formulas as the kernel prints them.
#pragma once

#include <string_view>

#include "kernel/expr.hpp"

namespace notation {
/// The very tree that is printed so: read(kernel::text(e)) is e. Variables and functions are those
/// that the kernel knows; parameters that the printer hides are put back.
/// Refused (kernel::Refused, one line with the place): what is not of this form, a name that nobody
/// has declared, more than 200,000 characters, brackets more than 200 deep.
kernel::Expr read(std::string_view text);
}  // namespace notation
