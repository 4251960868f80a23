// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

namespace {

namespace fs = std::filesystem;

/// The shell's answer to a line in which $P is the program.
ProgramRun run_shell(const std::string& line) {
  return run_program({}, "", {"sh", "-c", "P=$0; " + line});
}

}  // namespace

TEST_CASE("with -o a file gets the bytes that stdout would get", "[exam]") {
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"ratios", "--count", "1000", "-o", folder / "ratios.txt"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.empty());
  CHECK(read_file(folder / "ratios.txt") == run_program({"ratios", "--count", "1000"}).output);
  CHECK(folder.names() == std::vector<std::string>{"ratios.txt"});
}

TEST_CASE("a link to what is not there yet stays a link, through others and from its own folder",
          "[exam]") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "inner");
  fs::create_symlink("inner/second", folder / "first");
  fs::create_symlink("../new.txt", folder / "inner/second");
  CHECK(run_program({"count", "--alpha", "1", "-o", folder / "first"}).exit_code == 0);
  CHECK(fs::is_symlink(folder / "first"));
  CHECK(fs::is_symlink(folder / "inner/second"));
  CHECK(read_file(folder / "new.txt") == run_program({"count", "--alpha", "1"}).output);
  fs::create_symlink("nowhere/file", folder / "lost");
  const ProgramRun lost = run_program({"count", "--alpha", "1", "-o", folder / "lost"});
  CHECK(lost.exit_code == 2);
  CHECK(lines_of(lost.errors).size() == 1);
}

TEST_CASE(
    "a file keeps its content when the command fails, its rights and its links when it does not",
    "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "old.txt", "old\n");
  fs::permissions(folder / "old.txt", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(folder / "old.txt", folder / "link");
  CHECK(run_program({"count", "--alpha", "0", "-o", folder / "link"}).exit_code == 2);
  CHECK(read_file(folder / "old.txt") == "old\n");
  CHECK(run_program({"count", "--alpha", "1", "-o", folder / "link"}).exit_code == 0);
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_file(folder / "old.txt") == run_program({"count", "--alpha", "1"}).output);
  CHECK((fs::status(folder / "old.txt").permissions() & fs::perms::all) ==
        (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("what cannot be written is refused in one line", "[exam]") {
  const TemporaryFolder folder;
  for (const std::string& path : {std::string("/no/such/folder/answer"), folder.path().string(),
                                  folder / "no/answer", std::string("/dev/full")}) {
    const ProgramRun run = run_program({"count", "--alpha", "0.1", "-o", path});
    INFO(path);
    check_refused(run, "cannot write");
  }
  CHECK(folder.names().empty());
}

TEST_CASE("devices are written, not replaced", "[exam]") {
  CHECK(run_program({"count", "--alpha", "0.1", "-o", "/dev/null"}).exit_code == 0);
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a reader that stops early is no error", "[exam]") {
  for (const std::string line :
       {"{ \"$P\" ratios --count 1000000; echo \"exit $?\" >&2; } | head -n 1",
        "{ \"$P\" derive --format json; echo \"exit $?\" >&2; } | head -n 1"}) {
    const ProgramRun run = run_shell(line);
    CHECK(run.exit_code == 0);
    CHECK(lines_of(run.output).size() == 1);
    CHECK(run.errors == "exit 0\n");
  }
}

TEST_CASE("a stdout that takes nothing is an error", "[exam]") {
  for (const std::string line :
       {"\"$P\" count --alpha 0.1 >&-", "\"$P\" count --alpha 0.1 >/dev/full"}) {
    const ProgramRun run = run_shell(line);
    CHECK(run.exit_code == 2);
    CHECK(lines_of(run.errors).size() == 1);
  }
}
