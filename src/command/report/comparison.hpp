// SPDX-License-Identifier: GPL-2.0-or-later
// Do two reports agree? Errors must be the same, ratios of times within their intervals.
#pragma once

#include <string>
#include <vector>

#include "command/report/report_tables.hpp"

namespace magicmass::command {

/// One report, its records in their order.
struct KnownReport {
  std::string name;  ///< for the reader: the file's name, "this run"
  std::vector<Record> records;
};

/// What `report --format json` wrote. Throws InvalidInput where it is something else.
KnownReport read_report(const std::string& path);

struct Comparison {
  std::string text;  ///< what was compared, and each row that differs
  bool agrees = true;
};

/// Compares what both have. Errors of what is reproducible agree when each figure does. An evaluator's ratio on a family
/// agrees when the two intervals meet: of intervals of 95 %, some 1 in 300 miss by chance, so 1 in 100 and one
/// more may, but none by more than a tenth. Ratios of different machines, compilers or flags are not compared.
/// Throws InvalidInput if the two have nothing in common.
Comparison compare_reports(const KnownReport& old_report, const KnownReport& new_report);

}  // namespace magicmass::command
