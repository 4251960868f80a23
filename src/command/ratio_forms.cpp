// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/ratio_forms.hpp"

#include <utility>

#include <fmt/format.h>

#include "algebraic/radicals.hpp"
#include "algebraic/ratio_polynomials.hpp"

namespace magicmass::command {
namespace {

constexpr std::size_t columns = 80;
constexpr std::size_t short_polynomial =
    62;  // "root of " and the polynomial fit a line of their own

ExactForms forms(std::optional<std::string> radicals, std::int64_t k, bool long_ones,
                 algebraic::Polynomial (*minimal_polynomial)(long)) {
  ExactForms result{std::move(radicals), {}};
  if (k > last_polynomial) return result;
  const algebraic::Polynomial polynomial = minimal_polynomial(k);
  std::string text = algebraic::to_text(polynomial);
  if (long_ones || text.size() <= short_polynomial)
    result.polynomial = std::move(text);
  else
    result.hidden_degree = polynomial.degree();
  return result;
}

/// Broken at spaces, each line after `indent`.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string result;
  std::size_t from = 0;
  while (from < text.size()) {
    std::size_t length = text.size() - from;
    if (length > columns - indent) {
      const std::size_t space = text.rfind(' ', from + columns - indent);
      const std::size_t end =
          space == std::string::npos || space <= from ? text.find(' ', from) : space;
      length = (end == std::string::npos ? text.size() : end) - from;
    }
    result += std::string(indent, ' ') + text.substr(from, length) + "\n";
    from += length + 1;
  }
  return result;
}

}  // namespace

ExactForms magic_forms(std::int64_t k, bool long_ones) {
  return forms(algebraic::magic_radicals(k), k, long_ones, algebraic::magic_polynomial);
}

ExactForms deficient_forms(std::int64_t k, bool long_ones) {
  return forms(algebraic::deficient_radicals(k), k, long_ones, algebraic::deficient_polynomial);
}

std::string ratio_lines(const std::string& head, const std::string& name, const std::string& value,
                        const ExactForms& forms) {
  std::string exact = forms.radicals.value_or("");
  if (!forms.radicals && forms.polynomial) exact = "root of " + *forms.polynomial;
  if (!forms.radicals && forms.hidden_degree > 0)
    exact = fmt::format("of degree {}: see --exact", forms.hidden_degree);
  const std::string line = fmt::format("{}{:<11}{:<24}", head, name, value);
  if (line.ends_with("  ") && line.size() + exact.size() <= columns) {
    const std::string whole = line + exact;
    return whole.substr(0, whole.find_last_not_of(' ') + 1) + "\n";
  }
  const std::size_t indent = head.size() + 11;
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n" + wrapped(exact, indent);
}

}  // namespace magicmass::command
