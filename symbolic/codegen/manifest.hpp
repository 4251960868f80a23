// SPDX-License-Identifier: GPL-2.0-or-later
// What generated/manifest.json says of each header.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "codegen/quantity.hpp"
#include "codegen/text.hpp"

namespace codegen {
/// The ids of theorems, by their conclusions.
using Ids = std::map<kernel::Expr, std::string>;

/// The ids of what cases are made of, each once, in order; theorems without an id are left out.
Words ids_of(const std::vector<Case>& cases, const Ids& ids);
/// A header, and what is said of it elsewhere.
struct Emitted {
  std::string path;  ///< evaluators/NAME.hpp, plain/FORM.hpp, exact/FORM.hpp
  std::string header;
  Words manifest;           ///< a JSON object a quantity
  std::string errors = {};  ///< of an evaluator: each node's, for a reader
};
/// A JSON object: name, form, header, labels, inputs, outputs, cases. `bounds`: of each case's
/// outputs, "a: 2^-73.6 |P|"; none: each operation is rounded.
std::string manifest_entry(const Quantity& q, const std::string& form, const std::string& header,
                           const Ids& ids, const std::vector<Words>& bounds = {});
}  // namespace codegen
