// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"

TEST_CASE("the demo runs through, within 80 columns, and every comparison holds", "[exam]") {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"demo", "--out", folder / "demo"});
  INFO(run.output);
  CHECK(run.exit_code == 0);
  CHECK(run.errors.empty());
  for (const std::string& line : lines_of(run.output))
    if (line.find('/') == std::string::npos)
      CHECK(line.size() <= 80);  // paths are as long as they are
  const std::string points = read_file(folder / "demo/trajectory_c.csv");
  CHECK(points.starts_with("t,x_A,x_B,x_C\n-1,-1,1,0\n0,0,1,0\n"));
  if (run.output.find("needs gnuplot") != std::string::npos) {
    WARN("skipped: needs gnuplot");
    return;
  }
  CHECK(read_file(folder / "demo/trajectories.svg").find("<svg") != std::string::npos);
  CHECK(read_file(folder / "demo/trajectories.png").starts_with("\x89PNG"));
}

TEST_CASE("without gnuplot the demo says so and goes on", "[exam]") {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"demo", "--out", folder / "demo"}, "", {"/usr/bin/env", "PATH=/nowhere"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("skipped: needs gnuplot") != std::string::npos);
  CHECK(run.output.find("demo: every comparison") != std::string::npos);
  CHECK(std::filesystem::exists(folder / "demo/trajectory_a.csv"));
}
