// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "command/destination.hpp"
#include "render/formula_text.hpp"

namespace magicmass::command {

/// What the locale (LC_ALL, LC_CTYPE, LANG) and the terminal can show; `ascii` asks for plain characters.
render::TextStyle text_style(const Destination& output, bool ascii);

}  // namespace magicmass::command
