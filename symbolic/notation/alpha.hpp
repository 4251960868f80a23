// The mass ratio alpha = m/M, as somebody writes it: positive, finite, of unit 1.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <cln/rational.h>

namespace notation {
/// alpha_k of the paper, where N_A changes, or beta_k, where N_B does. k >= 1.
struct Threshold {
  bool is_magic;
  cln::cl_I k;
};
/// A double stands for itself, exactly.
using Alpha = std::variant<double, cln::cl_RA, Threshold>;
inline Alpha magic(const cln::cl_I& k) { return Threshold{true, k}; }
inline Alpha deficient(const cln::cl_I& k) { return Threshold{false, k}; }

/// A decimal (0.1, 1e-9, 017 is 17) or a hex float (0x1.8p-3), with or without a minus sign: the
/// nearest double, whatever the locale; infinite where none is near, nothing for other texts.
std::optional<double> read_double(std::string_view text);
/// Reads such a number, p/q as that rational, magic:k and deficient:k with k from 1 to 10^18. No
/// sign, no blank, at most 4,096 characters. Refused (kernel::Refused, one line) otherwise.
Alpha read_alpha(std::string_view text);
/// What read_alpha reads back as the same value; a double as its shortest decimal.
std::string text(const Alpha& alpha);
}  // namespace notation
