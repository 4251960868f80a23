// Nothing here depends on the locale.
#include "answers/request.hpp"

#include <charconv>

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

std::int64_t Request::size(const std::string& option, std::int64_t least, std::int64_t most,
                           const std::string& of) const {
  const std::string typed = text(option);
  const bool is_whole = !typed.empty() && typed.find_first_not_of("0123456789") == typed.npos;
  const auto value = read_whole(typed);
  if (is_whole && (!value || *value > most))
    throw Undecided(option + ": " + shown_text(typed) + " is more than is answered at once" + of +
                    "; at most " + std::to_string(most));
  return *whole(option, least, most);
}

Request Rows::request(std::size_t row) const {
  Request all = shared;
  for (std::size_t i = 0; i < columns.size(); ++i) all.options[columns[i]] = fields[row][i];
  return all;
}

std::string shown_text(std::string_view text, std::size_t longest) {
  constexpr std::string_view hex = "0123456789abcdef";
  if (text.empty()) return "(nothing)";
  std::string shown;
  const auto byte = [&](std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
  };
  const auto goes_on = [&](std::size_t at) { return (byte(at) & 0xc0U) == 0x80; };
  for (std::size_t i = 0, size = 1; i < std::min(text.size(), longest); i += size) {
    const bool is_two = (byte(i) > 0xc2 && byte(i) < 0xcc) || byte(i) / 2 == 0x67 ||  // é, α
                        (byte(i) == 0xc2 && byte(i + 1) > 0xad);                      // ½
    const bool is_mark = byte(i + 1) == 0x80
                             ? byte(i + 2) / 0x10 < 0xa && byte(i + 2) > 0x8f
                             : byte(i + 1) == 0x81 && byte(i + 2) / 0x10 != 0xa;  // ⁄ ⁻
    const bool is_sign = byte(i) == 0xe2 && (byte(i + 1) > 0x81 || is_mark) && goes_on(i + 2);
    size = !goes_on(i + 1) ? 1 : is_two ? 2 : is_sign ? 3 : 1;
    if (size > 1 || (byte(i) >= 0x20 && byte(i) < 0x7f))
      shown += text.substr(i, size);
    else
      shown += {'\\', 'x', hex[byte(i) / 16], hex[byte(i) % 16]};
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
