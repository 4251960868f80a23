// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/line_pages.hpp"

#include <fmt/format.h>

#include "magicmass/reference/rational.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

std::string json_or_null(const std::vector<std::string>& names, const std::vector<Cell>& cells) {
  return cells.empty() ? "null" : json_object(names, cells);
}

std::vector<std::string> names_of(const Scene& scene, std::size_t bodies) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < bodies; ++i) names.push_back(body_name(scene, i));
  return names;
}

const std::vector<std::string> collapse_names = {"time", "position"};
const std::vector<std::string> drift_names = {"energy_drift", "momentum_drift"};
const std::vector<std::string> cradle_names = {"transfers", "round_trips", "mover"};

}  // namespace

std::string plan_json(const reference::Plan& plan) {
  return json_object({"model", "reason", "events"}, {text_cell(plan.model), text_cell(plan.reason),
                                                     digits_cell(reference::to_text(plan.events))});
}

std::string line_json(const Scene& scene, const LineResult& result) {
  const std::string velocities =
      json_or_null(names_of(scene, result.velocities.size()), result.velocities);
  const bool ended = result.status == "complete";
  std::string text = fmt::format(
      "{{\"title\": {}, \"kind\": \"{}\", \"status\": \"{}\", \"why\": {}, \"plan\": {}, "
      "\"contacts\": {}, \"counts\": {}, \"stepped\": {}, \"evaluated\": {}, \"near_ties\": {}, "
      "\"simultaneous\": {}, \"terminal\": {}, \"velocities\": {}, \"collapse\": {}",
      json_string(scene.title), to_text(scene.kind), result.status, json_string(result.why),
      plan_json(result.plan), json_value(result.contacts),
      json_or_null({"N_A", "N_B"}, result.counts), result.stepped, result.evaluated,
      result.near_ties, result.simultaneous, ended ? velocities : "null", velocities,
      json_or_null(collapse_names, result.collapse));
  if (!result.cradle.empty()) text += ", \"cradle\": " + json_object(cradle_names, result.cradle);
  if (wants(scene, Output::energy))
    text += ", \"energy\": " + json_or_null(drift_names, result.drift);
  return text;
}

std::string line_csv(const LineResult& result) {
  return "status,contacts\n" + csv_line({text_cell(result.status), result.contacts});
}

std::string line_text(const Scene& scene, const LineResult& result) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  text += render::wrapped(fmt::format("{}: {} ({} events)", result.plan.model, result.plan.reason,
                                      reference::to_text(result.plan.events)),
                          "plan      ");
  text +=
      fmt::format("status    {}{}\n", result.status, result.why.empty() ? "" : ": " + result.why);
  if (!result.collapse.empty())
    text += fmt::format("collapse  at t = {}{}\n", result.collapse[0].text,
                        result.collapse[1].text.empty() ? "" : ", x = " + result.collapse[1].text);
  if (!result.contacts.text.empty()) text += fmt::format("contacts  {}\n", result.contacts.text);
  if (!result.counts.empty())
    text +=
        fmt::format("counts    N_A = {}, N_B = {}\n", result.counts[0].text, result.counts[1].text);
  if (!result.cradle.empty())
    text += fmt::format("cradle    {} transfers, {} round trips, {} moves\n", result.cradle[0].text,
                        result.cradle[1].text, result.cradle[2].text);
  if (result.near_ties > 0)
    text += fmt::format("near tie  {} decisions closer than doubles can tell\n", result.near_ties);
  if (result.simultaneous > 0)
    text += fmt::format("tie       {} contacts at once, leftmost first\n", result.simultaneous);
  for (std::size_t i = 0; i < result.velocities.size(); ++i)
    text += fmt::format("v_{:<8}{}\n", body_name(scene, i), result.velocities[i].text);
  for (std::size_t i = 0; i < result.drift.size(); ++i)
    text += fmt::format("{:<16}{}\n", drift_names[i], result.drift[i].text);
  return text;
}

}  // namespace magicmass::command
