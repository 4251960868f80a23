// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

/// Pages and completions of the program, in a folder.
struct Written {
  TemporaryFolder folder;
  ProgramRun run = run_program({"manual", "--man", folder / "man1", "--completions", folder / "c"});
};

ProgramRun with_shell(const std::string& shell, const std::string& line) {
  return run_program({}, "", {shell, "-c", line});
}

bool has(const std::string& program) {
  return with_shell("sh", "command -v " + program).exit_code == 0;
}

}  // namespace

TEST_CASE("a man page for each visible command, that troff takes without a word", "[exam]") {
  const Written written;
  REQUIRE(written.run.exit_code == 0);
  const std::vector<std::string> lines = lines_of(run_program({"manual"}).output);
  std::size_t pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(written.folder / "man1")) {
    ++pages;
    const std::string page = read_file(entry.path());
    INFO(entry.path());
    CHECK(page.find(".SH EXAMPLES\n.nf\nmagicmass ") != std::string::npos);
    if (!has("groff")) continue;
    const ProgramRun troff =
        with_shell("sh", "groff -man -Tutf8 -K utf8 -ww -z '" + entry.path().string() + "'");
    CHECK(troff.exit_code == 0);
    CHECK(troff.errors == "");
  }
  CHECK(pages == lines.size());
}

TEST_CASE("the same pages and completions each time, from anywhere", "[exam]") {
  const Written once, again;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(once.folder.path())) {
    if (!entry.is_regular_file()) continue;
    const auto path = again.folder.path() / entry.path().lexically_relative(once.folder.path());
    INFO(path);
    CHECK(read_file(entry.path()) == read_file(path));
  }
}

TEST_CASE("bash completes commands, options and their values", "[exam]") {
  const Written written;
  const auto offered = [&](const std::string& line) {
    return with_shell("bash", "source '" + written.folder / "c/magicmass" + "'; COMP_WORDS=(" +
                                  line +
                                  "); "
                                  "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _magicmass; "
                                  "echo \"${COMPREPLY[*]}\"")
        .output;
  };
  CHECK(offered("magicmass si") == "simulate\n");
  CHECK(offered("magicmass de") == "derive\n");  // demo is hidden
  CHECK(offered("magicmass eval --al") == "--alpha\n");
  CHECK(offered("magicmass derive --al") == "\n");
  CHECK(offered("magicmass simulate scene.toml --format j") == "json jsonl\n");
  CHECK(offered("magicmass figure tra") == "trajectories transmission\n");
  CHECK(offered("magicmass eval --alpha ''") == "\n");
}

TEST_CASE("zsh and fish read their completions", "[exam]") {
  const Written written;
  if (has("zsh"))
    CHECK(with_shell("zsh", "zsh -n '" + written.folder / "c/_magicmass" +
                                "' && autoload -U "
                                "compinit && compinit -D && source '" +
                                written.folder / "c/_magicmass" + "' && whence _magicmass_eval")
              .output == "_magicmass_eval\n");
  else
    WARN("skipped: no zsh");
  if (!has("fish")) {
    WARN("skipped: no fish");
    return;
  }
  const ProgramRun fish =
      with_shell("fish", "source '" + written.folder / "c/magicmass.fish" +
                             "'; complete -C 'magicmass si'; complete -C 'magicmass eval --al'");
  CHECK(fish.errors == "");
  CHECK(fish.output.starts_with("simulate\tRun a scene"));
  CHECK(fish.output.find("\n--alpha\t") != std::string::npos);
}

TEST_CASE("pages that cannot be written are refused in a line", "[exam]") {
  const ProgramRun run = run_program({"manual", "--man", "/proc/nothing"});
  CHECK(run.exit_code == 2);
  CHECK(lines_of(run.errors).size() == 1);
}
