// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>

#include "command/commands.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "command/report/comparison.hpp"
#include "command/report/figures.hpp"
#include "command/report/measurement.hpp"
#include "command/report/own_function.hpp"
#include "command/report/report_tables.hpp"
#include "command/report/timing_batch.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct ReportOptions {
  ReportRequest request;
  std::optional<std::size_t> timing_batch;
  std::vector<std::string> compare;  ///< one file: with this run; two: with each other
  std::string figures;
  std::string headline;
  OutputOptions output;
};

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  if (!file || std::filesystem::is_directory(path, error))
    throw InvalidInput("cannot read " + shown_text(path, 200));
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file) throw InvalidInput("cannot read " + shown_text(path, 200));
  return text;
}

void write_whole(const std::string& path, const std::string& text) {
  Destination file(path);
  file.write(text);
  file.finish();
}

void write_report(Destination& output, const std::string& format, const Measurement& measurement) {
  if (format == "text")
    output.write(report_text(measurement));
  else if (format == "markdown")
    output.write(report_markdown(measurement));
  else
    write_report_records(output, format, measurement);
  output.finish();
}

ExitCode say_comparison(Destination& output, const KnownReport& old_report,
                        const KnownReport& new_report) {
  const Comparison comparison = compare_reports(old_report, new_report);
  output.write(comparison.text);
  output.finish();
  if (comparison.agrees) return ExitCode::done;
  std::cerr << "magicmass: the two reports do not agree\n";
  return ExitCode::check_failed;
}

ExitCode report_command(const ReportOptions& options) {
  if (options.timing_batch) {
    run_timing_batch(options.request, *options.timing_batch, std::cin, std::cout);
    return ExitCode::done;
  }
  if (!options.compare.empty() && options.output.format != "text" &&
      (options.compare.size() == 2 || is_stdout(options.output.path)))
    throw InvalidInput("--compare is told as text; --format is of the report that -o FILE writes");
  std::vector<KnownReport> known;
  for (const std::string& path : options.compare) known.push_back(read_report(path));
  if (known.size() == 2) {
    Destination output(options.output.path);
    return say_comparison(output, known[0], known[1]);
  }
  // What cannot be written is found out before the minutes of measuring.
  Destination output(options.output.path);
  if (!options.figures.empty()) prepare_folder(options.figures);
  if (!options.headline.empty()) with_headline(read_text(options.headline), "", options.headline);
  Measurement measurement;
  {
    Progress progress;
    measurement = measure(options.request, progress);
  }
  if (known.empty() || !is_stdout(options.output.path))
    write_report(output, options.output.format, measurement);
  if (options.output.format != "text" && options.output.format != "markdown")
    for (const std::string& remark : measurement.remarks)
      std::cerr << "magicmass: " + remark + "\n";
  if (!options.figures.empty())
    if (const std::string missing = draw_figures(measurement, options.figures); !missing.empty())
      std::cerr << "magicmass: " + missing + "\n";
  if (!measurement.is_complete) {
    std::cerr << "magicmass: interrupted; what was finished is there\n";
    Progress::end_as_interrupted();
  }
  if (!options.headline.empty())
    write_whole(options.headline, with_headline(read_text(options.headline),
                                                report_headline(measurement), options.headline));
  if (known.empty()) return ExitCode::done;
  Destination comparison("");
  return say_comparison(comparison, known[0], {"this run", report_records(measurement)});
}

CLI::Option* add_names(CLI::App& command, const std::string& option,
                       std::vector<std::string>& names, const std::string& words) {
  return command.add_option(option, names, words)->type_name("NAME,...")->delimiter(',');
}

/// A file that is given takes part, whatever else is asked for.
void name_own_function(ReportRequest& request) {
  if (request.function.empty()) return;
  const auto& asked = request.quantities;
  if (!asked.empty() && std::find(asked.begin(), asked.end(), "velocities") == asked.end())
    throw InvalidInput("--function computes velocities, and --quantities leaves them out");
  auto& names = request.evaluators;
  if (!names.empty() && std::find(names.begin(), names.end(), own_name) == names.end())
    names.emplace_back(own_name);
}

}  // namespace

void add_report(Program& program) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& command = add_command(program, "report", "Speed against error of every evaluator",
                                  "magicmass report --quick --figures build/report");
  ReportRequest& request = options->request;
  command.add_flag("--quick", request.quick, "in less than a minute, with fewer inputs");
  add_names(command, "--families", request.families, "these kinds of inputs alone");
  add_names(command, "--evaluators", request.evaluators, "these alone, and naive");
  add_names(command, "--quantities", request.quantities, "velocities, counts, ... alone");
  command
      .add_option_function<std::size_t>(
          "--size", [options](std::size_t size) { options->request.size = size; },
          "inputs a family, at most (2048; 96 if quick)")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 20U).description(""));
  command.add_option("--rounds", request.rounds, "of timing (51; 27 if quick)")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{6}, std::size_t{100000}).description(""));
  command.add_flag("--growth,!--no-growth", request.growth, "error and time as the work grows");
  command.add_flag("--peers", request.peers, "SymPy on NumPy too, where installed");
  command.add_option("--function", request.function, "your own velocities(alpha, n) in C++, too")
      ->type_name("FILE");
  command.add_option("--figures", options->figures, "draw SVG figures into DIR")->type_name("DIR");
  command.add_option("--headline", options->headline, "write the short table between FILE's marks")
      ->type_name("FILE");
  command
      .add_option("--compare", options->compare, "does this run, or FILE, agree with FILE (JSON)?")
      ->type_name("FILE [FILE]")
      ->expected(1, 2);
  command
      .add_option_function<std::size_t>(
          "--timing-batch", [options](std::size_t batch) { options->timing_batch = batch; },
          "what the program asks of its own copies")
      ->group("");
  add_output_options(command, options->output, {"text", "markdown", "json", "csv"});
  on_run(program, command, [options] {
    name_own_function(options->request);
    options->request.sweeps = !options->figures.empty();
    return report_command(*options);
  });
}

}  // namespace magicmass::command
