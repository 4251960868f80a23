// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas as the pages show them: each is a side of a proved step, or a term, which claims nothing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "proof/theorem.hpp"

namespace magicmass::course {

/// The steps of the derivation by id.
using Steps = std::map<std::string, proof::Step>;
Steps by_id(const std::vector<proof::Step>& steps);

/// The equation on lines of its own, with what it rests on and a link to its place in the derivation.
std::string theorem_display(const proof::Step& step);
/// Within a line of words: the equation, or a side of it.
std::string theorem_inline(const proof::Step& step);
std::string side_inline(const std::string& side);
/// A side alone, displayed.
std::string side_display(const std::string& side);

/// A term in the derivation's notation, "a(n)", "n*psi/2". Throws Refusal for what cannot be read and for anything that
/// claims something: a relation.
std::string term(const std::string& text);

/// The head of a column of a printed table: a formula, or words with symbols among them.
std::string heading(const std::string& text);

/// A value that a program printed: a real minus sign before a number, 1e-20 as a power of ten.
std::string value(const std::string& text);

}  // namespace magicmass::course
