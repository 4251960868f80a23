// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/figures.hpp"

#include <cctype>
#include <system_error>

#include "command/destination.hpp"
#include "command/gnuplot.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {

std::string file_name(const std::string& words) {
  std::string name;
  for (const char character : words)
    if (std::isalnum(static_cast<unsigned char>(character)) != 0)
      name += character;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  while (name.ends_with('_')) name.pop_back();
  return name;
}

void prepare_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InvalidInput("cannot write " + shown_text(folder.string(), 200) + ": " + error.message());
  Destination((folder / "figures.gp").string()).finish();
}

std::string draw_figures(const Measurement& measurement, const std::filesystem::path& folder) {
  std::string script = "set encoding utf8\n";
  for (const MeasuredFamily& one : measurement.families)
    script += pareto_figure(
        one, "pareto_" + file_name(one.family.quantity + " " + one.family.name) + ".svg");
  script += alpha_figure(measurement.sweeps, "error_against_alpha.svg");
  script += growth_figure(measurement.growths, "growth.svg");
  Destination file((folder / "figures.gp").string());
  file.write(script);
  file.finish();
  switch (run_gnuplot(std::filesystem::absolute(folder), "figures.gp")) {
    case Drawing::no_gnuplot:
      return "figures skipped: needs gnuplot (Debian: gnuplot-nox); figures.gp has their data";
    case Drawing::failed:
      return "gnuplot could not draw; see gnuplot.log in " + shown_text(folder.string(), 200);
    case Drawing::done:
      break;
  }
  return "";
}

}  // namespace magicmass::command
