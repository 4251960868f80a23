// SPDX-License-Identifier: GPL-2.0-or-later
// What is generated: the chapters' theorems, handed to the generator.
#pragma once
#include <map>
#include <string>

namespace generate {
/// Texts by path below generated/. The same bytes from every run.
std::map<std::string, std::string> generated();
}  // namespace generate
