// SPDX-License-Identifier: GPL-2.0-or-later
// Where an answer of many files goes.
#pragma once

#include <functional>
#include <string>

#include "generate/tree.hpp"

namespace command {

/// All files or none; a folder that was not there goes again where there is none. Throws
/// answers::InvalidInput, after `option` ("generate: --out"), where the system refuses.
void write_folder(const std::string& option, const std::string& folder,
                  const std::function<generate::Texts()>& texts);

}  // namespace command
