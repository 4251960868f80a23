// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes as text, and what they come to in doubles.
#pragma once

#include "magicmass/scenes/run.hpp"

namespace magicmass::scenes {

inline double number(const Number& value) { return double_of(value).value(); }
inline Scene scene_of(const std::string& text, bool is_exact = false) {
  Scene scene = parse_scene(text, "scene");
  scene.is_exact = is_exact;
  return scene;
}
inline Result result_of(const std::string& text, bool is_exact = false) {
  return run(scene_of(text, is_exact));
}
inline std::vector<Row> rows_of(const Scene& scene) {
  std::vector<Row> rows;
  stream(scene, run(scene).plan, [&](const Row& row) { rows.push_back(row); });
  return rows;
}

}  // namespace magicmass::scenes
