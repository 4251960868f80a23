// SPDX-License-Identifier: GPL-2.0-or-later
// DoubleDouble evaluators, as C++ templates over a tier and a number type.
#pragma once

#include <string>

#include "codegen/manifest.hpp"

namespace codegen {
struct Evaluator {
  std::string header;    ///< evaluators/NAME.hpp
  std::string errors;    ///< each node's error, for a reader
  std::string manifest;  ///< a JSON object
};
Evaluator emit_evaluator(const Quantity& q, const Ids& ids = {});
}  // namespace codegen
