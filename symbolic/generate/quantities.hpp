// SPDX-License-Identifier: GPL-2.0-or-later
// What is generated: the chapters' theorems, handed to the generator.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "generate/source.hpp"

namespace generate {
/// Evaluators in DoubleDouble.
std::vector<codegen::Quantity> evaluators(Source& source);
/// Texts by path below generated/. The same bytes from every run.
std::map<std::string, std::string> generated();
/// One header with the wanted outputs alone, in a plain form: closed, product, tangent, exact.
/// Throws codegen::Refused for a form or an output that there is none of.
std::string selected(const std::string& form, const std::set<std::string>& outputs);
}  // namespace generate
