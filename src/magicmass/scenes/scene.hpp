// SPDX-License-Identifier: MIT
// A scene: what happens and which outputs are asked for, read from a TOML file (tutorials/scenes/README.md).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "magicmass/scenes/mass_ratio.hpp"
#include "magicmass/scenes/value.hpp"

namespace magicmass {

/// What a scene may ask for, in the order in which answers are printed.
enum class Output { counts, terminal, events, trajectory, energy };

/// What is on the line: two blocks and a ball between them; a block, a ball and a wall; any bodies.
enum class Kind { three_body, wall, chain };

/// Bodies on a line, from left to right, as they are written: each value is of the right form, and whether the scene
/// makes sense (positive masses, no overlap) is decided where they are exact numbers: exact_line().
/// Laid out where there are no positions: the first body at 0, each other one `gap` or `L` from the one before, in
/// turn; a laid-out wall likewise. Without velocities the first body has V and the others rest.
struct Scene {
  std::string title;             ///< free text, may be empty
  std::string source;            ///< file name, for messages
  Kind kind = Kind::three_body;  ///< one of the three
  std::optional<MassRatio>
      alpha;  ///< equal blocks of mass 1 and a ball, laid out: the paper's state, up to units
  std::vector<Value> masses;        ///< of each body, from left to right
  std::vector<Value> positions;     ///< as many as masses, or none: laid out
  std::vector<Value> velocities;    ///< as many as masses, or none
  Value V = 1.0;                    ///< speed of the first body
  Value L = 1.0;                    ///< distance of the second and third body, and so on
  Value gap = 0.0;                  ///< distance of the first and second body, and so on
  Value restitution = 1.0;          ///< of every contact
  bool has_left_wall = false;       ///< to the left of all bodies
  bool has_right_wall = false;      ///< to the right of all bodies
  std::optional<Value> left_wall;   ///< where it is; laid out without
  std::optional<Value> right_wall;  ///< likewise
  std::vector<Output> outputs = {Output::counts,
                                 Output::terminal};    ///< in Output's order, none twice
  std::int64_t every = 1;                              ///< of the events, print each so manieth
  std::vector<Value> times;                            ///< ask for the positions at these times
  std::optional<Value> until;                          ///< the run stops at this time
  std::optional<std::int64_t> max_events;              ///< the run stops after so many
  std::map<std::string, unsigned, std::less<>> lines;  ///< of each key that the file has
};

/// Most bodies of a scene.
inline constexpr std::size_t most_bodies = 2'000'001;

/// Does the scene ask for this output?
bool wants(const Scene& scene, Output output);

/// The name a scene file uses, e.g. "counts", "three-body".
std::string_view to_text(Output output);
/// Likewise.
std::string_view to_text(Kind kind);

/// The name of body i: A, C, B; A_1, C_1, A_2, ... in a chain of blocks and balls.
std::string body_name(const Scene& scene, std::size_t body);

/// Throws InvalidInput: `source:line: key: what; allowed: allowed`.
[[noreturn]] void refuse_key(const Scene& scene, std::string_view key, const std::string& what,
                             std::string_view allowed);

/// Reads a scene from TOML text. An unknown key is refused.
/// Throws InvalidInput: `source_name:line: key: what was wrong; allowed: ...`, on one line.
Scene parse_scene(std::string_view text, std::string_view source_name);

/// The same from a file of at most one mebibyte. Throws InvalidInput also where it cannot be read.
Scene read_scene(const std::string& path);

}  // namespace magicmass
