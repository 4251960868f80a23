// SPDX-License-Identifier: GPL-2.0-or-later
// All that is emitted, as files: the one call of symbolic/generate.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "codegen/emit_plain.hpp"
#include "codegen/quantity.hpp"

namespace codegen {
/// Texts by path below generated/magicmass: evaluators/*.hpp, evaluators/errors.txt, plain/*.hpp,
/// exact/*.hpp, manifest.json. The same bytes from every run.
std::map<std::string, std::string> generate(const std::vector<Quantity>& evaluators,
                                            const std::vector<PlainForm>& plain,
                                            const Ids& ids = {});
}  // namespace codegen
