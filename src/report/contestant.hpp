// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace magicmass::report {

/// What an evaluator is asked: a mass ratio and a cycle n, a collision j or a ratio's k. A quantity that does not need
/// one of them ignores it.
struct Input {
  double alpha;
  std::int64_t index;
  double e = 1.0;  ///< coefficient of restitution
};

/// "velocities" has the members a, b, c, c_prime and the inputs alpha, n.
struct Quantity {
  std::string name;
  std::vector<std::string> members;
  std::vector<std::string> inputs = {};
  /// There is a transcription of the paper to compare with and an oracle; else it is known from the generated tables
  /// alone.
  bool is_known = true;
  bool takes(const std::string& input) const;
  /// n, j or k, or nothing.
  std::string index() const;
};

/// Work on inputs that were laid out beforehand; a call of `run` makes so many evaluations.
struct Prepared {
  std::function<void()> run;
  double evaluations = 1.0;
};

/// One way to get the numbers: a generated evaluator, the paper's formulas transcribed, event stepping, ...
struct Contestant {
  std::string
      name;  ///< "velocities_product", "naive", "stepping": unique with quantity and precision
  std::string quantity;  ///< Quantity::name
  std::string
      form;  ///< "closed", "product", ..., as in the manifest; "naive" and so on for the others
  std::string precision;  ///< "float", "double", "long double": what its errors are measured in
  std::string derived_form = {};  ///< of the theorem that it computes, where it computes one
  bool is_naive = false;          ///< the known-bad canary, to which times are compared
  /// Largest error that a generated header promises, in ulp of the exact value, and in eps of the body's largest
  /// velocity at that alpha (beyond alpha = 1: of V). Infinity: nothing is promised.
  double ulp_bound = std::numeric_limits<double>::infinity();
  double eps_bound = std::numeric_limits<double>::infinity();
  /// False where it would take too long or has no meaning (stepping at n = 2^40).
  std::function<bool(const Input&)> can = {};
  /// Roughly the nanoseconds of one evaluation, by rule and not by clock: from it follows on which inputs a slow one
  /// is timed, the same in every run. Empty: it is fast.
  std::function<double(const Input&)> expected_ns = {};
  /// One evaluation; writes the quantity's members in order.
  std::function<void(const Input&, long double* members)> evaluate = {};
  /// All inputs one after another, with nothing but the evaluator in the loop: throughput.
  std::function<void(std::span<const Input>)> evaluate_all = {};
  /// For what works on arrays: copies the inputs into arrays as it wants them, which is not timed, as a loop over them is
  /// not part of the others. Empty: evaluate_all is timed.
  std::function<Prepared(std::span<const Input>)> prepare = {};
  /// The same, but each evaluation waits for the one before: latency. Empty for what works on arrays.
  std::function<void(std::span<const Input>)> evaluate_chained = {};
  /// Nanoseconds for so many repetitions of evaluate_all by a clock of its own: what runs in another process.
  std::function<double(std::span<const Input>, std::size_t repetitions)> own_clock = {};
  /// Whether certified arithmetic had to decide, after all that is faster had failed to. Empty: there is no such thing.
  std::function<bool(const Input&)> falls_back = {};
  /// Timed beside the others, but gives no answer: a copy loop.
  bool is_yardstick = false;
  /// False where the order of operations changes from run to run (GiNaC's terms), and the last bits with it.
  bool is_reproducible = true;
};

}  // namespace magicmass::report
