// SPDX-License-Identifier: MIT
// A scene: what happens and which outputs are asked for, read from a TOML file (design, section 7).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass {

/// What a scene may ask for, in the order in which answers are printed.
enum class Output { counts, terminal, events, trajectory, energy };

/// Block A with speed V towards ball C at rest at x = 0 and block B at rest at x = L; all contacts elastic.
struct Scene {
  std::string title;                ///< free text, may be empty
  std::string kind = "three-body";  ///< the only kind so far
  MassRatio alpha;                  ///< ball mass / block mass, required
  double V = 1.0;                   ///< incident speed, positive and finite
  double L = 1.0;                   ///< initial distance C to B, positive and finite
  double restitution = 1.0;         ///< elastic, the only value so far
  std::vector<Output> outputs = {Output::counts,
                                 Output::terminal};  ///< in Output's order, none twice

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Does the scene ask for this output?
bool wants(const Scene& scene, Output output);

/// The name a scene file uses, e.g. "counts".
std::string_view to_text(Output output);

/// Reads a scene from TOML text. Every key but alpha has the default above; an unknown key is refused.
/// Throws InvalidInput: `source_name:line: key: what was wrong; allowed: ...`, on one line.
Scene parse_scene(std::string_view text, std::string_view source_name);

/// The same from a file of at most one mebibyte. Throws InvalidInput also where it cannot be read.
Scene read_scene(const std::string& path);

}  // namespace magicmass
