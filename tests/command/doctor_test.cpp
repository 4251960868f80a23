// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "program_run.hpp"

TEST_CASE("doctor finds what is in PATH, and only that", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "gnuplot", "#!/bin/sh\n");
  write_file(folder / "pandoc", "not executable");
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  const ProgramRun run =
      run_program({"doctor", "--format", "json"}, "", {"env", "PATH=" + folder.path().string()});
  REQUIRE(run.exit_code == 0);
  for (const nlohmann::json& one : nlohmann::json::parse(run.output)) {
    INFO(one);
    if (one["kind"] == "program") CHECK(one["found"] == (one["name"] == "gnuplot"));
    if (one["name"] == "gnuplot") CHECK(one["where"] == folder / "gnuplot");
    if (one["name"] == "baseline") CHECK(one["found"] == true);
  }
}

TEST_CASE("doctor says in a line what is missing, what for, and Debian's name of it", "[exam]") {
  const ProgramRun run = run_program({"doctor"}, "", {"env", "PATH=/nowhere"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("missing  gnuplot") != std::string::npos);
  CHECK(run.output.find("(Debian: gnuplot-nox)\n") != std::string::npos);
  CHECK(run_program({"doctor"}, "", {"env", "-u", "PATH"}).exit_code == 0);
}
