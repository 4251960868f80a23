// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/reproduce.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <stdexcept>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "answers/velocities.hpp"
#include "command/comparison.hpp"
#include "command/figure.hpp"
#include "generate/tree.hpp"
#include "host/embedded.hpp"
#include "report/report.hpp"

namespace command {
namespace {

using namespace answers;

/// The figures of the paper and of errors in four formats, and the tables.
std::map<std::string, std::string> files_of(const std::vector<Comparison>& all) {
  std::map<std::string, std::string> files{
      {"reproduce.md", page_of(all, "markdown").document},
      {"reproduce.csv", written(page_of(all, "csv").table, Format::csv)},
      {"ratios.csv", written(ratios({}).table, Format::csv)}};
  std::vector<Figure> wanted = figures();
  std::copy_if(report::figures().begin(), report::figures().end(), std::back_inserter(wanted),
               [](const Figure& figure) { return figure.name != "speed"; });  // it is measured
  for (const Figure& figure : wanted) {
    const Table data = figure.data();
    for (const std::string format : {"svg", "png", "pdf", "csv"})
      files[figure.name + "." + format] = picture(figure, data, format);
  }
  return files;
}

/// All files or none; a folder that was not there either.
void write(const std::string& folder, const std::vector<Comparison>& all) {
  const auto refuse = [&](const std::string& why) {
    throw InvalidInput("reproduce: --out " + shown_text(folder) + ": " + why +
                       "; allowed: a folder to write to");
  };
  std::error_code error;
  const bool is_new = std::filesystem::create_directories(folder, error);
  if (error) refuse(error.message());
  try {
    const std::map<std::string, std::string> files = files_of(all);
    try {
      generate::write(folder, files);
    } catch (const std::runtime_error& problem) {
      refuse(problem.what());
    }
  } catch (...) {
    if (is_new) std::filesystem::remove(folder, error);
    throw;
  }
}

}  // namespace

Answer reproduce(const Request& request) {
  const std::vector<Comparison> all = comparisons(host::embedded("paper_numbers.csv"));
  if (request.has("out")) write(request.text("out"), all);
  return page_of(all, request.format);
}

}  // namespace command
