// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of emitted C++.
#pragma once

#include <string>
#include <vector>

namespace codegen {
/// Lines, broken at spaces to at most 100 columns.
class Text {
public:
  void line(const std::string& code);
  /// Several lines, each as it is.
  void block(const std::string& lines);
  std::string str() const { return text; }

private:
  std::string text;
};
std::string joined(const std::vector<std::string>& parts, const std::string& by);
std::string capital(std::string name);
/// Licence, "generated" line, what it is; then `#pragma once` and the includes.
std::string opening(const std::string& what, const std::vector<std::string>& includes);
}  // namespace codegen
