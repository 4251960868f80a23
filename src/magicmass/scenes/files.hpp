// Files of text, and of TOML.
#pragma once

#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace magicmass::scenes {

/// What is in a file, "-" for stdin. Throws InvalidInput where it cannot be read or has more bytes.
std::string text_of(const std::string& path, const std::string& allowed = "a file of text",
                    std::size_t longest = std::size_t{1} << 20U);
/// The text as TOML. Throws InvalidInput, "FILE:LINE: what; allowed: ...", for what is none.
toml::table table_of(std::string_view text, const std::string& source, const std::string& allowed);

}  // namespace magicmass::scenes
