// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"

TEST_CASE("help of the program and of every command begins with an example", "[exam]") {
  const ProgramRun whole = run_program({"--help"});
  CHECK(whole.exit_code == 0);
  CHECK(whole.errors.empty());
  CHECK(whole.output.starts_with("Example:\n  magicmass "));
  for (const std::string command :
       {"derive", "verify", "generate", "eval", "count", "terminal", "ratios", "simulate"}) {
    INFO(command);
    CHECK(whole.output.find("\n  " + command + " ") != std::string::npos);
    const ProgramRun help = run_program({command, "--help"});
    CHECK(help.exit_code == 0);
    CHECK(help.output.starts_with("Example:\n  magicmass " + command));
    for (const std::string& line : lines_of(help.output)) CHECK(line.size() <= 80);
  }
}

TEST_CASE("the version is one line", "[exam]") {
  const ProgramRun run = run_program({"--version"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.starts_with("magicmass "));
  CHECK(lines_of(run.output).size() == 1);
}

TEST_CASE("no escape code reaches a pipe or a file", "[exam]") {
  const TemporaryFolder folder;
  CHECK(run_program({"derive", "-o", folder / "derivation.txt"}).exit_code == 0);
  for (const std::string& text :
       {run_program({"derive"}).output, run_program({"derive", "--summary"}).output,
        run_program({"--help"}).output, run_program({"derive"}, "", {"env", "NO_COLOR=1"}).output,
        read_file(folder / "derivation.txt")}) {
    CHECK(!text.empty());
    CHECK(text.find('\x1b') == std::string::npos);
  }
}

TEST_CASE("a terminal sees verdicts in colour, unless NO_COLOR is set", "[exam]") {
  if (run_program({}, "", {"sh", "-c", "command -v script"}).exit_code != 0) {
    WARN("skipped: needs script (Debian: bsdutils)");
    return;
  }
  const auto on_terminal = [](const std::string& environment) {
    const std::string line =
        "script -qec \"env " + environment + " '$0' derive contact\" /dev/null";
    return run_program({}, "", {"sh", "-c", line}).output;
  };
  CHECK(on_terminal("-u NO_COLOR TERM=xterm").find("\x1b[32mproved\x1b[0m") != std::string::npos);
  CHECK(on_terminal("NO_COLOR=1 TERM=xterm").find('\x1b') == std::string::npos);
  CHECK(on_terminal("-u NO_COLOR TERM=dumb").find('\x1b') == std::string::npos);
}
