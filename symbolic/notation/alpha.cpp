// SPDX-License-Identifier: GPL-2.0-or-later
// Reads and prints the mass ratio.
#include "notation/alpha.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <cln/integer_io.h>

#include "kernel/print.hpp"

namespace notation {
namespace {
using kernel::refuse;

constexpr std::string_view allowed =
    "; allowed: a decimal like 0.1 or 1e-9, a hex float like 0x1.8p-3, a fraction like 1/7, "
    "magic:k or deficient:k";
constexpr std::string_view decimal = "0123456789.";
constexpr std::string_view hexadecimal = "0123456789.abcdefABCDEF";

// Printable, and short enough for a message.
std::string shown(std::string_view text) {
  std::string out(text.substr(0, 40));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + out + (text.size() > 40 ? "...\"" : "\"");
}
[[noreturn]] void refuse_form(std::string_view text) {
  refuse("alpha is not a number: " + shown(text) + std::string(allowed));
}
[[noreturn]] void refuse_value(std::string_view text) {
  refuse("alpha must be a positive finite number, got " + shown(text));
}
// Digits that nobody takes for octal: no zero before another digit.
bool is_whole(std::string_view digits) {
  return !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos &&
         (digits[0] != '0' || digits.size() == 1);
}
cln::cl_I whole(std::string_view digits) { return cln::cl_I(std::string(digits).c_str()); }

Alpha fraction(std::string_view text, std::size_t slash) {
  const std::string_view above = text.substr(0, slash);
  const std::string_view below = text.substr(slash + 1);
  if (!is_whole(above) || !is_whole(below))
    refuse("alpha is not a fraction of two whole numbers, like 1/7: " + shown(text));
  if (below == "0") refuse("alpha divides by 0: " + shown(text));
  if (above == "0") refuse_value(text);
  return cln::cl_RA(whole(above) / whole(below));
}
cln::cl_I number_k(std::string_view text, std::size_t colon) {
  const std::string_view k = text.substr(colon + 1);
  const bool fits = is_whole(k) && k != "0" && (k.size() < 19 || k == "1000000000000000000");
  if (!fits) refuse("k must be a whole number from 1 to 10^18 in " + shown(text));
  return whole(k);
}
double number(std::string_view text) {
  std::string_view rest = text;
  const bool hex = rest.starts_with("0x") || rest.starts_with("0X");
  if (hex) rest.remove_prefix(2);
  const std::string_view marks = hex ? "pP" : "eE";
  const auto mark = std::find_if(rest.begin(), rest.end(),
                                 [&](char c) { return c == marks[0] || c == marks[1]; });
  const std::string_view mantissa = rest.substr(0, static_cast<std::size_t>(mark - rest.begin()));
  if (hex && mantissa.size() == rest.size())
    refuse("alpha as a hex float needs its exponent, like 0x1.8p-3: " + shown(text));
  // std::from_chars knows words for what is not finite, too; it stops at all else.
  if (mantissa.empty() || mantissa.find_first_of(hex ? hexadecimal : decimal) != 0)
    refuse_form(text);
  if (!hex && mantissa.starts_with('0') && mantissa.size() > 1 && mantissa[1] != '.')
    refuse("alpha begins with a 0 too many: " + shown(text));
  double value = 0;
  const char* const end = rest.data() + rest.size();
  const auto [stop, error] = std::from_chars(
      rest.data(), end, value, hex ? std::chars_format::hex : std::chars_format::general);
  if (stop != end || error == std::errc::invalid_argument) refuse_form(text);
  if (mantissa.find_first_not_of("0.") == mantissa.npos) refuse_value(text);
  if (error == std::errc::result_out_of_range || value == 0 || !std::isfinite(value))
    refuse("alpha does not fit a double (5e-324 to 1.8e308), write it as p/q: " + shown(text));
  return value;
}
}  // namespace

Alpha read_alpha(std::string_view text) {
  constexpr std::array<std::string_view, 4> no_number = {"inf", "infinity", "nan", "INF"};
  if (text.size() > 4096)
    refuse("alpha is " + std::to_string(text.size()) + " characters long; allowed: up to 4096");
  if (text.starts_with('-') ||
      std::find(no_number.begin(), no_number.end(), text) != no_number.end())
    refuse_value(text);
  if (text.starts_with("magic:")) return Magic{number_k(text, 5)};
  if (text.starts_with("deficient:")) return Deficient{number_k(text, 9)};
  if (const std::size_t slash = text.find('/'); slash != text.npos) return fraction(text, slash);
  return number(text);
}
std::string text(const Alpha& alpha) {
  if (const auto* magic = std::get_if<Magic>(&alpha)) return "magic:" + kernel::digits(magic->k);
  if (const auto* k = std::get_if<Deficient>(&alpha)) return "deficient:" + kernel::digits(k->k);
  if (const auto* q = std::get_if<cln::cl_RA>(&alpha))
    return kernel::digits(cln::numerator(*q)) + "/" + kernel::digits(cln::denominator(*q));
  std::array<char, 32> out{};
  const auto end = std::to_chars(out.data(), out.data() + out.size(), std::get<double>(alpha)).ptr;
  return {out.data(), end};
}
}  // namespace notation
