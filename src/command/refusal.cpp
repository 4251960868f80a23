// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/refusal.hpp"

#include <iostream>
#include <string>

namespace magicmass::command {

ExitCode say_if_refused(const derivation::Derivation& derivation) {
  if (!derivation.refused) return ExitCode::done;
  std::cerr << "magicmass: " + std::string(derivation.refused->what()) + "\n";
  return ExitCode::check_failed;
}

}  // namespace magicmass::command
