// SPDX-License-Identifier: GPL-2.0-or-later
// Everything that one run measured, for the tables and figures to show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command/report/alpha_sweep.hpp"
#include "command/report/progress.hpp"
#include "command/report/provenance.hpp"
#include "command/report/report_tasks.hpp"
#include "report/contestant.hpp"
#include "report/family.hpp"
#include "report/growth.hpp"
#include "report/rows.hpp"
#include "report/targets.hpp"

namespace magicmass::command {

/// One contestant on one family: its members' errors and its times.
struct Entry {
  std::string evaluator, precision;
  bool is_naive = false, is_reproducible = true;
  std::vector<report::ErrorRow> errors;  ///< a member each
  std::optional<report::TimeRow> time;

  /// The member with the largest error in ulp; for counts the most wrong answers. There is none of what gives no
  /// answers.
  const report::ErrorRow& worst() const;
};

struct MeasuredFamily {
  report::Family family;
  std::vector<Entry> entries;
};

/// Naive in double timed against a second copy of itself: what the instrument adds of its own.
struct SelfComparison {
  std::size_t families = 0;
  std::size_t holding_one = 0;  ///< whose interval contains 1
  double lowest = 1.0, highest = 1.0;
};

struct Measurement {
  Provenance provenance;
  std::vector<MeasuredFamily> families;  ///< hardest first within a quantity
  std::vector<report::TargetResult> targets;
  std::vector<report::Growth> growths;
  std::vector<AlphaSweep> sweeps;
  SelfComparison self;
  std::vector<std::string> remarks;  ///< "skipped: ..."
  bool is_complete = true;           ///< false after Ctrl-C
};

/// Throws InvalidInput for a name that is not there.
Measurement measure(const ReportRequest& request, Progress& progress);

}  // namespace magicmass::command
