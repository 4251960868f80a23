// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "command/commands.hpp"
#include "command/destination.hpp"
#include "command/figure/drawing.hpp"
#include "command/nearest_name.hpp"
#include "command/program.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct FigureOptions {
  std::string name;
  bool list = false;
  OutputOptions output{.format = "", .path = ""};
};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const FigureEntry& entry : figures()) all.push_back(entry.name);
  return all;
}

ExitCode list(const FigureOptions& options) {
  if (!options.name.empty()) throw InvalidInput("a figure's name and --list exclude each other");
  Destination output(options.output.path);
  for (const FigureEntry& entry : figures())
    output.write(fmt::format("{:<14}{}\n", entry.name, entry.summary));
  output.finish();
  return ExitCode::done;
}

const FigureEntry& entry_called(const std::string& name) {
  if (name.empty())
    throw InvalidInput(fmt::format("which figure? allowed: {}", fmt::join(names(), ", ")));
  require_name("figure", name, names());
  return *std::find_if(figures().begin(), figures().end(),
                       [&](const FigureEntry& entry) { return entry.name == name; });
}

/// As --format says, else as the file's ending does; svg for any other.
std::string format_of(const FigureOptions& options) {
  if (!options.output.format.empty()) return options.output.format;
  const std::string ending = std::filesystem::path(options.output.path).extension().string();
  return ending == ".png" || ending == ".pdf" ? ending.substr(1) : "svg";
}

/// Where the numbers of a drawing go: fig.csv beside fig.svg; nowhere beside a pipe or a device.
std::optional<std::string> data_path(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (is_stdout(path) ||
      (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)))
    return std::nullopt;
  const std::string data = std::filesystem::path(path).replace_extension(".csv").string();
  if (data == path)
    throw InvalidInput("-o " + shown_text(path, 200) +
                       ": a drawing's numbers go there; allowed: another ending, or --format csv");
  return data;
}

void write_all(Destination& output, const std::string& text) {
  output.write(text);
  output.finish();
}

ExitCode make_figure(const FigureOptions& options) {
  if (options.list) return list(options);
  const FigureEntry& entry = entry_called(options.name);
  const std::string format = format_of(options);
  const bool is_drawing = format != "csv";
  if ((format == "png" || format == "pdf") && is_stdout(options.output.path) &&
      ::isatty(STDOUT_FILENO) == 1)
    throw InvalidInput("--format " + format + " is not for a terminal; allowed: -o FILE");
  const std::optional<std::string> beside =
      is_drawing ? data_path(options.output.path) : std::nullopt;
  Destination output(options.output.path);
  std::optional<Destination> data;
  if (beside) data.emplace(*beside);
  const Figure figure = entry.make();
  const std::string table = figure_csv(figure);
  const std::string file = is_drawing ? drawn(figure, format) : table;
  if (data) write_all(*data, table);
  write_all(output, file);
  return ExitCode::done;
}

}  // namespace

void add_figure(Program& program) {
  const auto options = std::make_shared<FigureOptions>();
  CLI::App& command =
      add_command(program, "figure", "A figure of the paper, drawn by gnuplot, or its numbers",
                  "magicmass figure terminal -o terminal.svg");
  offer(*command.add_option("NAME", options->name, "a name from --list")->type_name(""), names());
  command.add_flag("--list", options->list, "the names of all figures");
  add_output_options(command, options->output, {"svg", "png", "pdf", "csv"});
  command.footer(
      "Without --format what FILE ends in, svg, png or pdf, or else svg. The numbers\n"
      "of FILE.svg go beside it, into FILE.csv.\n"
      "Drawings need gnuplot (Debian: gnuplot-nox), --format csv does not.");
  on_run(program, command, [options] { return make_figure(*options); });
}

}  // namespace magicmass::command
