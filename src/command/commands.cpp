// SPDX-License-Identifier: GPL-2.0-or-later
// One row a command; what a later version brings back is named in one line.
#include "command/commands.hpp"

#include "answers/derivation.hpp"
#include "command/generate.hpp"

namespace command {

Program magicmass() {
  return {
      .name = "magicmass",
      .summary = "Magic mass ratios: from conservation laws to proved, generated, measured C++",
      .version = MAGICMASS_VERSION,
      .commands =
          {
              {"derive",
               "The derivation, line by line",
               "magicmass derive counting",
               {{"from", "STEP", "a step and what it rests on"},
                {"list", "", "the paper's labels, theorems and formulas"}},
               "CHAPTER or STEP",
               {"text", "markdown", "json"},
               answers::derive_columns(),
               answers::derive},
              {"verify",
               "Proves every line of the derivation again",
               "magicmass verify",
               {},
               "",
               {"text", "json", "csv"},
               answers::verify_columns(),
               answers::verify},
              {"generate",
               "Emits C++ evaluators from the proved theorems",
               "magicmass generate --check",
               {{"out", "FOLDER", "where the files go or are, generated unless told otherwise"},
                {"check", "", "compares instead: exit code 1 where a file differs"}},
               "",
               {"text"},
               {},
               generate_files},
          },
      .absent = {"equal", "eval", "count", "terminal", "ratios", "simulate", "plan", "figure",
                 "reproduce", "report", "learn"},
      .absent_advice = "not in this version yet; until then use commit 77d7ebf",
  };
}

}  // namespace command
