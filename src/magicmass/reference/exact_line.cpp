// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/exact_line.hpp"

#include <cmath>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::reference {
namespace {

ExactValue worth(const Scene& scene, std::string_view key, const Value& value) {
  try {
    return exact_value(value);
  } catch (const InvalidInput& error) {
    refuse_key(scene, key, "got \"" + shown_text(to_text(value)) + "\": " + error.what(),
               allowed_values);
  }
}

/// The key that a body's mass comes from.
std::string_view mass_key(const Scene& scene) {
  for (const std::string_view key : {"masses", "alpha", "mass_ratio", "balls"})
    if (scene.lines.contains(key)) return key;
  return "blocks";
}

/// The values of a scene but its masses, with the keys they come from.
struct Written {
  std::vector<std::string_view> keys;
  std::vector<ExactValue> values;
  CommonField field = {};

  void add(const Scene& scene, std::string_view key, const Value& value) {
    keys.push_back(key);
    values.push_back(worth(scene, key, value));
  }
};

/// Lays out bodies and walls, or takes them where they are told to be.
void place(const Scene& scene, const CommonField& field, Line<FieldNumber>& line) {
  const auto number = [&](const Value& value) { return in_field(exact_value(value), field); };
  const std::size_t bodies = scene.masses.size();
  const FieldNumber gap = number(scene.gap), L = number(scene.L);
  const auto after = [&](std::size_t body) { return body % 2 == 0 ? gap : L; };
  FieldNumber x(0);
  for (std::size_t i = 0; i < bodies; ++i) {
    line.positions.push_back(scene.positions.empty() ? x : number(scene.positions[i]));
    x = line.positions.back() + after(i);
    line.velocities.push_back(scene.velocities.empty() ? (i == 0 ? number(scene.V) : FieldNumber(0))
                                                       : number(scene.velocities[i]));
  }
  if (scene.has_left_wall)
    line.left_wall = scene.left_wall ? number(*scene.left_wall) : line.positions[0] - gap;
  if (scene.has_right_wall) line.right_wall = scene.right_wall ? number(*scene.right_wall) : x;
  line.restitution = number(scene.restitution);
}

void check_numbers(const Scene& scene, const CommonField& field) {
  const auto sign_at = [&](const Value& value) {
    return in_field(exact_value(value), field).sign();
  };
  const auto positive = [&](std::string_view key, const Value& value) {
    if (sign_at(value) <= 0)
      refuse_key(scene, key, "got " + shown_text(to_text(value)), "a positive number");
  };
  positive("V", scene.V);
  positive("L", scene.L);
  if (sign_at(scene.gap) < 0)
    refuse_key(scene, "gap", "got " + shown_text(to_text(scene.gap)), "0 or a positive number");
  const FieldNumber e = in_field(exact_value(scene.restitution), field);
  if (e.sign() <= 0 || FieldNumber(1) < e)
    refuse_key(scene, "restitution", "got " + shown_text(to_text(scene.restitution)),
               "above 0 and at most 1");
  for (const Value& time : scene.times)
    if (sign_at(time) < 0)
      refuse_key(scene, "times", "got " + shown_text(to_text(time)),
                 "0, the start, or a positive number");
  if (scene.until) positive("until", *scene.until);
}

void check_order(const Scene& scene, const Line<FieldNumber>& line) {
  const auto shown = [](const FieldNumber& x) { return shown_text(to_text(x)); };
  for (std::size_t i = 1; i < line.positions.size(); ++i)
    if (line.positions[i] < line.positions[i - 1])
      refuse_key(scene, "positions",
                 body_name(scene, i - 1) + " at " + shown(line.positions[i - 1]) +
                     " is to the right of " + body_name(scene, i) + " at " +
                     shown(line.positions[i]),
                 "bodies from left to right, which may touch");
  if (line.left_wall && line.positions.front() < *line.left_wall)
    refuse_key(scene, "left_wall",
               body_name(scene, 0) + " at " + shown(line.positions.front()) +
                   " is beyond the wall at " + shown(*line.left_wall),
               "a wall to the left of all bodies");
  if (line.right_wall && *line.right_wall < line.positions.back())
    refuse_key(scene, scene.kind == Kind::wall ? "wall" : "right_wall",
               body_name(scene, line.positions.size() - 1) + " at " + shown(line.positions.back()) +
                   " is beyond the wall at " + shown(*line.right_wall),
               "a wall to the right of all bodies");
}

}  // namespace

ExactLine exact_line(const Scene& scene) {
  ExactLine result;
  for (std::size_t i = 0; i < scene.masses.size(); ++i) {
    result.masses.push_back(worth(scene, mass_key(scene), scene.masses[i]));
    if (sign(result.masses.back()) <= 0)
      refuse_key(
          scene, mass_key(scene),
          "the mass of " + body_name(scene, i) + " is " + shown_text(to_text(scene.masses[i])),
          "a positive finite number");
  }
  Written written;
  written.add(scene, "V", scene.V);
  written.add(scene, "L", scene.L);
  written.add(scene, "gap", scene.gap);
  written.add(scene, "restitution", scene.restitution);
  for (const Value& value : scene.positions) written.add(scene, "positions", value);
  for (const Value& value : scene.velocities) written.add(scene, "velocities", value);
  for (const Value& value : scene.times) written.add(scene, "times", value);
  if (scene.left_wall) written.add(scene, "left_wall", *scene.left_wall);
  if (scene.right_wall)
    written.add(scene, scene.kind == Kind::wall ? "wall" : "right_wall", *scene.right_wall);
  if (scene.until) written.add(scene, "until", *scene.until);
  std::vector<ExactValue> values = written.values;
  values.insert(values.end(), result.masses.begin(), result.masses.end());
  CommonField field = common_field(values, most_exact_degree);
  const bool together = field.exists;
  if (!together) field = common_field(written.values, most_exact_degree);
  if (!field.exists) {
    for (std::size_t i = 0; i < written.keys.size(); ++i)
      if (!written.values[i].is_rational())
        refuse_key(scene, written.keys[i],
                   "places, speeds and times have irrational parts of different kinds",
                   "one square root, or cosines of a field of degree up to 12");
  }
  check_numbers(scene, field);
  place(scene, field, result.geometry);
  check_order(scene, result.geometry);
  for (const Value& time : scene.times) result.times.push_back(in_field(exact_value(time), field));
  if (scene.until) result.until = in_field(exact_value(*scene.until), field);
  result.field = field.field ? field.field->name() : "the rationals";
  if (together) {
    result.together = result.geometry;
    for (const ExactValue& mass : result.masses)
      result.together->masses.push_back(in_field(mass, field));
  }
  return result;
}

Line<double> rounded(const ExactLine& line) {
  const auto finite = [](double value) {
    if (!std::isfinite(value)) throw Undecided("a number of the scene does not fit a double");
    return value;
  };
  Line<double> doubles = converted<double>(
      line.geometry, [&](const FieldNumber& x) { return finite(nearest_double(x)); });
  for (const ExactValue& mass : line.masses) {
    doubles.masses.push_back(finite(nearest_double(mass)));
    if (!(doubles.masses.back() > 0.0))
      throw Undecided("a mass of the scene does not fit a double");
  }
  return doubles;
}

}  // namespace magicmass::reference
