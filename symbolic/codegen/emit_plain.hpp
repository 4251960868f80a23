// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas as plain functions of any number type, from the same quantities.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "codegen/lower.hpp"
#include "codegen/manifest.hpp"

namespace codegen {
/// A quantity to be written as a function QUANTITY_FORM: closed, product, tangent; `exact`: over
/// any field, by rational theorems; `matrices`: each output is one. Its domain is that of the
/// narrow ranges, for numbers of doubles' precision and exponents, or better.
struct PlainForm {
  Quantity quantity;
  std::string form;
};
/// All forms of one name in one header, with the outputs that are wanted (none named: all) and what
/// those need. Refused: a wanted output that there is none of; what may over- or underflow.
Emitted emit_plain(const std::vector<PlainForm>& forms, const Ids& ids,
                   const std::set<std::string>& wanted = {});
}  // namespace codegen
