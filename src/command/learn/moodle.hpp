// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/learn/judgement.hpp"
#include "equality/expression.hpp"

namespace magicmass::command {

/// A quiz in Moodle's XML: STACK questions for symbolic answers, with a node for each misconception; CodeRunner
/// questions for code; numerical and multiple-choice questions for predictions.
std::string moodle_quiz(const std::vector<Posed>& questions);

/// For Maxima: pi is %pi, roots are powers, and e, which is Euler's number there, is e_r.
std::string maxima(const equality::Tree& tree);

/// A question of each kind, without its name and text.
std::string moodle_symbolic(const Posed& posed);
std::string moodle_code(const Posed& posed);
std::string moodle_prediction(const Posed& posed);

/// <name>text</name>, escaped; <name><text>...</text></name>; and the same with format="html".
std::string element(const std::string& name, const std::string& text);
std::string text_element(const std::string& name, const std::string& text);
std::string html_element(const std::string& name, const std::string& html);

}  // namespace magicmass::command
