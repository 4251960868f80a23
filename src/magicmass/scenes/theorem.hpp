// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of a trio or a cradle by theorems: counted, not stepped.
#pragma once

#include "magicmass/scenes/cradle.hpp"
#include "magicmass/scenes/run.hpp"

namespace magicmass::scenes {

/// A motion that theorems tell, or what a mirror shows of it.
template <class Motion>
struct Seen {
  Motion motion;
  bool is_mirrored;

  /// Nothing where the scene is neither.
  static std::optional<Seen> of(const Scene& scene);
  /// How many collisions are within the scene's limits; nothing: infinitely many, a collapse.
  /// Throws Undecided where one may be as late as `until`.
  std::optional<std::int64_t> within(const Scene& scene) const;
  /// All but the plan after so many collisions, or after infinitely many of a trio; each number the
  /// nearest double. Throws Undecided where that is not certain with the bits that are allowed,
  /// std::domain_error where masses are too far apart.
  Result after(std::optional<std::int64_t> collisions) const;
  /// So many collisions, each number the nearest double; of infinitely many those whose times
  /// doubles can tell apart.
  void stream(std::optional<std::int64_t> collisions, const Sink& sink) const;
  /// When collision j takes place, the nearest double.
  double time(std::int64_t j) const;
};

}  // namespace magicmass::scenes
