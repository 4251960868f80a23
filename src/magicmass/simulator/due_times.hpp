// SPDX-License-Identifier: MIT
// Which gap closes first: a tournament, a binary heap whose leaves stay in place.
#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "magicmass/simulator/contact.hpp"

namespace magicmass::simulator {

/// When a gap closes. What closes at the same time is told apart by what a mirror shows, too: the
/// faster first, then the pair of the larger mass.
template <Field Scalar>
struct Due {
  Scalar time;
  Scalar closing;  ///< speed, > 0
  Scalar mass;     ///< of the bodies beside the gap

  bool operator==(const Due&) const = default;
  friend bool operator<(const Due& x, const Due& y) {
    if (!(x.time == y.time)) return x.time < y.time;
    if (!(x.closing == y.closing)) return y.closing < x.closing;
    return y.mass < x.mass;
  }
};

/// A change costs O(log gaps) comparisons.
template <Field Scalar>
class DueTimes {
public:
  using Entry = std::optional<Due<Scalar>>;  ///< nothing: never

  explicit DueTimes(std::size_t gaps) : due_(std::bit_ceil(gaps)), winner_(2 * due_.size()) {
    for (std::size_t gap = 0; gap < due_.size(); ++gap) winner_[due_.size() + gap] = gap;
    for (std::size_t node = due_.size(); node-- > 1;) winner_[node] = winner_[2 * node];
  }

  const Entry& operator[](std::size_t gap) const { return due_[gap]; }
  void set(std::size_t gap, Entry due) {
    due_[gap] = std::move(due);
    for (std::size_t node = (due_.size() + gap) / 2; node > 0; node /= 2) {
      const std::size_t left = winner_[2 * node];
      const std::size_t right = winner_[2 * node + 1];
      winner_[node] = is_sooner(due_[right], due_[left]) ? right : left;
    }
  }
  /// The gap that closes first, of equals the leftmost; any one where none does.
  std::size_t first() const { return winner_[1]; }

private:
  std::vector<Entry> due_;
  std::vector<std::size_t> winner_;  // of node n; nodes 2n and 2n + 1 are below it

  static bool is_sooner(const Entry& x, const Entry& y) { return x && (!y || *x < *y); }
};

}  // namespace magicmass::simulator
