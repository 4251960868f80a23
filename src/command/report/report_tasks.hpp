// SPDX-License-Identifier: GPL-2.0-or-later
// What a report is asked for, and what follows from it: the same in the program and in each of its timing batches.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/contestant.hpp"
#include "report/family.hpp"
#include "report/timing.hpp"

namespace magicmass::command {

struct ReportRequest {
  bool quick = false;
  bool peers = false;
  std::string function;                 ///< a file with the reader's own velocities; empty: none
  std::vector<std::string> families;    ///< empty: all
  std::vector<std::string> evaluators;  ///< empty: all; naive is always there
  std::vector<std::string> quantities;  ///< empty: all
  std::optional<std::size_t> size;      ///< inputs a family
  std::optional<std::size_t> rounds = {};
  std::size_t timing_rounds() const { return rounds.value_or(quick ? 27 : 51); }
  bool growth = true;
  bool sweeps = false;  ///< errors against alpha, for a figure
};

/// Everything of one quantity.
struct Task {
  std::vector<report::Contestant> contestants;
  std::vector<report::Family> families;
};

/// The quantities that are asked for; throws InvalidInput for a name that is not there, and for that of a family.
std::vector<std::string> asked_quantities(const ReportRequest& request);

/// A task for each quantity that is asked for, with those of the further contestants that belong to it. Throws
/// InvalidInput as above, and for an evaluator's name that is not there.
std::vector<Task> report_tasks(const ReportRequest& request,
                               const std::vector<report::Contestant>& further);

report::TimingPlan timing_plan(const ReportRequest& request);

/// The known-bad canary in double, to which times are compared.
bool is_baseline(const report::Contestant& one);

}  // namespace magicmass::command
