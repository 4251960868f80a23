// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/line_output.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "command/line_pages.hpp"
#include "command/short_table.hpp"

namespace magicmass::command {
namespace {

std::string heading(const std::vector<std::string>& columns) {
  return fmt::format("{}\n", fmt::join(columns, ","));
}

/// The destination appears with the first row, so that a scene that is refused leaves nothing.
class Writer {
public:
  explicit Writer(const OutputOptions& options) : options_(options) {}

  void write(const std::string& text) {
    if (!output_) output_.emplace(options_.path);
    output_->write(text);
  }
  void finish() {
    if (output_) output_->finish();
  }

private:
  const OutputOptions& options_;
  std::optional<Destination> output_;
};

void as_csv(const Scene& scene, const reference::ExactLine& line,
            const reference::SceneOptions& options, Writer& writer) {
  const bool events = wants(scene, Output::events), points = wants(scene, Output::trajectory);
  bool headed = false;
  const auto rows = [&](const std::vector<std::string>& columns) {
    return [&](const std::vector<Cell>& cells) {
      if (!headed) writer.write(heading(columns));
      headed = true;
      writer.write(csv_line(cells));
    };
  };
  const auto nothing = [](const std::vector<Cell>&) {};
  LineListener listener{nothing, nothing};
  if (events)
    listener.on_event = rows(line_event_columns);
  else if (points)
    listener.on_point = rows(line_point_columns);
  const LineResult result = run_line(scene, line, options, listener);
  if (!events && !points)
    writer.write(line_csv(result));
  else if (!headed)
    writer.write(heading(events ? line_event_columns : line_point_columns));
}

void as_json_lines(const Scene& scene, const reference::ExactLine& line,
                   const reference::SceneOptions& options, Writer& writer) {
  const auto rows = [&](const char* name, const std::vector<std::string>& columns) {
    return [&, name](const std::vector<Cell>& cells) {
      writer.write(fmt::format("{{\"{}\": {}}}\n", name, json_object(columns, cells)));
    };
  };
  const LineResult result = run_line(
      scene, line, options, {rows("event", line_event_columns), rows("point", line_point_columns)});
  writer.write("{\"result\": " + line_json(scene, result) + "}}\n");
}

/// The same run, but of no more events than have room.
reference::SceneOptions with_room(const Scene& scene, reference::SceneOptions options) {
  if (!wants(scene, Output::events) && !wants(scene, Output::trajectory)) return options;
  const std::int64_t every = std::min(scene.every, std::int64_t{1} << 30U);
  options.max_events = std::min(reference::event_limit(scene, options), most_kept * every);
  return options;
}

void whole(const Scene& scene, const reference::ExactLine& line,
           const reference::SceneOptions& asked, bool json, Writer& writer) {
  const bool limits = scene.max_events || asked.max_events;
  const reference::SceneOptions options = limits ? with_room(scene, asked) : asked;
  std::string events, points;
  const auto keep = [json](std::string& text, const std::vector<std::string>& columns) {
    return [&text, &columns, json](const std::vector<Cell>& cells) {
      if (json) {
        text += (text.empty() ? "\n  " : ",\n  ") + json_object(columns, cells);
        return;
      }
      if (text.empty()) text = "\n" + short_head(columns);
      text += short_row(columns, cells);
    };
  };
  LineResult result = run_line(
      scene, line, options, {keep(events, line_event_columns), keep(points, line_point_columns)});
  if (result.status == "limited" &&
      reference::event_limit(scene, options) < reference::event_limit(scene, asked))
    result.why += "; more rows fit --format csv and jsonl";
  if (!json) {
    writer.write(line_text(scene, result) + events + points);
    return;
  }
  std::string text = line_json(scene, result) + ", \"events\": [" + events + "]";
  if (wants(scene, Output::trajectory)) text += ", \"trajectory\": [" + points + "]";
  writer.write(text + "}\n");
}

}  // namespace

void write_line_run(const Scene& scene, const reference::ExactLine& line,
                    const reference::SceneOptions& options, const OutputOptions& output) {
  Writer writer(output);
  if (output.format == "csv")
    as_csv(scene, line, options, writer);
  else if (output.format == "jsonl")
    as_json_lines(scene, line, options, writer);
  else
    whole(scene, line, options, output.format == "json", writer);
  writer.finish();
}

}  // namespace magicmass::command
