// SPDX-License-Identifier: GPL-2.0-or-later
// A measurement as text, Markdown, JSON and CSV.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "command/destination.hpp"
#include "command/records.hpp"
#include "command/report/measurement.hpp"

namespace magicmass::command {

/// Tables of at most 80 columns, one for each family; speed and error in the same row.
std::string report_text(const Measurement& measurement);
std::string report_markdown(const Measurement& measurement);
/// Cells by the name of their column; what is not set is missing.
using Record = std::map<std::string, Cell>;
/// A record for each member of each evaluator on each family, then one for each target and each point of the growth.
std::vector<Record> report_records(const Measurement& measurement);
/// The same as JSON or CSV.
void write_report_records(Destination& output, const std::string& format,
                          const Measurement& measurement);

/// What the tiers are to reach and what was seen; empty where nothing of it was measured.
std::string targets_text(const std::vector<report::TargetResult>& results);
std::string targets_markdown(const std::vector<report::TargetResult>& results);
std::vector<Record> targets_records(const std::vector<report::TargetResult>& results);

/// A row of a Markdown table, and its head, whose first columns are words and whose others are numbers.
std::string markdown_row(const std::vector<std::string>& cells);
std::string markdown_head(const std::vector<std::string>& names, std::size_t words);

/// A Markdown table in short: the evaluators in double that tell most, where they do worst and on the easiest family.
std::string report_headline(const Measurement& measurement);
/// `text`, which `path` holds, with what stands between its two marks replaced by the headline. Throws InvalidInput without them.
std::string with_headline(const std::string& text, const std::string& headline,
                          const std::string& path);

/// What the columns are, for readers of the tables.
std::string report_legend(const Measurement& measurement);

/// Seven characters at most: 0.51, 12.3, 4711, 1.2e15, inf, and - for what is not there.
std::string short_number(double value);
/// The ratio, with a ? in front where its batches disagree.
std::string shown_ratio(const report::TimeRow& time);
/// "0.51 (0.50 to 0.52)", or -.
std::string shown_ratio_with_interval(const std::optional<report::TimeRow>& time);
std::string short_precision(const std::string& precision);  ///< f, d, ld
/// alpha = 0x1.8p-3, n = 7: as the quantity calls its index.
std::string shown_input(const std::string& quantity, const report::Input& input);
/// Slopes of a growth: "time ~ n^(1.00 +- 0.01), error ~ n^(0.98 +- 0.05)".
std::string shown_exponents(const report::Growth& growth);

}  // namespace magicmass::command
