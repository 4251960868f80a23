// SPDX-License-Identifier: GPL-2.0-or-later
// Nothing here depends on the locale.
#include "answers/errors.hpp"

namespace answers {

std::string shown_text(std::string_view text, std::size_t longest) {
  constexpr std::string_view hex = "0123456789abcdef";
  if (text.empty()) return "(nothing)";
  std::string shown;
  for (const char character : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte >= 0x20 && byte < 0x7f)
      shown += character;
    else
      shown += {'\\', 'x', hex[byte / 16U], hex[byte % 16U]};
  }
  return text.size() > longest ? shown + "..." : shown;
}

std::string joined(const std::vector<std::string>& texts, std::string_view between) {
  std::string text;
  for (std::size_t i = 0; i < texts.size(); ++i)
    text.append(i == 0 ? "" : between).append(texts[i]);
  return text;
}

}  // namespace answers
