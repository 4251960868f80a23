// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/figure/drawing.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "command/destination.hpp"
#include "command/gnuplot.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

/// A new folder for gnuplot to work in, gone at the end.
class WorkFolder {
public:
  WorkFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "magicmass-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw InvalidInput("cannot make a folder for gnuplot in " +
                         shown_text(std::filesystem::temp_directory_path().string(), 200));
    path = name;
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder(WorkFolder&&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }

  void write(const std::string& name, const std::string& text) const {
    Destination file((path / name).string());
    file.write(text);
    file.finish();
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path path;
};

std::string terminal_command(const Figure& figure, const std::string& format) {
  if (format == "png")
    return fmt::format(
        "set terminal pngcairo size {},{} font 'sans,14' fontscale 1.6 linewidth 1.6 pointscale "
        "1.6\n",
        2 * figure.width, 2 * figure.height);
  if (format == "pdf")  // 96 SVG pixels make an inch, and one is 0.75 points
    return fmt::format(
        "set terminal pdfcairo size {:.3f}in,{:.3f}in font 'sans,14' fontscale 0.75\n",
        figure.width / 96.0, figure.height / 96.0);
  return fmt::format("set terminal svg size {},{} font 'sans,14' background 'white'\n",
                     figure.width, figure.height);
}

std::string in_xml(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '&')
      escaped += "&amp;";
    else if (character == '<')
      escaped += "&lt;";
    else if (character == '>')
      escaped += "&gt;";
    else
      escaped += character;
  }
  return escaped;
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
              "<title id=\"title\">" + in_xml(figure.title) + "</title>\n<desc id=\"desc\">" +
                  in_xml(figure.description) + "</desc>");
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

std::string drawn(const Figure& figure, const std::string& format) {
  const WorkFolder folder;
  folder.write("data.csv", figure_csv(figure));
  folder.write("figure.gp",
               "set encoding utf8\nset datafile separator ','\nset datafile columnheaders\n"
               "data = 'data.csv'\n" +
                   terminal_command(figure, format) + "set output 'figure'\n" + figure.script +
                   "unset output\n");
  switch (run_gnuplot(folder.path, "figure.gp")) {
    case Drawing::no_gnuplot:
      throw InvalidInput(
          "figures need gnuplot (Debian: gnuplot-nox); allowed without it: --format csv");
    case Drawing::failed:
      throw Undecided("gnuplot could not draw: " + shown_text(folder.read("gnuplot.log"), 300));
    case Drawing::done:
      break;
  }
  const std::string file = folder.read("figure");
  if (format == "svg") return described(file, figure);
  return format == "pdf" ? dateless(file) : file;
}

}  // namespace magicmass::command
