// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace magicmass::command {

/// What the program tells its caller (design, section 8).
enum class ExitCode {
  done = 0,
  check_failed = 1,  ///< not proved, a comparison failed, stale generated code
  bad_input = 2,     ///< bad usage or input
  undecided = 3,     ///< undecided, or the answer does not fit
};

}  // namespace magicmass::command
