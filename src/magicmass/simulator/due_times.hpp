// SPDX-License-Identifier: MIT
// When each gap closes, and which closes first: a tree of minima, so that a change costs O(log gaps).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace magicmass {

/// A time, or never.
template <class Scalar>
using Due = std::conditional_t<std::floating_point<Scalar>, Scalar, std::optional<Scalar>>;

template <class Scalar>
Due<Scalar> never() {
  if constexpr (std::floating_point<Scalar>) {
    return std::numeric_limits<Scalar>::infinity();
  } else {
    return std::nullopt;
  }
}

template <class Scalar>
bool is_never(const Due<Scalar>& due) {
  return due == never<Scalar>();
}

template <class Scalar>
const Scalar& time_of(const Due<Scalar>& due) {
  if constexpr (std::floating_point<Scalar>) {
    return due;
  } else {
    return *due;
  }
}

/// The due times of gaps 0, 1, ...; of equal times the leftmost gap wins. No time is NaN. In floating point eight
/// times are a node, in double a cache line: 200,000 gaps are six levels, of which the upper stay in the cache.
/// 8/7 of the times' own memory. Of exact numbers, whose comparison is what costs, two are a node.
template <class Scalar>
class DueTimes {
public:
  explicit DueTimes(std::size_t gaps) {
    std::size_t nodes = gaps;
    do {
      nodes = (nodes + fan_out - 1) / fan_out;
      levels_.emplace_back(nodes);
      for (Node& node : levels_.back()) node.children.fill(never<Scalar>());
    } while (nodes > 1);
  }

  const Due<Scalar>& operator[](std::size_t gap) const {
    return levels_.front()[gap / fan_out].children[gap % fan_out];
  }
  void set(std::size_t gap, Due<Scalar> due) {
    levels_.front()[gap / fan_out].children[gap % fan_out] = std::move(due);
  }

  /// To be called after set(): brings up to date what gaps first, ..., last may have changed.
  void replay(std::size_t first, std::size_t last) {
    for (std::size_t level = 1; level < levels_.size(); ++level) {
      first /= fan_out;
      last /= fan_out;
      for (std::size_t node = first; node <= last; ++node)
        levels_[level][node / fan_out].children[node % fan_out] = least(levels_[level - 1][node]);
    }
  }

  /// The gap that closes first; any where none does.
  std::size_t first() const {
    std::size_t node = 0;
    for (std::size_t level = levels_.size(); level-- > 0;)
      node = node * fan_out + first_least(levels_[level][node]);
    return node;
  }

  std::size_t bytes() const {
    std::size_t nodes = 0;
    for (const auto& level : levels_) nodes += level.capacity();
    return nodes * sizeof(Node);
  }

private:
  static constexpr std::size_t fan_out = std::floating_point<Scalar> ? 8 : 2;
  struct alignas(std::floating_point<Scalar> ? 64 : alignof(Due<Scalar>)) Node {
    std::array<Due<Scalar>, fan_out> children;
  };
  std::vector<std::vector<Node>> levels_;  // gaps first, the root last

  static bool sooner(const Due<Scalar>& x, const Due<Scalar>& y) {
    if constexpr (std::floating_point<Scalar>) {
      return x < y;
    } else {
      return x && (!y || *x < *y);
    }
  }

  static Due<Scalar> least(const Node& node) {
    const auto& due = node.children;
    const auto of_two = [](const Due<Scalar>& x, const Due<Scalar>& y) -> const Due<Scalar>& {
      return sooner(y, x) ? y : x;
    };
    if constexpr (fan_out == 2) {
      return of_two(due[0], due[1]);
    } else {  // a tree: each minimum waits for three others, not for seven
      return of_two(of_two(of_two(due[0], due[1]), of_two(due[2], due[3])),
                    of_two(of_two(due[4], due[5]), of_two(due[6], due[7])));
    }
  }

  static std::size_t first_least(const Node& node) {
    if constexpr (fan_out == 2) {
      return sooner(node.children[1], node.children[0]) ? 1 : 0;
    } else {  // all are compared: a loop that ends early is mispredicted half of the time
      const Due<Scalar> soonest = least(node);
      std::size_t place = 0;
      for (std::size_t i = fan_out; i-- > 0;) place = node.children[i] == soonest ? i : place;
      return place;
    }
  }
};

}  // namespace magicmass
