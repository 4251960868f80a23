// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/figure.hpp"

#include <algorithm>

#include "answers/errors.hpp"
#include "answers/figures.hpp"
#include "answers/shown_text.hpp"
#include "command/embedded.hpp"
#include "command/gnuplot.hpp"
#include "report/report.hpp"

namespace command {
namespace {

using answers::Figure;

constexpr int width = 800;
constexpr int height = 560;

std::string script_of(const Figure& figure, const std::string& format) {
  const std::string size = std::to_string(width) + "," + std::to_string(height);
  const std::string large = std::to_string(2 * width) + "," + std::to_string(2 * height);
  const std::string terminal =
      format == "png" ? "pngcairo size " + large + " font 'sans,14' fontscale 1.6 linewidth 1.6"
                      : "svg size " + size + " font 'sans,14' background 'white'";
  return "set encoding utf8\nset terminal " + terminal +
         "\nset datafile separator ','\nset datafile columnheaders\n$data << END\n" +
         answers::written(figure.data(), answers::Format::csv) + "END\n" +
         embedded("figures/" + figure.name + ".gp");
}
/// gnuplot's own title and description, which name its version, give way to the figure's.
std::string described(std::string svg, const Figure& figure) {
  const std::string last = "</desc>";
  const std::size_t begin = svg.find("<title>");
  const std::size_t end = svg.find(last);
  const std::size_t root = svg.find("<svg");
  if (root > begin || begin > end || end == std::string::npos)
    throw std::runtime_error("figure: gnuplot wrote an SVG without a title and a description");
  svg.replace(begin, end + last.size() - begin,
              "<title id=\"title\">" + figure.title + "</title>\n<desc id=\"desc\">" +
                  figure.description + "</desc>");
  return svg.insert(root + 4, " role=\"img\" aria-labelledby=\"title desc\"");
}

}  // namespace

answers::Answer figure(const answers::Request& request) {
  std::vector<Figure> all = answers::figures();
  all.insert(all.end(), report::figures().begin(), report::figures().end());
  std::vector<std::string> names;
  std::string list;
  for (const Figure& f : all) {
    names.push_back(f.name);
    list += f.name + ": " + f.title + "\n";
  }
  if (request.has("list")) return {{}, list};
  if (request.words.size() != 1)
    throw answers::InvalidInput("figure: give one name; allowed: " + answers::joined(names));
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Figure& f) { return f.name == request.words[0]; });
  if (found == all.end()) {
    throw answers::InvalidInput("figure: no figure " + answers::shown_text(request.words[0]) +
                                "; allowed: " + answers::joined(names));
  }
  if (request.format == "csv") return {{}, answers::written(found->data(), answers::Format::csv)};
  const std::string picture = drawn(script_of(*found, request.format));
  return {{}, request.format == "svg" ? described(picture, *found) : picture};
}

}  // namespace command
