// SPDX-License-Identifier: GPL-2.0-or-later
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

/// Every command of the tree with its words, the hidden ones, too.
void add_commands(const nlohmann::json& command, std::vector<std::string>& names) {
  names.push_back(command["name"]);
  for (const nlohmann::json& below : command["commands"]) add_commands(below, names);
}

std::vector<std::string> words_of(const std::string& command) {
  std::istringstream stream(command);
  std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  words.erase(words.begin());  // the program
  return words;
}

}  // namespace

TEST_CASE("help of the program and of every command begins with an example", "[exam]") {
  std::vector<std::string> names;
  add_commands(json_of({"manual"}), names);
  CHECK(names.size() > 16);
  for (const std::string& name : names) {
    INFO(name);
    std::vector<std::string> words = words_of(name);
    words.emplace_back("--help");
    const ProgramRun help = run_program(words);
    CHECK(help.exit_code == 0);
    CHECK(help.errors.empty());
    CHECK(help.output.starts_with("Example:\n  " + name));

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
