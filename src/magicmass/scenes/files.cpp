#include "magicmass/scenes/files.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include <unistd.h>

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {

/// A key of many parts, or values nested deep: the parser's recursion would not end well.
bool is_too_deep(std::string_view text) {
  int parts = 0, depth = 0;
  for (const char c : text) {
    if (c == '\n' || c == '=' || c == ',') parts = 0;
    if (c == '.') ++parts;
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (parts > 100 || depth > 100) return true;
  }
  return false;
}

}  // namespace

toml::table table_of(std::string_view text, const std::string& source, const std::string& allowed) {
  const auto refuse = [&](std::ptrdiff_t line, const std::string& what) {
    throw InvalidInput(source + ":" + std::to_string(line) + ": " + what + "; allowed: " + allowed);
  };
  const std::size_t zero = text.find('\0');
  if (zero != text.npos) refuse(std::ranges::count(text.substr(0, zero), '\n') + 1, "a zero byte");
  if (is_too_deep(text)) refuse(1, "a key of more than 100 parts, or so many brackets");
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::string what(error.description());
    std::replace(what.begin(), what.end(), '\n', ' ');
    refuse(error.source().begin.line, what.substr(0, 200));
    throw;
  }
}

std::string text_of(const std::string& path, const std::string& allowed, std::size_t longest) {
  const std::string shown = path == "-" ? "stdin" : path;
  std::ifstream file(path == "-" ? "/dev/stdin" : path, std::ios::binary);
  std::string text(longest + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if ((path == "-" && ::read(STDIN_FILENO, nullptr, 0) < 0) || (file.fail() && !file.eof()))
    throw InvalidInput("cannot read " + shown + ": " + std::generic_category().message(errno) +
                       "; allowed: " + allowed);
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > longest)
    throw InvalidInput(shown + ":1: more than " + std::to_string(longest) +
                       " bytes; allowed: " + allowed);
  return text;
}

}  // namespace magicmass::scenes
