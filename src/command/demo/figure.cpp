// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <fmt/format.h>

#include "command/demo/demo_report.hpp"
#include "command/gnuplot.hpp"

namespace magicmass::command {
namespace {

/// Three panels; A and B solid, C dashed, all black.
std::string script() {
  std::string plots = "set multiplot layout 3,1 margins 0.1,0.97,0.08,0.97 spacing 0.03,0.025\n";
  const std::vector<std::pair<std::string, std::string>> panels = {
      {"a", "(a)  α = α_3 ≈ 0.1099"}, {"b", "(b)  α = 0.12"}, {"c", "(c)  α = 0.10"}};
  for (const auto& [panel, title] : panels) {
    const bool is_last = panel == "c";
    plots += fmt::format("set label 1 {} at graph 0.03,0.88\n", gnuplot_quoted(title));
    plots +=
        is_last ? "set format x '%g'\nset xlabel 't / (L/V)'\n" : "set format x ''\nunset xlabel\n";
    const std::string data = gnuplot_quoted("trajectory_" + panel + ".csv");
    plots += fmt::format(
        "plot {0} using 1:2 with lines lw 2 dt solid lc 'black', {0} using 1:3 with lines lw 2 dt "
        "solid lc 'black', "
        "{0} using 1:4 with lines lw 1.8 dt (7,4) lc 'black'\n",
        data);
  }
  plots += "unset multiplot\nunset output\n";
  const std::string settings =
      "set encoding utf8\nset datafile separator ','\nset datafile columnheaders\nset key off\n"
      "set xrange [-1:5.5]\nset yrange [-1:5]\nset ytics -1,1,5\nset ylabel 'x / L'\n"
      "set label 2 'A' at -0.4,-0.75\nset label 3 'B' at -0.6,1.4\nset label 4 'C' at -0.75,0.35\n";
  return settings +
         fmt::format(
             "set terminal svg size 640,900 font 'sans,14' background 'white'\nset output {}\n{}",
             gnuplot_quoted("trajectories.svg"), plots) +
         fmt::format(
             "set terminal pngcairo size 1280,1800 font 'sans,14' fontscale 1.6 linewidth 2\nset "
             "output {}\n{}",
             gnuplot_quoted("trajectories.png"), plots);
}

}  // namespace

void draw_scenes(DemoReport& report, const std::filesystem::path& folder) {
  report.heading("The figure");
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  Destination file((whole / "trajectories.gp").string());
  file.write(script());
  file.finish();
  switch (run_gnuplot(whole, "trajectories.gp")) {
    case Drawing::no_gnuplot:
      report.print("skipped: needs gnuplot (Debian: gnuplot-nox); the data are in " +
                   whole.string() + "\n");
      break;
    case Drawing::failed:
      report.check("gnuplot could not draw; see " + (whole / "gnuplot.log").string(), false);
      break;
    case Drawing::done:
      for (const char* name : {"trajectories.svg", "trajectories.png", "trajectory_[abc].csv"})
        report.print((whole / name).string() + "\n");
  }
}

}  // namespace magicmass::command
