// SPDX-License-Identifier: GPL-2.0-or-later
// generate: writes files, so it is no pure answer.
#pragma once

#include "answers/request.hpp"

namespace command {

/// Writes what the theorems give to a folder, all of it or nothing; with "check" compares instead,
/// and a difference is a failed check.
answers::Answer generate_files(const answers::Request& request);

}  // namespace command
