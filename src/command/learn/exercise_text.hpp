// SPDX-License-Identifier: GPL-2.0-or-later
// The texts of an exercise: prompt.md and after.md. Paragraphs, lines that begin with "- " and indented lines; {k} is
// a variant's value. Formulas and numbers stand in double braces and are computed or proved, never believed:
// {{sec(pi/5) - 1 = sqrt(5) - 2}} is proved by `learn test`, {{sqrt(5) - 2 : 4}} becomes four digits of it,
// {{answer}} the solution, and {{c_n}} is set as a formula.
#pragma once

#include <string>
#include <vector>

#include "command/learn/judgement.hpp"
#include "render/formula_text.hpp"

namespace magicmass::command {

/// At most 80 columns wide.
std::string page_of(const std::string& markdown, const Posed& posed,
                    const render::TextStyle& style);

/// What is not true in it, or cannot be read: one line each. Numbers typed outside braces count.
std::vector<std::string> complaints_about(const std::string& markdown, const Posed& posed);

}  // namespace magicmass::command
