// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace magicmass::equality {

// What people paste from LaTeX, in the notation of parse(): \frac{a}{b}, \sqrt[3]{x}, \cos^2\theta, \left( \right),
// \alpha, c'_n, $...$. Text without a backslash, brace or dollar sign comes back as it is, but for c'_{n} and
// fractions such as ½. Throws NotAnExpression for a command it does not know.
std::string plain_text(std::string_view typed);

// A matrix row by row, each entry as it was typed: [[a, b], [c, d]], a, b; c, d, or LaTeX's a & b \\ c & d between
// \begin and \end. Throws NotAnExpression where rows differ in length.
std::vector<std::vector<std::string>> matrix_entries(std::string_view typed);

}  // namespace magicmass::equality
