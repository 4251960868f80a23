// SPDX-License-Identifier: GPL-2.0-or-later
// What libFuzzer calls, and what each target has to say about an input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

/// libFuzzer's name. Throws, or crashes, where the library does what it must not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace magicmass::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

inline void require(bool condition, const char* what) {
  if (!condition) throw std::logic_error(what);
}

/// A refusal is one line with words in it.
inline void require_one_line(const std::exception& refusal) {
  const std::string message = refusal.what();
  require(!message.empty() && message.find('\n') == std::string::npos, "a refusal of many lines");
}

}  // namespace magicmass::fuzz
