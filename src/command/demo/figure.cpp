// SPDX-License-Identifier: GPL-2.0-or-later
#include <cerrno>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command/demo/demo_report.hpp"

namespace magicmass::command {
namespace {

/// Text in a gnuplot string.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char character : text)
    inside += character == '\'' ? std::string("''") : std::string(1, character);
  return "'" + inside + "'";
}

/// Three panels; A and B solid, C dashed, all black.
std::string script() {
  std::string plots = "set multiplot layout 3,1 margins 0.1,0.97,0.08,0.97 spacing 0.03,0.025\n";
  const std::vector<std::pair<std::string, std::string>> panels = {
      {"a", "(a)  α = α_3 ≈ 0.1099"}, {"b", "(b)  α = 0.12"}, {"c", "(c)  α = 0.10"}};
  for (const auto& [panel, title] : panels) {
    const bool is_last = panel == "c";
    plots += fmt::format("set label 1 {} at graph 0.03,0.88\n", quoted(title));
    plots +=
        is_last ? "set format x '%g'\nset xlabel 't / (L/V)'\n" : "set format x ''\nunset xlabel\n";
    const std::string data = quoted("trajectory_" + panel + ".csv");
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
             quoted("trajectories.svg"), plots) +
         fmt::format(
             "set terminal pngcairo size 1280,1800 font 'sans,14' fontscale 1.6 linewidth 2\nset "
             "output {}\n{}",
             quoted("trajectories.png"), plots);
}

enum class Drawing { done, no_gnuplot, failed };

/// In the folder, so that the figure, which names its data, names no path of this machine.
Drawing run_gnuplot(const std::filesystem::path& folder) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "gnuplot.log",
                                   O_WRONLY | O_CREAT | O_TRUNC, 0666);
  std::string program = "gnuplot";
  std::string argument = "trajectories.gp";
  char* const arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return Drawing::no_gnuplot;
  int status = 0;
  if (error != 0 || ::waitpid(child, &status, 0) != child) return Drawing::failed;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) return Drawing::no_gnuplot;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Drawing::done : Drawing::failed;
}

}  // namespace

void draw_scenes(DemoReport& report, const std::filesystem::path& folder) {
  report.heading("The figure");
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  Destination file((whole / "trajectories.gp").string());
  file.write(script());
  file.finish();
  switch (run_gnuplot(whole)) {
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
