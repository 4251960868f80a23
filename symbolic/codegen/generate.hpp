// SPDX-License-Identifier: GPL-2.0-or-later
// All that is emitted, as files: the one call of symbolic/generate.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "codegen/quantity.hpp"

namespace codegen {
/// A quantity to be written as plain or exact functions, in a form of this name: closed, product...
struct PlainForm {
  Quantity quantity;
  std::string form;
};
/// Texts by path below generated/magicmass: evaluators/*.hpp, evaluators/errors.txt, plain/*.hpp,
/// exact/*.hpp, manifest.json. The same bytes from every run.
std::map<std::string, std::string> generate(const std::vector<Quantity>& evaluators,
                                            const std::vector<PlainForm>& plain);
}  // namespace codegen
