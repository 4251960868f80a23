// SPDX-License-Identifier: GPL-2.0-or-later
// One row a command; what a later version brings back is named in one line.
#include "command/commands.hpp"

namespace command {

Program magicmass() {
  return {
      .name = "magicmass",
      .summary = "Magic mass ratios: from conservation laws to proved, generated, measured C++",
      .version = MAGICMASS_VERSION,
      .commands = {},
      .absent = {"derive", "verify", "equal", "generate", "eval", "count", "terminal", "ratios",
                 "simulate", "plan", "figure", "reproduce", "report", "learn"},
      .absent_advice = "not in this version yet; until then use commit 77d7ebf",
  };
}

}  // namespace command
