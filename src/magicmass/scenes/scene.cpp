#include "magicmass/scenes/scene.hpp"

#include <array>
#include <iterator>

namespace magicmass::scenes {

std::optional<std::size_t> Scene::receiver() const {
  const std::size_t last = masses.size() - 1;
  const auto rests = [](const Value& velocity) { return velocity.is(0); };
  if (std::ranges::count_if(velocities, rests) != std::ptrdiff_t(last)) return {};
  if (!rests(velocities[0])) return last;
  return rests(velocities[last]) ? std::nullopt : std::optional<std::size_t>(0);
}

Scene mirrored(const Scene& scene) { return simulator::mirrored(scene, negative); }

std::string body_name(const Scene& scene, std::size_t body) {
  if (scene.has("blocks")) return (body % 2 == 0 ? "A_" : "C_") + std::to_string(body / 2 + 1);
  if (scene.kind == Kind::chain) return std::to_string(body + 1);
  const std::size_t from_A = scene.kind == Kind::wall && scene.left_wall ? 1 - body : body;
  return from_A == 0 ? "A" : from_A == 1 ? "C" : "B";
}

std::string gap_name(const Scene& scene, std::size_t gap) {
  if (scene.kind == Kind::three_body) return gap == 1 ? "N_A" : "N_B";
  const std::string left = gap == 0 ? "wall" : body_name(scene, gap - 1);
  return left + "-" + (gap == scene.masses.size() ? "wall" : body_name(scene, gap));
}

bool has_exact_numbers(const Scene& scene) {
  std::vector<Value> all{scene.restitution};
  for (const auto* list : {&scene.masses, &scene.positions, &scene.velocities, &scene.times})
    all.insert(all.end(), list->begin(), list->end());
  for (const auto* one : {&scene.left_wall, &scene.right_wall, &scene.until})
    if (*one) all.push_back(**one);
  return std::ranges::all_of(all, [](const Value& value) { return value.exact() != nullptr; });
}

template <class Scalar>
simulator::Line<Scalar> line_of(const Scene& scene) {
  const auto rounds = [](const Value& value) {
    return std::same_as<Scalar, double> && !value.is(Surd(value.to_double()));
  };
  bool is_rounded = rounds(scene.restitution);
  const auto all = [&](const auto& values) {
    std::vector<Scalar> numbers;
    for (const Value& value : values) numbers.push_back(number_of<Scalar>(value));
    is_rounded = is_rounded || std::ranges::any_of(values, rounds);
    return numbers;
  };
  const auto wall = [&](const std::optional<Value>& place) {
    return place ? std::optional(all(std::array{*place})[0]) : std::nullopt;
  };
  simulator::Line<Scalar> line{all(scene.masses),      all(scene.positions),
                               all(scene.velocities),  wall(scene.left_wall),
                               wall(scene.right_wall), number_of<Scalar>(scene.restitution)};
  line.is_rounded = is_rounded;
  const auto differs = [&](const Value& v) {  // what is the same number stays so
    const auto d = difference(v, scene.velocities[0]);
    return !d || !d->is(0);
  };
  line.has_rounded_velocities = std::ranges::any_of(scene.velocities, rounds) &&
                                std::ranges::any_of(scene.velocities, differs);
  return line;
}
template simulator::Line<double> line_of(const Scene&);
template simulator::Line<Surd> line_of(const Scene&);

void refuse_key(const Scene& scene, const std::string& key, const std::string& what,
                std::string_view allowed) {
  const auto line = scene.lines.find(key);
  throw InvalidInput(scene.source + ":" +
                     std::to_string(line == scene.lines.end() ? 1 : line->second) + ": " + key +
                     ": " + what + "; allowed: " + std::string(allowed));
}

std::string meant(const std::string& name, const std::vector<std::string>& names,
                  const std::string& otherwise) {
  for (const std::string& other : names) {
    const auto [from, begin] = std::mismatch(name.begin(), name.end(), other.begin(), other.end());
    const auto [to, end] = std::mismatch(name.rbegin(), std::make_reverse_iterator(from),
                                         other.rbegin(), std::make_reverse_iterator(begin));
    const auto letters = std::max(to.base() - from, end.base() - begin);
    const bool are_few = letters <= 2 || to.base() == from;
    if (are_few && 2 * letters < std::ssize(other)) return "; is " + other + " meant?";
  }
  return otherwise;
}

}  // namespace magicmass::scenes
