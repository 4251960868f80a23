// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/learn/judgement.hpp"
#include "command/learn/proved_content.hpp"

namespace magicmass::command {

/// What `learn test` found out about an exercise.
struct ContentReport {
  int variants = 0;
  int answers = 0;  ///< judged
  int misconceptions = 0;
  std::vector<std::string> failures = {};
};

/// The starter fails, the solution passes and is what its theorem says, each misconception is recognised, right
/// answers are accepted and wrong ones refused with a reason, every variant works, the texts hold.
ContentReport content_report(const Exercise& exercise, ProvedContent& proved);

}  // namespace magicmass::command
