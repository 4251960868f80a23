// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/figure/drawing.hpp"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "command/destination.hpp"
#include "command/gnuplot.hpp"
#include "command/scratch_folder.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"
#include "render/formula_mathml.hpp"

namespace magicmass::command {
namespace {

void write(const std::string& path, const std::string& text) {
  Destination file(path);
  file.write(text);
  file.finish();
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string terminal_command(const Figure& figure, const std::string& format) {
  if (format == "png")
    return fmt::format(
        "set terminal pngcairo size {},{} font 'sans,14' fontscale 1.6 linewidth 1.6 pointscale "
        "1.6\n",
        2 * figure.width, 2 * figure.height);
  if (format == "pdf")  // 96 SVG pixels make an inch, and one is 0.75 points
    return fmt::format(
        "set terminal pdfcairo size {:.3f}in,{:.3f}in font 'sans,14' fontscale 0.75 linewidth 1.5 "
        "pointscale 0.75\n",
        figure.width / 96.0, figure.height / 96.0);
  return fmt::format("set terminal svg size {},{} font 'sans,14' background 'white'\n",
                     figure.width, figure.height);
}

/// gnuplot's own title and description, which name its version, give way to the figure's.
std::string described(std::string svg, const Figure& figure) {
  const std::string last = "</desc>";
  const std::size_t begin = svg.find("<title>");
  const std::size_t end = svg.find(last);
  const std::size_t root = svg.find("<svg");
  if (root > begin || begin > end || end == std::string::npos)
    throw Undecided("gnuplot wrote an SVG without a title and a description");
  svg.replace(begin, end + last.size() - begin,
              "<title id=\"title\">" + render::html_escaped(figure.title) +
                  "</title>\n<desc id=\"desc\">" + render::html_escaped(figure.description) +
                  "</desc>");
  return svg.insert(root + 4, " role=\"img\" aria-labelledby=\"title desc\"");
}

/// Blanks, which mean nothing there, in place of the time of drawing.
std::string dateless(std::string pdf) {
  const std::size_t begin = pdf.find("/CreationDate (");
  const std::size_t end = pdf.find(')', begin);
  if (begin == std::string::npos || end == std::string::npos) return pdf;
  return pdf.replace(begin, end + 1 - begin, end + 1 - begin, ' ');
}

}  // namespace

std::string gnuplot_file(const std::string& data, const std::string& script,
                         const std::string& without_gnuplot) {
  const ScratchFolder folder;
  write(folder.file("data.csv"), data);
  write(folder.file("figure.gp"),
        "set encoding utf8\nset datafile separator ','\ndata = 'data.csv'\n" + script +
            "unset output\n");
  switch (run_gnuplot(folder.path(), "figure.gp")) {
    case Drawing::no_gnuplot:
      throw InvalidInput("drawing needs gnuplot (Debian: gnuplot-nox); " + without_gnuplot);
    case Drawing::failed:
      throw Undecided("gnuplot could not draw: " +
                      shown_text(read(folder.file("gnuplot.log")), 300));
    case Drawing::done:
      break;
  }
  return read(folder.file("figure"));
}

std::string drawn(const Figure& figure, const std::string& format) {
  const std::string file =
      gnuplot_file(figure_csv(figure),
                   "set datafile columnheaders\n" + terminal_command(figure, format) +
                       "set output 'figure'\n" + figure.script,
                   "allowed without it: --format csv");
  if (format == "svg") return described(file, figure);
  return format == "pdf" ? dateless(file) : file;
}

}  // namespace magicmass::command
