// SPDX-License-Identifier: GPL-2.0-or-later
// Plain, exact and matrix forms.
#pragma once
#include "codegen/emit_plain.hpp"
#include "generate/source.hpp"

namespace generate {
/// Once a process: it defines names.
std::vector<codegen::PlainForm> plain_forms(Source& source);
}  // namespace generate
