// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "command/animate/animation.hpp"
#include "command/animate/layout.hpp"
#include "command/records.hpp"
#include "render/formula_mathml.hpp"

namespace magicmass::command {
namespace {

constexpr std::size_t most_labels = 24;
constexpr double seconds_across = 8.0;

/// "C_12" as "C₁₂".
std::string label(const std::string& name) {
  const std::size_t bar = name.find('_');
  std::string text = name.substr(0, bar);
  if (bar == std::string::npos) return text;
  for (const char digit : name.substr(bar + 1))
    text += std::string("\xE2\x82") + static_cast<char>(0x80 + (digit - '0'));
  return text;
}

std::vector<std::string> labels(const SceneMotion& motion) {
  std::vector<std::string> all;
  for (const std::string& name : motion.names) all.push_back(label(name));
  return all;
}

std::string json_numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ",") + json_value(number_cell(value));
  return "[" + text + "]";
}

/// What the player reads. No '<' in it could end the element: names and labels are the program's own.
std::string motion_json(const SceneMotion& motion, const Layout& layout) {
  std::vector<double> x, v;
  for (const std::vector<MotionPiece>& pieces : motion.pieces) {
    x.push_back(pieces.front().position);
    v.push_back(pieces.front().velocity);
  }
  std::string contacts;
  for (const MotionContact& contact : motion.contacts)
    contacts += fmt::format("{}[{},{},{},{},{}]", contacts.empty() ? "" : ",\n", contact.time,
                            contact.position, contact.gap, contact.v_left, contact.v_right);
  return fmt::format(
      "{{\"names\":{},\"labels\":{},\"x\":{},\"v\":{},\"begin\":{},\"end\":{},\"left\":{},"
      "\"right\":{},\"room\":{},\"offsets\":{},\"pace\":{},\"cut\":{},\n\"contacts\":[{}]}}",
      json_array(motion.names), json_array(labels(motion)), json_numbers(x), json_numbers(v),
      motion.begin, motion.end, motion.left, motion.right, layout.room,
      json_numbers(layout.offsets), motion.crossing / seconds_across, motion.status == "limited",
      contacts);
}

std::string wall_svg(double x) {
  return fmt::format("<line class=\"wall\" x1=\"{0:.3f}\" x2=\"{0:.3f}\" y1=\"40\" y2=\"{1}\"/>\n",
                     x, Layout::floor);
}

std::string body_shape(const SceneMotion& motion, const Layout& layout, std::size_t body) {
  const double size = layout.sizes[body];
  const double largest = *std::max_element(layout.sizes.begin(), layout.sizes.end());
  const bool ball = layout.is_ball[body];
  std::string text = fmt::format("<g id=\"body-{}\">", body);
  text += ball ? fmt::format("<circle class=\"ball\" cy=\"{:.3f}\" r=\"{:.3f}\"/>",
                             Layout::floor - size / 2, size / 2)
               : fmt::format(
                     "<rect class=\"block\" x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" "
                     "height=\"{:.3f}\"/>",
                     -size / 2, Layout::floor - size, size, size);
  if (motion.names.size() <= most_labels)  // balls above, blocks below: no two labels meet
    text += fmt::format("<text y=\"{:.3f}\">{}</text>",
                        ball ? Layout::floor - largest - 14 : Layout::floor + 44,
                        label(motion.names[body]));
  return text + "</g>\n";
}

std::string stage(const SceneMotion& motion, const Layout& layout) {
  std::string text = fmt::format(
      "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2} bodies on a line{3}; the table "
      "below "
      "has their places and velocities\">\n"
      "<line class=\"floor\" x1=\"0\" x2=\"{0}\" y1=\"{4}\" y2=\"{4}\"/>\n",
      Layout::width, Layout::height, motion.names.size(),
      motion.left_wall && motion.right_wall   ? " between two walls"
      : motion.left_wall || motion.right_wall ? " beside a wall"
                                              : "",
      Layout::floor);
  if (layout.left_wall) text += wall_svg(*layout.left_wall);
  if (layout.right_wall) text += wall_svg(*layout.right_wall);
  for (std::size_t body = 0; body < motion.names.size(); ++body)
    text += body_shape(motion, layout, body);
  return text + "</svg>\n";
}

std::string table(const SceneMotion& motion) {
  std::string text =
      "<div class=\"scroll\" role=\"region\" aria-label=\"Bodies\" "
      "tabindex=\"0\"><table>\n<thead><tr>"
      "<th scope=\"col\">body</th><th scope=\"col\">mass</th><th scope=\"col\">position</th>"
      "<th scope=\"col\">velocity</th></tr></thead>\n<tbody>\n";
  for (std::size_t body = 0; body < motion.names.size(); ++body)
    text += fmt::format(
        "<tr id=\"row-{}\"><th "
        "scope=\"row\">{}</th><td>{:.6g}</td><td>{:.5g}</td><td>{:.5g}</td></tr>\n",
        body, label(motion.names[body]), motion.masses[body], motion.pieces[body].front().position,
        motion.pieces[body].front().velocity);
  return text + "</tbody></table></div>\n";
}

std::string remark(const SceneMotion& motion) {
  if (motion.status == "collapse")
    return fmt::format(
        "The collisions never end: infinitely many of them by t = {:.6g}, where this ends after "
        "{}.",
        motion.end, motion.contacts.size());
  if (motion.status == "limited")
    return fmt::format("Shown are the first {} collisions: {}.", motion.contacts.size(),
                       motion.why);
  return fmt::format("{} collisions in all.", motion.contacts.size());
}

constexpr const char* controls = R"html(<p id="now"></p>
<p id="said" class="unseen" role="status"></p>
<div class="controls" role="group" aria-label="Playback">
<button type="button" id="first">To start</button>
<button type="button" id="back">Step back</button>
<button type="button" id="play">Play</button>
<button type="button" id="forward">Step forward</button>
<button type="button" id="last">To end</button>
<label>Speed <select id="speed"><option value="0.1">1/10</option><option value="0.25">1/4</option>
<option value="0.5">1/2</option><option value="1" selected>1</option><option value="2">2</option>
<option value="5">5</option></select></label>
<label class="time">Time <input type="range" id="time" min="0" max="1" step="any" value="0"></label>
</div>
<p class="quiet">Keys: <kbd>Space</kbd> plays and pauses, <kbd>←</kbd> and <kbd>→</kbd> step to the collision before and
after, <kbd>Home</kbd> and <kbd>End</kbd> go to the start and the end.
<span id="calm" hidden>As your system asks for less motion, playing goes from collision to collision.</span></p>
<noscript><p>Without JavaScript nothing moves here; the table shows where the bodies start.</p></noscript>
)html";

}  // namespace

std::string animation_page(const std::string& title, const SceneMotion& motion) {
  const Layout layout = layout_of(motion);
  const std::string heading = render::html_escaped(title);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; script-src 'unsafe-inline'\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n"
      "<p class=\"quiet\">{2}</p>\n{3}{4}{5}</main>\n"
      "<script type=\"application/json\" id=\"motion\">{6}</script>\n<script>{7}</script>\n"
      "</body>\n</html>\n",
      heading, animation_style, remark(motion), stage(motion, layout), controls, table(motion),
      motion_json(motion, layout), animation_player);
}

}  // namespace magicmass::command
