// SPDX-License-Identifier: GPL-2.0-or-later
// The demo: what its sections print, and whether every comparison held.
#pragma once

#include <filesystem>
#include <string>

#include "command/destination.hpp"

namespace magicmass::command {

/// Prints as it goes and remembers a failed comparison.
class DemoReport {
public:
  explicit DemoReport(Destination& output) : output_(output) {}

  void heading(const std::string& text);
  void print(const std::string& text);
  /// A line with its verdict, ok or FAILED, at the right.
  void check(const std::string& what, bool holds);
  /// Counts in a comparison whose verdict a table shows itself.
  void count_in(bool holds) { failed_ = failed_ || !holds; }
  bool has_failed() const { return failed_; }
  bool is_colourful() const { return output_.is_colourful(); }

private:
  Destination& output_;
  bool failed_ = false;
  int headings_ = 0;
};

/// The derivation in short, and the code generated from it compared with generated/.
void show_derivation(DemoReport& report);
/// The paper's three trajectory scenes by events, compared with exact counts and theorems; their data into `folder`.
void show_scenes(DemoReport& report, const std::filesystem::path& folder);
/// The x-t figure of these scenes, drawn by gnuplot from the data in `folder`.
void draw_scenes(DemoReport& report, const std::filesystem::path& folder);
/// Errors and speed of every generated evaluator.
void show_evaluators(DemoReport& report);
/// Table II of the paper beside ours.
void show_ratios(DemoReport& report);

}  // namespace magicmass::command
