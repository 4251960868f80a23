// SPDX-License-Identifier: GPL-2.0-or-later
// One row a command; what a later version brings back is named in one line.
#include "command/commands.hpp"

#include "answers/derivation.hpp"
#include "answers/velocities.hpp"
#include "command/figure.hpp"
#include "command/generate.hpp"
#include "report/report.hpp"

namespace command {

Program magicmass() {
  const Option alpha{"alpha", "ALPHA", "mass ratio: 0.12, 1/7, magic:3, deficient:2",
                     {},      true,    true};
  const Option tier{"tier",
                    "TIER",
                    "fast, accurate (unless told otherwise), exact",
                    {"fast", "accurate", "exact"}};
  const Option digits{"digits", "D", "so many significant digits, with certainty"};
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
               {"text", "markdown", "latex", "html", "json"},
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
              {"eval",
               "Velocities after n cycles",
               "magicmass eval --alpha 0.12 --n 2",
               {alpha, {"n", "N", "cycles, 0 to N_A", {}, true, true}, tier, digits},
               "",
               {"text", "json", "csv"},
               answers::eval_columns(),
               answers::eval},
              {"count",
               "Numbers of collisions, exactly",
               "magicmass count --alpha 1e-200",
               {alpha},
               "",
               {"text", "json", "csv"},
               answers::count_columns(),
               answers::count},
              {"terminal",
               "Counts and terminal velocities",
               "magicmass terminal --alpha magic:3",
               {alpha,
                {"restitution", "E", "of each collision, above 0, 1 unless told otherwise"},
                tier,
                digits},
               "",
               {"text", "json", "csv"},
               answers::terminal_columns(),
               answers::terminal},
              {"ratios",
               "Magic and deficient mass ratios",
               "magicmass ratios --count 10 --digits 30",
               {{"count", "K", "how many, 10 unless told otherwise"}, digits},
               "",
               {"text", "json", "csv"},
               answers::ratios_columns(),
               answers::ratios},
              {"figure",
               "A figure of the paper",
               "magicmass figure terminal -o terminal.svg",
               {{"list", "", "their names"}},
               "NAME",
               {"svg", "png", "csv"},
               {},
               figure},
              {"generate",
               "Emits C++ evaluators from the proved theorems",
               "magicmass generate --check",
               {{"out", "FOLDER", "where the files go or are, generated unless told otherwise"},
                {"check", "", "compares instead: exit code 1 where a file differs"},
                {"quantity", "LIST", "one header with these alone, such as a_t,rho, to stdout"},
                {"form",
                 "FORM",
                 "of --quantity, tangent unless told otherwise",
                 {"closed", "product", "tangent", "exact"}}},
               "",
               {"text"},
               {},
               generate_files},
              {"report",
               "Speed against error of every implementation",
               "magicmass report --quick",
               {{"quick", "", "fewer inputs, shorter measurements"},
                {"only", "NAME", "one quantity, family or evaluator"}},
               "",
               {"text", "markdown", "json", "csv"},
               report::columns(),
               report::report,
               300},
          },
      .absent = {"equal", "simulate", "plan", "reproduce", "learn"},
      .absent_advice = "not in this version yet; until then use commit 77d7ebf",
  };
}

}  // namespace command
