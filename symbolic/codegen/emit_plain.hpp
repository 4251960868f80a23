// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas as plain functions of any number type, from the same quantities.
#pragma once

#include <string>

#include "codegen/quantity.hpp"

namespace codegen {
/// plain/NAME_FORM.hpp: a function template a case, over any real type with <cmath>'s functions, or
/// (where its theorems are rational) exact/NAME_FORM.hpp, over any field.
struct PlainHeader {
  std::string folder;  ///< "plain" or "exact"
  std::string header;
};
PlainHeader emit_plain(const Quantity& q, const std::string& form);
}  // namespace codegen
