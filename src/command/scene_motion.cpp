// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/scene_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "command/line_run.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/exact_line.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

double number(const Cell& cell) { return std::strtod(cell.text.c_str(), nullptr); }

[[noreturn]] void refuse(const Scene& scene, const std::string& what) {
  throw InvalidInput(shown_text(scene.source, 200) + ": " + what);
}

/// The columns of line_event_columns: number, left, right, time, position, v_left, v_right.
class ContactReader {
public:
  explicit ContactReader(const std::vector<std::string>& names) : bodies_(names.size()) {
    for (std::size_t body = 0; body < names.size(); ++body) index_[names[body]] = body;
  }

  MotionContact read(const std::vector<Cell>& cells) const {
    const auto right = index_.find(cells[2].text);  // no body is called "wall"
    return {number(cells[3]), number(cells[4]), right == index_.end() ? bodies_ : right->second,
            number(cells[5]), number(cells[6])};
  }

private:
  std::size_t bodies_;
  std::map<std::string, std::size_t> index_;
};

void add_pieces(SceneMotion& motion, const MotionContact& contact) {
  const auto add = [&](std::size_t body, double velocity) {
    motion.pieces[body].push_back(
        {motion.contacts.size(), contact.time, contact.position, velocity});
  };
  if (contact.gap > 0) add(contact.gap - 1, contact.v_left);
  if (contact.gap < motion.pieces.size()) add(contact.gap, contact.v_right);
}

/// Of all bodies at the start.
double highest_speed(const Line<double>& start) {
  double speed = 0.0;
  for (const double v : start.velocities) speed = std::max(speed, std::abs(v));
  return speed;
}

/// From end to end: L in the paper's scene.
double length(const Line<double>& start) {
  return start.right_wall.value_or(start.positions.back()) -
         start.left_wall.value_or(start.positions.front());
}

/// Were the bodies in order and between the walls so long before the start?
bool could_have_come(const SceneMotion& motion, double lead) {
  double last = motion.left_wall.value_or(-std::numeric_limits<double>::infinity());
  for (std::size_t body = 0; body < motion.pieces.size(); ++body) {
    const double x = motion.position(body, 0, -lead);
    if (x < last) return false;
    last = x;
  }
  return last <= motion.right_wall.value_or(std::numeric_limits<double>::infinity());
}

/// The span of time: also some free motion before a contact at the start, and after the last one.
void set_times(const Scene& scene, const reference::ExactLine& line, const LineResult& result,
               double crossing, SceneMotion& motion) {
  const bool at_once = !motion.contacts.empty() && motion.contacts.front().time == 0.0;
  motion.begin = at_once && could_have_come(motion, crossing) ? -crossing : 0.0;
  motion.end = motion.contacts.empty() ? 0.0 : motion.contacts.back().time;
  if (!result.collapse.empty())
    motion.end = number(result.collapse.front());
  else if (line.until && (result.status == "complete" || result.why == "the scene's time is over"))
    motion.end = reference::nearest_double(*line.until);
  else if (result.status == "complete")
    motion.end += std::max(crossing, (motion.end - motion.begin) / 10);
  if (!std::isfinite(motion.begin) || !std::isfinite(motion.end))
    refuse(scene, "its times do not fit a double");
  if (!(motion.begin < motion.end))
    refuse(scene, "its motion spans no time that a double can hold");
}

void set_room(const Scene& scene, SceneMotion& motion) {
  const std::size_t last = motion.names.size() - 1;  // bodies are in order
  motion.left = motion.left_wall.value_or(motion.position(0, 0, motion.begin));
  motion.right = motion.right_wall.value_or(motion.position(last, 0, motion.begin));
  if (!(motion.left < motion.right)) refuse(scene, "all its bodies begin in one place");
  const double far_left = motion.position(0, motion.contacts.size(), motion.end);
  const double far_right = motion.position(last, motion.contacts.size(), motion.end);
  if (!std::isfinite(std::max(motion.right, far_right) - std::min(motion.left, far_left)))
    refuse(scene, "its places do not fit a double");
}

}  // namespace

double SceneMotion::position(std::size_t body, std::size_t after, double time) const {
  const auto past =
      std::partition_point(pieces[body].begin(), pieces[body].end(),
                           [&](const MotionPiece& piece) { return piece.contacts <= after; });
  const MotionPiece& piece = *std::prev(past);
  return piece.position + piece.velocity * (time - piece.time);
}

SceneMotion follow_scene(Scene scene, std::int64_t most_contacts) {
  scene.outputs = {Output::events};
  scene.every = 1;
  scene.times.clear();
  const reference::ExactLine line = reference::exact_line(scene);
  if (line.bodies() > most_bodies_shown)
    refuse(scene, fmt::format("has {} bodies; allowed in a picture: up to {}", line.bodies(),
                              most_bodies_shown));
  const Line<double> start = reference::rounded(line);
  const double speed = highest_speed(start);
  if (speed == 0.0) refuse(scene, "nothing moves in it");
  SceneMotion motion{};
  for (std::size_t body = 0; body < line.bodies(); ++body) {
    motion.names.push_back(body_name(scene, body));
    motion.pieces.push_back({{0, 0.0, start.positions[body], start.velocities[body]}});
  }
  motion.masses = start.masses;
  motion.left_wall = start.left_wall;
  motion.right_wall = start.right_wall;
  const ContactReader reader(motion.names);
  const auto take = [&](const std::vector<Cell>& cells) {
    motion.contacts.push_back(reader.read(cells));
    add_pieces(motion, motion.contacts.back());
  };
  reference::SceneOptions options;
  options.max_events = std::min(most_contacts, scene.max_events.value_or(most_contacts));
  const LineResult result = run_line(scene, line, options, {take, [](const auto&) {}});
  motion.status = result.status;
  motion.why = result.why;
  set_times(scene, line, result, length(start) / speed, motion);
  set_room(scene, motion);
  motion.crossing = (motion.right - motion.left) / speed;
  if (!std::isfinite(motion.crossing)) refuse(scene, "its times do not fit a double");
  return motion;
}

}  // namespace magicmass::command
