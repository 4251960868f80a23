// Scenes as text, and what they come to in doubles.
#pragma once

#include <array>

#include "catch.hpp"
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
/// As a scene writes it.
inline std::string quoted(const cln::cl_RA& x) { return "'" + Surd(x).text() + "'"; }
inline std::string list(const std::vector<std::string>& values) {
  std::string all;
  for (const std::string& value : values) all += value + ", ";
  return "[" + all + "]\n";
}
inline void check_mirrored(const Result& result, const Result& mirrored) {
  REQUIRE((mirrored.status == result.status && mirrored.events == result.events));
  REQUIRE(number(mirrored.energy) == number(result.energy));
  REQUIRE(mirrored.counts == std::vector(result.counts.rbegin(), result.counts.rend()));
  const std::size_t bodies = result.terminal.size();
  for (std::size_t k = 0; k < bodies; ++k)
    REQUIRE(number(mirrored.terminal[bodies - 1 - k]) == -number(result.terminal[k]));
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
