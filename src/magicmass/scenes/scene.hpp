// SPDX-License-Identifier: GPL-2.0-or-later
// A scene: bodies on a line and what is asked of them, read from a file of TOML.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "magicmass/scenes/value.hpp"
#include "magicmass/simulator/line.hpp"

namespace magicmass::scenes {

/// Blocks A, B and a ball C between them; a block A, a ball C and a wall; any bodies.
enum class Kind { three_body, wall, chain };

struct Scene {
  std::string source;  ///< the file, for messages
  Kind kind = Kind::three_body;
  std::vector<Value> masses;  ///< from left to right
  std::vector<Value> positions;
  std::vector<Value> velocities;
  std::optional<Value> left_wall;
  std::optional<Value> right_wall;
  Value restitution = value_of(1);
  Value V = value_of(1);  ///< velocity of the first body, where `velocities` does not say
  Value L = value_of(1);  ///< from a ball to the next block or wall, where `positions` does not say
  Value gap = value_of(1);     ///< likewise from a block to the next ball in a chain
  std::string walls = "none";  ///< of a chain that is laid out: left, right, both
  std::vector<std::string> outputs = {"counts", "terminal"};
  std::int64_t every = 1;                     ///< of so many collisions one is shown
  std::vector<Value> times;                   ///< of a trajectory
  std::optional<Value> until;                 ///< the run stops after this time
  std::optional<std::int64_t> max_events;     ///< and after so many collisions
  bool is_exact = false;                      ///< in exact numbers, whatever the plan would be
  std::map<std::string, std::int64_t> lines;  ///< of the keys that the file has

  bool wants(const std::string& output) const;
  /// Whether the file has this key.
  bool has(const std::string& key) const { return lines.count(key) != 0; }
  /// Of collisions that are stepped, or that would never end.
  std::int64_t limit() const { return max_events.value_or(1'000'000); }
  /// At which end a body receives what the only one that moves, at the other end, hands on.
  std::optional<std::size_t> receiver() const;
};

/// Reads a file of at most 8 MiB. What is no scene, or has no meaning, is refused: throws
/// InvalidInput, `file:line: key: what; allowed: ...` on one line.
Scene read_scene(const std::string& path);
/// The same from text.
Scene parse_scene(std::string_view text, const std::string& source);

/// A, C, B, where C is the ball; in a chain 1, 2, ..., of blocks and balls A_1, C_1, A_2, ...
std::string body_name(const Scene& scene, std::size_t body);
/// What the collisions at a gap are called: N_A, N_B for three bodies; by the names beside it else.
std::string gap_name(const Scene& scene, std::size_t gap);

/// Whether no value, be it a time, is a ratio of the paper, and there are no two roots.
bool has_exact_numbers(const Scene& scene);
/// The bodies in doubles, or as Quadratic, where all are exact. Throws Undecided where a value does
/// not fit a double.
template <class Scalar>
simulator::Line<Scalar> line_of(const Scene& scene);

/// Throws InvalidInput with the place of a key.
[[noreturn]] void refuse_key(const Scene& scene, const std::string& key, const std::string& what,
                             std::string_view allowed);
/// "; is gap meant?" of gpa: all but one or two neighbouring letters, fewer than half, are the same
/// in one of the names; otherwise that.
std::string meant(const std::string& name, const std::vector<std::string>& names,
                  const std::string& otherwise = "");

}  // namespace magicmass::scenes
