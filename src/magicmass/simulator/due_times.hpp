// SPDX-License-Identifier: MIT
// When each gap closes, and which closes first: a tournament, so that a change costs O(log gaps) comparisons.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace magicmass {

/// A time, or never.
template <class Scalar>
using Due = std::conditional_t<std::floating_point<Scalar>, Scalar, std::optional<Scalar>>;

/// Later than any time.
template <class Scalar>
Due<Scalar> never() {
  if constexpr (std::floating_point<Scalar>) {
    return std::numeric_limits<Scalar>::infinity();
  } else {
    return std::nullopt;
  }
}

/// Whether it is that.
template <class Scalar>
bool is_never(const Due<Scalar>& due) {
  return due == never<Scalar>();
}

/// Of one that is not never().
template <class Scalar>
const Scalar& time_of(const Due<Scalar>& due) {
  if constexpr (std::floating_point<Scalar>) {
    return due;
  } else {
    return *due;
  }
}

/// The due times of gaps 0, 1, ...; of equal times the leftmost gap wins. In floating point a tournament of blocks of
/// eight gaps, which are seen through at once: half the memory and fewer cache lines than one of single gaps. Of exact
/// numbers comparisons are what costs, and each gap plays for itself.
template <class Scalar>
class DueTimes {
public:
  /// All gaps are never() due.
  explicit DueTimes(std::size_t gaps)
      : leaves_(std::bit_ceil((gaps + width - 1) / width)),
        due_((gaps + width - 1) / width * width, never<Scalar>()),
        winners_(2 * leaves_, none) {
    for (std::size_t block = 0; block < due_.size() / width; ++block) play_block(block);
    for (std::size_t node = leaves_; node-- > 1;) play(node);
  }

  /// When this gap is due.
  const Due<Scalar>& operator[](std::size_t gap) const { return due_[gap]; }
  /// first() knows of it after replay().
  void set(std::size_t gap, Due<Scalar> due) { due_[gap] = std::move(due); }

  /// To be called after set(): plays again what gaps first, ..., last may have changed.
  void replay(std::size_t first, std::size_t last) {
    std::size_t low = first / width;
    std::size_t high = last / width;
    for (std::size_t block = low; block <= high; ++block) play_block(block);
    low += leaves_;
    high += leaves_;
    while (low > 1) {
      low /= 2;
      high /= 2;
      for (std::size_t node = low; node <= high; ++node) play(node);
      if (low / parts == 1) part_ = low;
    }
  }

  /// The gap that is due first; any, where all are never().
  std::size_t first() const { return winners_[1]; }

  /// The first gap of that sixteenth of all gaps which was played last: its turn comes in sixteen events or so, time
  /// to have its memory brought here. Asks for what is known of it.
  std::size_t fetch_soon() const {
    const std::size_t gap = winners_[part_] == none ? 0 : winners_[part_];
    const std::size_t leaf = leaves_ + gap / width;
    __builtin_prefetch(&due_[gap]);
    for (const std::size_t node : {leaf, leaf / 2, leaf / 4}) __builtin_prefetch(&winners_[node]);
    return gap;
  }

  /// Memory it holds.
  std::size_t bytes() const {
    return due_.capacity() * sizeof(Due<Scalar>) + winners_.capacity() * sizeof(Gap);
  }

private:
  using Gap = std::uint32_t;
  static constexpr Gap none = std::numeric_limits<Gap>::max();
  static constexpr std::size_t width = std::floating_point<Scalar> ? 8 : 1;

  std::size_t leaves_;
  std::vector<Due<Scalar>> due_;
  std::vector<Gap> winners_;
  static constexpr std::size_t parts = 16;
  std::size_t part_ = 1;

  void play_block(std::size_t block) {
    std::size_t best = block * width;
    for (std::size_t gap = best + 1; gap < (block + 1) * width; ++gap)
      if (sooner(due_[gap], due_[best])) best = gap;
    winners_[leaves_ + block] = static_cast<Gap>(best);
  }

  void play(std::size_t node) {
    const Gap left = winners_[2 * node];
    const Gap right = winners_[2 * node + 1];
    winners_[node] = right != none && sooner(due_[right], due_[left]) ? right : left;
  }

  static bool sooner(const Due<Scalar>& x, const Due<Scalar>& y) {
    if constexpr (std::floating_point<Scalar>) {
      return x < y;
    } else {
      return x && (!y || *x < *y);
    }
  }
};

}  // namespace magicmass
