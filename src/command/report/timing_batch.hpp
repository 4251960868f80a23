// SPDX-License-Identifier: GPL-2.0-or-later
// A batch of timing rounds in a process of its own, so that each has another memory layout, and formulas that are
// compiled anew: what differs from run to run differs from batch to batch.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "command/report/progress.hpp"
#include "command/report/report_tasks.hpp"
#include "report/rows.hpp"

namespace magicmass::command {

/// A second copy of naive in double, timed against it: what the instrument adds of its own.
inline constexpr const char* twin = "naive again";

/// In the child: times what is asked for, with the formulas that it reads as one line, and writes the rows as lines;
/// ends early when nobody reads them any more.
void run_timing_batch(const ReportRequest& request, std::size_t batch, std::istream& in,
                      std::ostream& out);

/// In the parent: starts this program again for batch number `batch` and waits for its rows; nothing after Ctrl-C.
/// `done` is the share of all batches before this one and after it, for the progress line. Throws
/// std::runtime_error if the child ends without having finished.
struct BatchCall {
  std::size_t batch = 0, batches = 1;
  std::string formulas;  ///< in_one_line
};
std::optional<std::vector<report::TimeRow>> timing_batch(const ReportRequest& request,
                                                         const BatchCall& call, Progress& progress);

/// A row as a line and back; std::nullopt for a line that is no row.
std::string line_of(const report::TimeRow& row);
std::optional<report::TimeRow> row_from_line(const std::string& line);

}  // namespace magicmass::command
