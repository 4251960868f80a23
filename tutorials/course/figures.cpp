// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/figures.hpp"

#include <algorithm>

#include "course/refusal.hpp"
#include "course/shell.hpp"

namespace magicmass::course {
namespace {

namespace fs = std::filesystem;

/// The first line as a comment that gnuplot skips, bars as blanks, words in quotes.
std::string numbers_of(const Printed& block) {
  std::string text = "# ";
  for (const std::string& line : block.lines) {
    for (const std::string& cell : cells(line))
      text += cell.find(' ') == std::string::npos ? cell + " " : '"' + cell + "\" ";
    text += "\n";
  }
  return text;
}

}  // namespace

void draw_figure(const std::string& magicmass, const std::string& name,
                 const fs::path& svg) {
  fs::create_directories(svg.parent_path());
  if (run(quoted(magicmass) + " figure " + quoted(name) + " --format svg -o " +
          quoted(svg.string()))
          .status != 0)
    throw Refusal("magicmass figure " + name + " drew nothing");
}

std::vector<std::string> names_in(const std::string& script) {
  std::vector<std::string> names;
  for (std::size_t at = 0; (at = script.find("{{", at)) != std::string::npos; ++at)
    names.push_back(script.substr(at + 2, script.find("}}", at) - at - 2));
  return names;
}

void draw_plot(const std::string& script, const std::vector<Printed>& printed,
               const fs::path& svg) {
  std::string text =
      "set terminal svg size 800,480 dynamic enhanced font 'DejaVu Sans,15' "
      "background '#ffffff'\n"
      "set output " +
      quoted(svg.filename().string()) + "\n" + script;
  std::vector<fs::path> files{svg};
  const auto file = [&](const std::string& extension) {
    files.push_back(fs::path(svg).replace_extension(extension));
    return files.back();
  };
  for (const std::string& name : names_in(script)) {
    const auto block =
        std::find_if(printed.begin(), printed.end(),
                     [&](const Printed& each) { return each.name == name; });
    if (block == printed.end() || !block->is_block)
      throw Refusal("{{" + name +
                    "}} in a plot is no block that the program prints");
    const fs::path data = file(name + ".dat");
    write(data, numbers_of(*block));
    const std::string place = "{{" + name + "}}";
    for (std::size_t at = 0; (at = text.find(place, at)) != std::string::npos;)
      text.replace(at, place.size(), data.filename().string());
  }
  const fs::path gnuplot = file("gnuplot");
  write(gnuplot, text);
  const Ran ran = run("cd " + quoted(svg.parent_path().string()) + " && gnuplot " +
                      quoted(gnuplot.filename().string()) + " 2>&1");
  if (ran.status != 0) throw Refusal("gnuplot drew nothing: " + ran.output);
  for (std::size_t i = 1; i < files.size(); ++i) fs::remove(files[i]);
}

}  // namespace magicmass::course
