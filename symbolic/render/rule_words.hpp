// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace magicmass::render {

/// What the kernel did under this rule, as a sentence without its stop; a rule that is not known is its own name.
std::string rule_words(const std::string& rule);

}  // namespace magicmass::render
