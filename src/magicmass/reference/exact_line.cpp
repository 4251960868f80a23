// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/exact_line.hpp"

#include <cmath>
#include <type_traits>

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
  std::vector<std::string_view> keys = {};
  std::vector<ExactValue> values = {};

  /// Rational ones leave every field as it is.
  void add(const Scene& scene, std::string_view key, const Value& value) {
    ExactValue exact = worth(scene, key, value);
    if (exact.is_rational()) return;
    keys.push_back(key);
    values.push_back(std::move(exact));
  }
};

/// Takes places and velocities where they are told, and keeps the rule by which they are laid out else.
void place(const Scene& scene, ExactLine& line) {
  const auto number = [&](const Value& value) { return in_field(exact_value(value), line.common); };
  line.V = number(scene.V);
  line.L = number(scene.L);
  line.gap = number(scene.gap);
  line.restitution = number(scene.restitution);
  line.placed.reserve(scene.positions.size());
  line.launched.reserve(scene.velocities.size());
  for (const Value& value : scene.positions) line.placed.push_back(number(value));
  for (const Value& value : scene.velocities) line.launched.push_back(number(value));
  if (scene.has_left_wall)
    line.left_wall = scene.left_wall ? number(*scene.left_wall) : line.position(0) - line.gap;
  if (scene.has_right_wall)
    line.right_wall = scene.right_wall ? number(*scene.right_wall) : line.position(line.bodies());
  for (const Value& time : scene.times) line.times.push_back(number(time));
  if (scene.until) line.until = number(*scene.until);
}

/// Throws where a mass is not positive. Of two bodies, one after the other, the same value is worked out once.
void weigh(const Scene& scene, ExactLine& line) {
  line.masses.reserve(scene.masses.size());
  for (std::size_t i = 0; i < scene.masses.size(); ++i) {
    if (i > 1 && scene.masses[i] == scene.masses[i - 2]) {
      line.masses.push_back(line.masses[i - 2]);
      continue;
    }
    line.masses.push_back(worth(scene, mass_key(scene), scene.masses[i]));
    if (sign(line.masses.back()) <= 0)
      refuse_key(
          scene, mass_key(scene),
          "the mass of " + body_name(scene, i) + " is " + shown_text(to_text(scene.masses[i])),
          "a positive finite number");
  }
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

void check_order(const Scene& scene, const ExactLine& line) {
  const auto shown = [](const FieldNumber& x) { return shown_text(to_text(x)); };
  for (std::size_t i = 1; i < line.placed.size(); ++i)
    if (line.placed[i] < line.placed[i - 1])
      refuse_key(scene, "positions",
                 body_name(scene, i - 1) + " at " + shown(line.placed[i - 1]) +
                     " is to the right of " + body_name(scene, i) + " at " + shown(line.placed[i]),
                 "bodies from left to right, which may touch");
  if (line.left_wall && line.position(0) < *line.left_wall)
    refuse_key(scene, "left_wall",
               body_name(scene, 0) + " at " + shown(line.position(0)) + " is beyond the wall at " +
                   shown(*line.left_wall),
               "a wall to the left of all bodies");
  if (line.right_wall && *line.right_wall < line.position(line.bodies() - 1))
    refuse_key(scene, scene.kind == Kind::wall ? "wall" : "right_wall",
               body_name(scene, line.bodies() - 1) + " at " +
                   shown(line.position(line.bodies() - 1)) + " is beyond the wall at " +
                   shown(*line.right_wall),
               "a wall to the right of all bodies");
}

}  // namespace

FieldNumber ExactLine::position(std::size_t body) const {
  if (!placed.empty()) return placed[body];
  const auto many = [](std::size_t count) {
    return FieldNumber(cln::cl_RA(static_cast<unsigned long>(count)));
  };
  return many((body + 1) / 2) * gap + many(body / 2) * L;
}

FieldNumber ExactLine::velocity(std::size_t body) const {
  if (!launched.empty()) return launched[body];
  return body == 0 ? V : FieldNumber(0);
}

Line<FieldNumber> ExactLine::geometry() const {
  Line<FieldNumber> line{{}, {}, {}, left_wall, right_wall, restitution};
  for (std::size_t i = 0; i < bodies(); ++i) {
    line.positions.push_back(position(i));
    line.velocities.push_back(velocity(i));
  }
  return line;
}

Line<FieldNumber> ExactLine::together() const {
  Line<FieldNumber> line = geometry();
  for (const ExactValue& mass : masses) line.masses.push_back(in_field(mass, common));
  return line;
}

ExactLine exact_line(const Scene& scene) {
  ExactLine result;
  weigh(scene, result);
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
  for (std::size_t i = 0; i < result.masses.size(); ++i)
    if (!result.masses[i].is_rational() && !(i > 1 && scene.masses[i] == scene.masses[i - 2]))
      values.push_back(result.masses[i]);
  result.common = common_field(values, most_exact_degree);
  result.one_field = result.common.exists;
  if (!result.one_field) result.common = common_field(written.values, most_exact_degree);
  if (!result.common.exists)
    refuse_key(scene, written.keys.front(),
               "places, speeds and times have irrational parts of different kinds",
               "one square root, or cosines of a field of degree up to 12");
  check_numbers(scene, result.common);
  place(scene, result);
  check_order(scene, result);
  result.field = result.common.field ? result.common.field->name() : "the rationals";
  return result;
}

template <class Float>
Line<Float> rounded(const ExactLine& line) {
  const auto refuse = [](const std::string& what, const std::string& does) {
    throw Undecided(what + " of the scene " + does + " for " +
                    (std::is_same_v<Float, double> ? "doubles" : "long doubles") +
                    "; allowed: simulate --exact");
  };
  const auto finite = [&](Float value, const std::string& what) {
    if (!std::isfinite(value)) refuse(what, "is too large");
    return value;
  };
  Line<Float> floats;
  const auto number = [&](const FieldNumber& x, const std::string& what) {
    const Float value = finite(nearest<Float>(x), what);
    const bool is_exact = FieldNumber(exact(value)) == x;
    if (!is_exact && !std::isnormal(value)) refuse(what, "is too small");
    floats.is_rounded = floats.is_rounded || !is_exact;
    return value;
  };
  for (auto* column : {&floats.masses, &floats.positions, &floats.velocities})
    column->reserve(line.bodies());
  if (line.left_wall) floats.left_wall = number(*line.left_wall, "the place of a wall");
  if (line.right_wall) floats.right_wall = number(*line.right_wall, "the place of a wall");
  floats.restitution = number(line.restitution, "the restitution");
  for (std::size_t i = 0; i < line.bodies(); ++i) {
    floats.masses.push_back(finite(nearest<Float>(line.masses[i]), "a mass"));
    if (!(floats.masses.back() > 0)) refuse("a mass", "is too small");
    if (!floats.is_rounded)
      floats.is_rounded =
          !line.masses[i].is_rational() || line.masses[i].rational != exact(floats.masses.back());
    floats.positions.push_back(number(line.position(i), "a place"));
    floats.velocities.push_back(number(line.velocity(i), "a velocity"));
  }
  return floats;
}
template Line<double> rounded(const ExactLine&);
template Line<long double> rounded(const ExactLine&);

}  // namespace magicmass::reference
