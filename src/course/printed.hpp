// SPDX-License-Identifier: GPL-2.0-or-later
// What a program printed, and how a page shows it.
#pragma once

#include <map>
#include <string>

namespace course {

using Texts = std::map<std::string, std::string>;

/// By name: "name: value", or "name:" above lines that begin with two blanks, a block, each of
/// whose lines ends with \n; "# ..." is for the terminal alone. Throws answers::InvalidInput for
/// any other line and for a name that is printed twice.
Texts read_printed(const std::string& output);
/// The commands of a session, and what each printed.
Texts read_session(const std::string& session);

/// A term in the derivation's notation, or the letter of a body, as MathML. Throws
/// answers::InvalidInput for what cannot be read and for what claims something.
std::string term_html(const std::string& text);
/// -1e-20 as a power of ten with a sign of its own; a formula; words.
std::string value_html(const std::string& text);
/// A table where lines have cells, "a | b"; else the lines as they are.
std::string block_html(const std::string& lines);
std::string code_html(const std::string& text, const std::string& attributes = "");

}  // namespace course
