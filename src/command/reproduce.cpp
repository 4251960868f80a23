// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "command/animate/animation.hpp"
#include "command/commands.hpp"
#include "command/destination.hpp"
#include "command/figure/drawing.hpp"
#include "command/program.hpp"
#include "command/report/progress.hpp"
#include "command/reproduce/pages.hpp"
#include "command/reproduce/sections.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

/// Name and content. All is made before anything is written, so that a figure that fails leaves no half of a folder.
using Files = std::vector<std::pair<std::string, std::string>>;

std::vector<ShownFigure> add_figures(Files& files) {
  std::vector<Figure> made;
  for (const FigureEntry& entry : figures()) made.push_back(entry.make());
  Progress progress;
  std::vector<ShownFigure> shown;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const std::string& name = figures()[i].name;
    const double share = static_cast<double>(i) / static_cast<double>(made.size());
    if (!progress.step("drawing " + name, share)) {
      progress.clear();
      Progress::end_as_interrupted();
    }
    files.emplace_back(name + ".csv", figure_csv(made[i]));
    for (const char* format : {"svg", "png", "pdf"})
      files.emplace_back(name + "." + format, drawn(made[i], format));
    shown.push_back({name, made[i].title, made[i].description});
  }
  return shown;
}

void write_all(const std::filesystem::path& folder, const Files& files) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw InvalidInput("cannot write " + shown_text(folder.string(), 200) + ": " +
                       (error ? error.message() : "it is no folder"));
  for (const auto& [name, content] : files) {
    Destination file((folder / name).string());
    file.write(content);
    file.finish();
  }
}

ExitCode reproduce(const std::string& folder) {
  const std::vector<ComparisonSection> sections = comparison_sections();
  Files files;
  const std::vector<ShownFigure> shown = add_figures(files);
  files.emplace_back(
      "cradle.html",
      animation_page("The generalised Newton's cradle, one round trip", cradle_motion()));
  files.emplace_back("comparison.csv", comparison_csv(sections));
  files.emplace_back("index.md", reproduction_markdown(sections, shown));
  files.emplace_back("index.html", reproduction_html(sections, shown));
  write_all(folder, files);
  const Tally sum = tally(sections);
  Destination output("");
  output.write(fmt::format("{}\n{}\n", tally_text(sum),
                           (std::filesystem::path(folder) / "index.html").string()));
  output.finish();
  return sum.unexplained == 0 ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

void add_reproduce(Program& program) {
  const auto folder = std::make_shared<std::string>("build/reproduction");
  CLI::App& command = add_command(
      program, "reproduce", "All figures, and each number of the paper beside ours, as a page",
      "magicmass reproduce --out build/reproduction");
  command.add_option("--out", *folder, "folder for index.html, index.md, figures and data")
      ->type_name("DIR");
  command.footer(
      "Exit code 1 where a number differs for no known reason. Needs gnuplot\n"
      "(Debian: gnuplot-nox).");
  on_run(program, command, [folder] { return reproduce(*folder); });
}

}  // namespace magicmass::command
