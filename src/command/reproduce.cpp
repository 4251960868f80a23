// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/reproduce.hpp"

#include "answers/velocities.hpp"
#include "command/comparison.hpp"
#include "command/figure.hpp"
#include "command/generate.hpp"
#include "host/embedded.hpp"

namespace command {
namespace {

using namespace answers;

/// The figures of the paper and of errors in four formats, and the tables.
generate::Texts files_of(const std::vector<Comparison>& all) {
  generate::Texts files{{"reproduce.md", page_of(all, "markdown").document},
                        {"reproduce.csv", written(page_of(all, "csv").table, Format::csv)},
                        {"ratios.csv", written(ratios({}).table, Format::csv)}};
  for (const Figure& figure : all_figures()) {
    if (figure.name == "speed") continue;  // it is measured
    const Table data = figure.data();
    for (const std::string format : {"svg", "png", "pdf", "csv"})
      files[figure.name + "." + format] = picture(figure, data, format);
  }
  return files;
}

}  // namespace

Answer reproduce(const Request& request) {
  const std::vector<Comparison> all = comparisons(host::embedded("paper_numbers.csv"));
  if (request.has("out"))
    write_folder("reproduce: --out", request.text("out"), [&] { return files_of(all); });
  return page_of(all, request.format);
}

}  // namespace command
