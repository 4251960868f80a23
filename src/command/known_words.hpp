// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace magicmass::command {

/// After a failed parse: throws InvalidInput, with the nearest known one, for the first word that was meant as a
/// command or an option and is none. CLI11 says of these only that they were not expected.
void require_known_words(const CLI::App& app);

/// Before parsing: throws InvalidInput for `--option=` without a value, which CLI11 would take from the next word, and
/// for -o=FILE, which it would take for a file called "=FILE".
void require_values(const std::vector<std::string>& words);

}  // namespace magicmass::command
