// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace magicmass::command {

/// After a failed parse: throws InvalidInput, with the nearest known one, for the first word that was meant as a
/// command or an option and is none. CLI11 says of these only that they were not expected.
void require_known_words(const CLI::App& app);

}  // namespace magicmass::command
