// SPDX-License-Identifier: GPL-2.0-or-later
// Texts, cut and changed, and names that were misspelt.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace learn {
using Texts = std::vector<std::string>;

/// What stands between the separators.
Texts fields(const std::string& text, char separator);
/// The same without blanks around each, and without those that are empty.
Texts split(const std::string& text, char separator);
void replace_all(std::string& text, const std::string& what, const std::string& by);
/// The text and the pattern's groups in it; empty where the pattern does not match all of it.
Texts matched(const std::string& text, const std::string& pattern);
/// With something else for each part that matches: what `by` makes of the part and its groups.
std::string replaced(const std::string& text, const std::string& pattern,
                     const std::function<std::string(const Texts& part)>& by);
/// "; is hints meant?" of hint; otherwise that.
std::string meant(const std::string& name, const Texts& names, const std::string& otherwise);

}  // namespace learn
