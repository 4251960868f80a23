// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

void check_answer(const std::vector<std::string>& words, const std::string& line) {
  const ProgramRun run = run_program(words);
  CAPTURE(words);
  CHECK(run.exit_code == 2);
  CHECK(run.output.empty());
  CHECK(run.errors.starts_with("magicmass: " + line));
  CHECK(lines_of(run.errors).size() == 1);
}

}  // namespace

TEST_CASE("a misspelt command or option is answered with the nearest", "[exam]") {
  check_answer({"evla", "--alpha", "1"}, "no command is called \"evla\"; did you mean eval?");
  check_answer({"eval", "--aplha", "1", "--n", "1"},
               "magicmass eval has no option --aplha; did you mean --alpha? see magicmass eval");
  check_answer({"simulate", "x.toml", "--mdoel=exact"},
               "magicmass simulate has no option --mdoel; did you mean --model?");
  check_answer({"--vrsion"}, "magicmass has no option --vrsion; did you mean --version?");
}

TEST_CASE("nothing is suggested that is not near", "[exam]") {
  check_answer({"count", "--zzzzzz"},
               "magicmass count has no option --zzzzzz; see magicmass count");
}

TEST_CASE("a scene's misspelt key is answered with the nearest", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "s.toml", "alpha = 0.1\nrestitutoin = 0.9\n");
  const ProgramRun run = run_program({"plan", folder / "s.toml"});
  CHECK(run.exit_code == 2);
  CHECK(run.errors.find("s.toml:2: restitutoin: unknown key, did you mean restitution?") !=
        std::string::npos);
}
