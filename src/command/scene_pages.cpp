// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/scene_pages.hpp"

#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/short_table.hpp"
#include "magicmass/reference/rational.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

const std::vector<std::string> count_columns = {"N_A", "N_B"};
const std::vector<std::string> terminal_columns = {"a_t", "b_t", "c_t", "rho"};
const std::vector<std::string> drift_columns = {"energy_drift", "momentum_drift"};

std::vector<Cell> cells(const reference::LargeCounts& counts) {
  return {digits_cell(reference::to_text(counts.N_A)), digits_cell(reference::to_text(counts.N_B))};
}

std::string json_rows(const std::vector<std::string>& columns,
                      const std::vector<std::vector<Cell>>& rows) {
  std::string text;
  for (const std::vector<Cell>& row : rows)
    text += (text.empty() ? "\n    " : ",\n    ") + json_object(columns, row);
  return text.empty() ? "[]" : "[" + text + "\n  ]";
}

std::string json_or_null(const std::vector<std::string>& columns, const std::vector<Cell>& row) {
  return row.empty() ? "null" : json_object(columns, row);
}

std::string scene_json(const Scene& scene, const SceneResult& result) {
  const reference::Plan& plan = result.plan;
  const std::vector<Cell> plan_cells = {text_cell(plan.model), text_cell(plan.reason),
                                        digits_cell(reference::to_text(plan.events))};
  std::string text = fmt::format(
      "{{\n  \"title\": {},\n  \"alpha\": {},\n  \"computed_alpha\": {},\n  \"status\": \"{}\",\n  "
      "\"plan\": {},\n"
      "  \"counts\": {},\n  \"stepped\": {},\n  \"terminal\": {},\n  \"events\": {}",
      json_string(scene.title), json_value(alpha_cell(*scene.alpha)),
      json_value(result.computed_alpha), result.status,
      json_object({"model", "reason", "events"}, plan_cells),
      json_object(count_columns, cells(result.counts)),
      result.stepped ? json_object(count_columns, cells(*result.stepped)) : "null",
      json_or_null(terminal_columns, result.terminal), json_rows(event_columns, result.events));
  if (wants(scene, Output::trajectory))
    text += ",\n  \"trajectory\": " + json_rows(trajectory_columns, result.trajectory);
  if (wants(scene, Output::energy))
    text += ",\n  \"energy\": " + json_object(drift_columns, result.drift);
  return text + "\n}\n";
}

std::string csv_rows(const std::vector<std::string>& columns,
                     const std::vector<std::vector<Cell>>& rows) {
  std::string text = fmt::format("{}\n", fmt::join(columns, ","));
  for (const std::vector<Cell>& row : rows) text += csv_line(row);
  return text;
}

std::string scene_csv(const Scene& scene, const SceneResult& result) {
  if (wants(scene, Output::events)) return csv_rows(event_columns, result.events);
  if (wants(scene, Output::trajectory)) return csv_rows(trajectory_columns, result.trajectory);
  std::vector<Cell> row = cells(result.counts);
  row.insert(row.end(), result.terminal.begin(), result.terminal.end());
  std::vector<std::string> columns = count_columns;
  columns.insert(columns.end(), terminal_columns.begin(), terminal_columns.end());
  return csv_rows(columns, {row});
}

std::string table(const std::vector<std::string>& columns,
                  const std::vector<std::vector<Cell>>& rows) {
  std::string text = short_head(columns);
  for (const std::vector<Cell>& row : rows) text += short_row(columns, row);
  return text;
}

std::string scene_text(const Scene& scene, const SceneResult& result) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  const std::string as_written = to_text(*scene.alpha);
  text += render::wrapped(
      as_written == result.computed_alpha.text
          ? as_written
          : fmt::format("{}, computed with {}", as_written, result.computed_alpha.text),
      "alpha     ");
  text += render::wrapped(fmt::format("{}: {} ({} events)", result.plan.model, result.plan.reason,
                                      reference::to_text(result.plan.events)),
                          "plan      ");
  text += "status    " + result.status + "\n";
  text += fmt::format("counts    N_A = {}, N_B = {}\n", reference::to_text(result.counts.N_A),
                      reference::to_text(result.counts.N_B));
  if (result.stepped)
    text += fmt::format("stepped   N_A = {}, N_B = {}\n", reference::to_text(result.stepped->N_A),
                        reference::to_text(result.stepped->N_B));
  if (result.terminal.empty()) text += "terminal  not reached within --max-events\n";
  for (std::size_t i = 0; i < result.terminal.size(); ++i)
    text += fmt::format("{:<10}{}\n", terminal_columns[i], result.terminal[i].text);
  if (wants(scene, Output::energy))
    for (std::size_t i = 0; i < result.drift.size(); ++i)
      text += fmt::format("{:<16}{}\n", drift_columns[i], result.drift[i].text);
  if (wants(scene, Output::events)) text += "\n" + table(event_columns, result.events);
  if (wants(scene, Output::trajectory)) text += "\n" + table(trajectory_columns, result.trajectory);
  return text;
}

}  // namespace

std::string scene_page(const Scene& scene, const SceneResult& result, const std::string& format) {
  if (format == "json") return scene_json(scene, result);
  if (format == "csv") return scene_csv(scene, result);
  return scene_text(scene, result);
}

}  // namespace magicmass::command
