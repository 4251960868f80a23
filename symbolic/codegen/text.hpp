// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of emitted C++.
#pragma once

#include <string>
#include <vector>

namespace codegen {
using Words = std::vector<std::string>;
/// Lines, broken at spaces to at most 100 columns.
std::string broken(const std::string& lines);
std::string joined(const std::vector<std::string>& parts, const std::string& by);
std::string capital(std::string name);
/// Licence, "generated" line, what it is; then `#pragma once` and the includes.
std::string opening(const std::string& what, const std::vector<std::string>& includes);
}  // namespace codegen
