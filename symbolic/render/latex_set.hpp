// SPDX-License-Identifier: GPL-2.0-or-later
// How formulas are set in LaTeX, with their widths: between the files that do it, for no one else.
#pragma once

#include <string>
#include <string_view>

#include "render/formula.hpp"

namespace magicmass::render::tex {

/// What is set, about how wide it is in em, and whether parentheses around it must grow.
struct Set {
  std::string code;
  double width = 0;
  bool tall = false;

  Set& operator+=(const Set& next) {
    const bool apart = !code.empty() && !next.code.empty() && code.back() != ' ';
    code += (apart ? " " : "") + next.code;
    width += next.width;
    tall = tall || next.tall;
    return *this;
  }
};

/// `small`: in an argument, an index or within a fraction, where quotients stay on the line.
Set set(const Formula& formula, bool small);
/// In parentheses where it needs them as a factor.
Set factor(const Formula& formula, bool small);
/// A function or an element of a sequence; the exponent goes between its name and its argument.
Set call(const Formula& formula, bool small, const std::string& exponent);

/// A name, with an index if it has one.
Set name(std::string_view text, const Set& index = {});
/// Between a left and a right bracket that grow if they have to.
Set fenced(const Set& inside, const std::string& left, const std::string& right);

/// Numbers, names and elements of sequences.
bool is_atom(const Formula& formula);
bool is_root(const Formula& formula);

/// What stands between the brackets of a call.
Set arguments(const Formula& formula);

}  // namespace magicmass::render::tex
