// SPDX-License-Identifier: GPL-2.0-or-later
// What the tiers are to reach, and whether a run saw it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "report/event_figures.hpp"
#include "report/fallbacks.hpp"
#include "report/rows.hpp"

namespace magicmass::report {

/// What a run measured; `batches` are the times before they were combined.
struct Figures {
  std::vector<ErrorRow> errors;
  std::vector<TimeRow> times;
  std::vector<std::vector<TimeRow>> batches;
  std::vector<Fallbacks> fallbacks;
  std::vector<EventFigure> events = {};
};

/// A measured figure; NaN ends where there is no interval.
struct Seen {
  double value = 0.0;
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  std::string where = {};  ///< "zeros, velocities", "of 31000"
};

/// `unit` is written behind the numbers; must or aim is NaN where there is none.
struct Target {
  using Measure = std::optional<Seen> (*)(const Target&, const Figures&);

  std::string name;
  Measure measure;
  std::string quantity = {};                 ///< empty: all
  std::vector<std::string> evaluators = {};  ///< of a time, the first; else all of them
  std::string other = {};                    ///< what the time is compared with
  double must, aim;
  std::string unit = {};
  bool is_at_least = false;  ///< a speed-up; else what is measured is to be at most must
};

enum class Verdict { aim_reached, met, missed };
std::string name(Verdict verdict);  ///< "aim", "yes", "no"

struct TargetResult {
  Target target;
  Seen seen;
  Verdict verdict;
};

/// The table.
const std::vector<Target>& targets();

/// The targets of which something was measured, in their order. A ratio is judged by its median, not by its interval.
std::vector<TargetResult> judged(const Figures& figures);

}  // namespace magicmass::report
