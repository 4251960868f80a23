// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/figure.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "answers/errors.hpp"
#include "answers/figures.hpp"
#include "host/child.hpp"
#include "host/embedded.hpp"
#include "report/report.hpp"

namespace command {
namespace {

using answers::Figure;

std::string script_of(const std::string& figure) {
  return host::embedded("figures/" + figure + ".gp");
}

/// What a script says of its figure in lines "# KEY ...": title, description, size.
std::string told(const std::string& script, const std::string& key) {
  const std::string begin = "# " + key + " ";
  std::istringstream lines(script);
  std::string text, line;
  while (std::getline(lines, line))
    if (line.starts_with(begin)) text += (text.empty() ? "" : " ") + line.substr(begin.size());
  return text;
}

std::string filled(const std::string& script, const std::string& data, const std::string& format) {
  int width = 600, height = 440;  // in the units of SVG
  std::istringstream(told(script, "size")) >> width >> height;
  const auto size = [&](double scale, const std::string& unit) {
    std::ostringstream text;
    text << " size " << scale * width << unit << "," << scale * height << unit << " ";
    return text.str();
  };
  const std::string terminal =
      format == "png"
          ? "pngcairo" + size(2, "") + "font 'sans,17' fontscale 1.5 linewidth 2 pointscale 2"
      : format == "pdf"
          ? "pdfcairo" + size(0.01, "in") + "font 'sans,12' fontscale 0.9 linewidth 1.5"
          : "svg" + size(1, "") + "font 'sans,17' background 'white'";
  return "set encoding utf8\nset terminal " + terminal +
         "\nset datafile separator ','\nset datafile columnheaders\n$data << END\n" + data +
         "END\n" + script;
}
/// What gnuplot prints for a script; script and picture are passed in memory.
std::string drawn(const std::string& script) {
  const auto said = host::said_by({"gnuplot", "-d", "-"}, script);
  if (!said) {
    throw answers::InvalidInput(
        "figure: drawing needs gnuplot (Debian: gnuplot-nox); allowed without it: --format csv");
  }
  if (said->code != 0) {
    throw std::runtime_error("figure: gnuplot could not draw: " +
                             answers::shown_text(said->errors, 200));
  }
  return said->output;
}
/// No date: two runs give the same bytes. Of the same length, since a PDF counts its bytes. Where
/// it is compressed (cairo of Debian 13) it stays.
std::string dateless(std::string pdf) {
  const std::size_t begin = pdf.find("/CreationDate (");
  const std::size_t end = pdf.find(')', begin);
  if (begin == std::string::npos || end == std::string::npos) return pdf;
  return pdf.replace(begin, end + 1 - begin, end + 1 - begin, ' ');
}
/// gnuplot's own title and description, which name its version, give way to the figure's.
std::string described(std::string svg, const std::string& script) {
  const std::string last = "</desc>";
  const std::size_t begin = svg.find("<title>");
  const std::size_t end = svg.find(last);
  const std::size_t root = svg.find("<svg");
  if (root > begin || begin > end || end == std::string::npos)
    throw std::runtime_error("figure: gnuplot wrote an SVG without a title and a description");
  svg.replace(begin, end + last.size() - begin,
              "<title id=\"title\">" + told(script, "title") + "</title>\n<desc id=\"desc\">" +
                  told(script, "description") + "</desc>");
  return svg.insert(root + 4, " role=\"img\" aria-labelledby=\"title desc\"");
}

/// The format that is asked for, or what the file's ending says.
std::string format_of(const answers::Request& request) {
  const std::string ending = std::filesystem::path(request.text("output")).extension();
  std::vector<std::string> allowed{"svg", "png", "pdf", "csv"};
  if (request.has("format")) allowed = {request.format};
  if (ending.empty()) return request.format;
  if (std::count(allowed.begin(), allowed.end(), ending.substr(1)) != 0) return ending.substr(1);
  throw answers::InvalidInput("figure: -o FILE ends in " + answers::shown_text(ending) +
                              "; allowed: ." + answers::joined(allowed, ", ."));
}

}  // namespace

std::string picture(const Figure& figure, const answers::Table& data, const std::string& format) {
  std::string rows = answers::written(data, answers::Format::csv);
  if (format == "csv") return rows;
  const std::string script = script_of(figure.name);
  const std::string drawing = drawn(filled(script, rows, format));
  return format == "svg"   ? described(drawing, script)
         : format == "pdf" ? dateless(drawing)
                           : drawing;
}

std::vector<Figure> all_figures() {
  std::vector<Figure> all = answers::figures();
  all.insert(all.end(), report::figures().begin(), report::figures().end());
  return all;
}

answers::Answer figure(const answers::Request& request) {
  const std::vector<Figure> all = all_figures();
  std::vector<std::string> names;
  answers::Table list{{"name", "title"}, {}};
  for (const Figure& f : all) {
    names.push_back(f.name);
    list.rows.push_back(
        {answers::text_cell(f.name), answers::text_cell(told(script_of(f.name), "title"))});
  }
  if (request.has("list") && request.words.empty()) return {list};
  if (request.words.size() != 1 || request.has("list"))
    throw answers::InvalidInput("figure: give one name, or --list; allowed: " +
                                answers::joined(names));
  const auto found = std::ranges::find(all, request.words[0], &Figure::name);
  if (found == all.end()) {
    throw answers::InvalidInput("figure: no figure " + answers::shown_text(request.words[0]) +
                                "; allowed: " + answers::joined(names));
  }
  const std::string format = format_of(request);  // refused before the data are computed
  return {{}, picture(*found, found->data(), format)};
}

}  // namespace command
