// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/scene.hpp"

#include <algorithm>

#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {
namespace {

/// The line in other numbers.
template <class Scalar, class Convert>
simulator::Line<Scalar> converted(const Scene& scene, const Convert& convert) {
  const auto all = [&](const std::vector<Value>& values) {
    std::vector<Scalar> numbers;
    for (const Value& value : values) numbers.push_back(convert(value));
    return numbers;
  };
  const auto wall = [&](const std::optional<Value>& place) {
    return place ? std::optional<Scalar>(convert(*place)) : std::nullopt;
  };
  return {all(scene.masses),     all(scene.positions),   all(scene.velocities),
          wall(scene.left_wall), wall(scene.right_wall), convert(scene.restitution)};
}

}  // namespace

bool Scene::wants(const std::string& output) const {
  return std::count(outputs.begin(), outputs.end(), output) != 0;
}

std::string body_name(const Scene& scene, std::size_t body) {
  if (scene.lines.count("blocks") != 0)
    return (body % 2 == 0 ? "A_" : "C_") + std::to_string(body / 2 + 1);
  if (scene.kind == Kind::chain) return std::to_string(body + 1);
  const std::size_t from_A = scene.kind == Kind::wall && scene.left_wall ? 1 - body : body;
  return from_A == 0 ? "A" : from_A == 1 ? "C" : "B";
}

std::string gap_name(const Scene& scene, std::size_t gap) {
  const std::size_t bodies = scene.masses.size();
  if (scene.kind == Kind::three_body) return gap == 1 ? "N_A" : "N_B";
  const std::string left = gap == 0 ? "wall" : body_name(scene, gap - 1);
  return left + "-" + (gap == bodies ? "wall" : body_name(scene, gap));
}

std::optional<simulator::Line<Quadratic>> exact_line(const Scene& scene) {
  bool is_exact = true;
  cln::cl_I radicand = 1;
  const auto exactly = [&](const Value& value) {
    const Quadratic number = value.exact() == nullptr ? Quadratic() : *value.exact();
    is_exact = is_exact && value.exact() != nullptr;
    is_exact =
        is_exact && (radicand == 1 || number.radicand() == 1 || radicand == number.radicand());
    if (number.radicand() != 1) radicand = number.radicand();
    return number;
  };
  const auto line = converted<Quadratic>(scene, exactly);
  if (scene.until) exactly(*scene.until);
  for (const Value& time : scene.times) exactly(time);
  return is_exact ? std::optional(line) : std::nullopt;
}

std::optional<simulator::Line<Quadratic>> exact_places(const Scene& scene) {
  Scene places = scene;
  places.masses.assign(scene.masses.size(), value_of(1));
  return exact_line(places);
}

simulator::Line<double> rounded_line(const Scene& scene) {
  bool is_rounded = false;
  const auto rounds = [](const Value& value) {
    return value.exact() == nullptr || !(Quadratic(value.to_double()) == *value.exact());
  };
  auto line = converted<double>(scene, [&](const Value& value) {
    is_rounded = is_rounded || rounds(value);
    return value.to_double();
  });
  line.is_rounded = is_rounded;
  line.has_rounded_velocities =
      std::any_of(scene.velocities.begin(), scene.velocities.end(), rounds);
  return line;
}

void refuse_key(const Scene& scene, const std::string& key, const std::string& what,
                std::string_view allowed) {
  const auto line = scene.lines.find(key);
  throw InvalidInput(scene.source + ":" +
                     std::to_string(line == scene.lines.end() ? 1 : line->second) + ": " + key +
                     ": " + what + "; allowed: " + std::string(allowed));
}

}  // namespace magicmass::scenes
