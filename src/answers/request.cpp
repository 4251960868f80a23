// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers are read the same way whatever the locale.
#include "answers/request.hpp"

#include <charconv>

#include "answers/errors.hpp"

namespace answers {

std::optional<std::int64_t> read_whole(std::string_view digits) {
  std::int64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [read_to, error] = std::from_chars(digits.data(), end, value);
  return error == std::errc() && read_to == end ? std::optional(value) : std::nullopt;
}

std::string Request::text(const std::string& option) const {
  return has(option) ? options.at(option) : "";
}

std::optional<std::int64_t> Request::whole(const std::string& option, std::int64_t least,
                                           std::int64_t most) const {
  if (!has(option)) return std::nullopt;
  const auto value = read_whole(text(option));
  if (value && *value >= least && *value <= most) return value;
  throw InvalidInput(option + " must be a whole number from " + std::to_string(least) + " to " +
                     std::to_string(most) + ", got " + shown_text(text(option)));
}

}  // namespace answers
