// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "magicmass/errors.hpp"

namespace magicmass::algebraic {

/// What a question may cost. Whatever is asked, the answer comes within about `time`: a single operation of CLN at
/// `bits` cannot be interrupted, and takes below half a second at the default.
struct Budget {
  long bits = 1L << 18U;                 ///< the highest working precision
  std::chrono::milliseconds time{1000};  ///< for the whole question, inner decisions included
  long terms = 20000;  ///< the most terms that an expansion may multiply out at a time
  long nodes = 20000;  ///< the most different subexpressions
  long depth = 4000;   ///< the deepest nesting
};

/// The budget ran out; what() says of what there was too much.
struct BeyondBudget : Undecided {
  using Undecided::Undecided;
};

/// A budget being spent.
class Work {
public:
  /// Begins now.
  explicit Work(const Budget& budget)
      : budget_(budget), end_(std::chrono::steady_clock::now() + budget.time) {}

  /// As it was at the beginning.
  const Budget& budget() const { return budget_; }
  /// Throws BeyondBudget once the time is up.
  void check_time() const {
    if (std::chrono::steady_clock::now() >= end_)
      throw BeyondBudget("more than " + std::to_string(budget_.time.count()) + " ms");
  }
  /// Of the time allowed, what is left.
  std::chrono::duration<double> left() const { return end_ - std::chrono::steady_clock::now(); }

private:
  Budget budget_;
  std::chrono::steady_clock::time_point end_;
};

}  // namespace magicmass::algebraic
