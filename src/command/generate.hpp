// SPDX-License-Identifier: GPL-2.0-or-later
// generate: writes files, so it is no pure answer.
#pragma once

#include <functional>
#include <string>

#include "answers/request.hpp"
#include "generate/tree.hpp"

namespace command {

/// All files or none; a folder that was not there goes again where there is none. Throws
/// InvalidInput, after `option` ("generate: --out"), where the system refuses.
void write_folder(const std::string& option, const std::string& folder,
                  const std::function<generate::Texts()>& texts);

/// Writes what the theorems give to a folder, all of it or nothing; with "check" compares instead,
/// and a difference is a failed check. With "quantity" or "scene" one header.
answers::Answer generate_files(const answers::Request& request);

}  // namespace command
