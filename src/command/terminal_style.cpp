// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/terminal_style.hpp"

#include <cstdlib>
#include <string>

namespace magicmass::command {
namespace {

/// The name of the locale says so: the first of the three variables that is set decides.
bool locale_is_utf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') continue;
    const std::string locale = value;
    for (const char* encoding : {"UTF-8", "utf-8", "UTF8", "utf8"})
      if (locale.find(encoding) != std::string::npos) return true;
    return false;
  }
  return false;
}

}  // namespace

render::TextStyle text_style(const Destination& output, bool ascii) {
  return {.unicode = !ascii && locale_is_utf8(), .colourful = output.is_colourful()};
}

}  // namespace magicmass::command
