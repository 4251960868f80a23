// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes as text, and what they come to in doubles.
#pragma once

#include <array>

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
/// Those that the scene wants to see.
inline std::vector<Row> rows_of(const Scene& scene) {
  std::vector<Row> rows;
  const auto keep = [&](const Row& row) { rows.push_back(row); };
  stream(scene, run(scene).plan, keep, scene.every);
  return rows;
}
/// Gap, time, position, velocities after it.
using Numbers = std::array<double, 5>;
template <class Scalar>
Numbers numbers(const simulator::Collision<Scalar>& row) {
  return {double(row.gap), number(row.time), number(row.position), number(row.v_left),
          number(row.v_right)};
}
inline std::vector<Numbers> numbers_of(const Scene& scene) {
  std::vector<Numbers> all;
  for (const Row& row : rows_of(scene)) all.push_back(numbers(row));
  return all;
}

}  // namespace magicmass::scenes
