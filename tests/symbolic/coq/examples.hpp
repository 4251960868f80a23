// SPDX-License-Identifier: GPL-2.0-or-later
// A small book: each rule of the kernel, each kind of definition, each axiom.
#pragma once

#include "coq/files.hpp"

namespace examples {
/// The same at each call.
const std::vector<coq::Chapter>& book();
}  // namespace examples
