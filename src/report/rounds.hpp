// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "report/portable_random.hpp"

namespace magicmass::report {

/// A piece of work to be timed. One repetition makes `evaluations` evaluations.
struct Timed {
  std::function<double(std::size_t repetitions)> nanoseconds;  ///< repeats it and says how long
  double evaluations = 1.0;
};

/// Work timed by the steady clock.
std::function<double(std::size_t)> on_steady_clock(std::function<void()> work);

/// What is timed side by side and compared.
using Group = std::vector<Timed>;

struct Plan {
  std::size_t rounds = 51;
  double shortest_ns = 5e4;       ///< of one measurement; never under 1000 ticks of the clock
  std::uint64_t seed = 20250101;  ///< of the order
  /// Asked before each group in each round with the share done, 0 to 1; false ends the timing.
  std::function<bool(double done)> go_on = [](double) { return true; };
};

/// Nanoseconds an evaluation: [group][work][round], all of a group of one length. In every round each group comes
/// once, in random order, and in it each work once, in random order, after a repetition that is not timed and brings
/// its data and code into the caches: what disturbs the machine for a while disturbs a whole group alike, and
/// the rounds of one work are spread over the whole run. Repetitions are doubled until a measurement is
/// long enough, once, before the first round.
using RoundTimes = std::vector<std::vector<std::vector<double>>>;
RoundTimes interleaved_rounds(const std::vector<Group>& groups, const Plan& plan);

/// Smallest step seen of the steady clock, in nanoseconds.
double clock_tick();

/// 0 ... size - 1 in an order that depends on the state of the generator alone, on every machine (unlike std::shuffle).
class RandomOrder {
public:
  explicit RandomOrder(std::uint64_t seed) : random_(seed) {}
  std::vector<std::size_t> next(std::size_t size);

private:
  PortableRandom random_;
};

}  // namespace magicmass::report
