#include "notation/alpha.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "notation/tokens.hpp"

namespace notation {
namespace {
using kernel::refuse;

constexpr std::size_t longest_alpha = 4096;
constexpr std::string_view allowed =
    "; allowed: a decimal like 0.1 or 1e-9, a hex float like 0x1.8p-3, a fraction like 1/7, "
    "magic:k or deficient:k";

// Printable, and short enough for a message.
std::string shown(std::string_view text) {
  std::string out(text.substr(0, 40));
  const auto is_odd = [](char c) { return c < ' ' || c > '~'; };
  std::ranges::replace_if(out, is_odd, '?');
  return '"' + out + (text.size() > 40 ? "...\"" : "\"");
}
[[noreturn]] void refuse_value(std::string_view text) {
  refuse("alpha must be a positive finite number, got " + shown(text));
}
cln::cl_I whole(std::string_view digits) { return cln::cl_I(std::string(digits).c_str()); }

cln::cl_RA fraction(std::string_view text, std::size_t slash) {
  const std::string_view above = text.substr(0, slash), below = text.substr(slash + 1);
  if (!is_whole(above) || !is_whole(below))
    refuse("alpha is not a fraction of two whole numbers, like 1/7: " + shown(text));
  if (whole(below) == 0) refuse("alpha divides by 0: " + shown(text));
  if (whole(above) == 0) refuse_value(text);
  return whole(above) / whole(below);
}
cln::cl_I number_k(std::string_view text) {
  const std::string_view digits = text.substr(text.find(':') + 1);
  const cln::cl_I k = is_whole(digits) ? whole(digits) : 0;
  if (k < 1 || k > cln::cl_I(1'000'000'000'000'000'000))
    refuse("k must be a whole number from 1 to 10^18 in " + shown(text));
  return k;
}
double number(std::string_view text) {
  const auto value = read_double(text);
  if (!value) refuse("alpha is not a number: " + shown(text) + std::string(allowed));
  if (std::isinf(*value))
    refuse("alpha does not fit a double (5e-324 to 1.8e308), write it as p/q: " + shown(text));
  if (*value == 0) refuse_value(text);
  return *value;
}
}  // namespace

std::optional<double> read_double(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  text.remove_prefix(is_negative ? 1 : 0);
  const bool is_hex = text.size() > 2 && text[0] == '0' && (text[1] | ' ') == 'x';
  text.remove_prefix(is_hex ? 2 : 0);
  // std::from_chars knows another sign, and words for what is not finite.
  const int first = text.empty() ? '-' : text.front() | ' ';
  if (text.size() > longest_alpha || first == '-' || first == 'i' || first == 'n') return {};
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto format = is_hex ? std::chars_format::hex : std::chars_format::general;
  const auto [stop, error] = std::from_chars(text.data(), end, value, format);
  if (stop != end || error == std::errc::invalid_argument) return {};
  if (error == std::errc() && value != 0) return is_negative ? -value : value;
  const std::string_view mantissa = text.substr(0, text.find_first_of(is_hex ? "pP" : "eE"));
  if (mantissa.find_first_not_of("0.") != mantissa.npos) value = HUGE_VAL;
  return is_negative ? -value : value;
}
Alpha read_alpha(std::string_view text) {
  if (text.size() > longest_alpha)
    refuse("alpha is " + std::to_string(text.size()) + " characters long; allowed: up to " +
           std::to_string(longest_alpha));
  if (text.starts_with('-')) refuse_value(text);
  if (text.starts_with("magic:")) return magic(number_k(text));
  if (text.starts_with("deficient:")) return deficient(number_k(text));
  if (const std::size_t slash = text.find('/'); slash != text.npos) return fraction(text, slash);
  return number(text);
}
std::string text(const Alpha& alpha) {
  if (const auto* at = std::get_if<Threshold>(&alpha))
    return (at->is_magic ? "magic:" : "deficient:") + kernel::digits(at->k);
  if (const auto* q = std::get_if<cln::cl_RA>(&alpha))
    return kernel::digits(cln::numerator(*q)) + "/" + kernel::digits(cln::denominator(*q));
  std::array<char, 32> out{};
  const auto end = std::to_chars(out.data(), out.data() + out.size(), std::get<double>(alpha)).ptr;
  return {out.data(), end};
}
}  // namespace notation
