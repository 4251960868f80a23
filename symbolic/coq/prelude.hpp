// SPDX-License-Identifier: GPL-2.0-or-later
// symbolic/coq/prelude.v as a text.
#pragma once

#include <string>

namespace coq {
extern const std::string prelude;
}
