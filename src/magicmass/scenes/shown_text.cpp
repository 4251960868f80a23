// SPDX-License-Identifier: MIT
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass {

std::string shown_text(std::string_view text, std::size_t longest) {
  constexpr std::string_view hex = "0123456789abcdef";
  if (text.empty()) {
    return "(nothing)";
  }
  std::string shown;
  for (const char character : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte >= 0x20 && byte < 0x7f) {
      shown += character;
    } else {
      shown += "\\x";
      shown += hex[byte >> 4U];
      shown += hex[byte & 15U];
    }
  }
  return text.size() > longest ? shown + "..." : shown;
}

}  // namespace magicmass
