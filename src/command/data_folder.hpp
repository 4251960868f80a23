// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

namespace magicmass::command {

/// A folder of files that the program reads: PREFIX/share/magicmass/`installed` where it runs as PREFIX/bin/magicmass,
/// wherever that was moved to; else `in_sources` of the sources it was built from.
std::filesystem::path data_folder(const char* installed, const char* in_sources);

}  // namespace magicmass::command
