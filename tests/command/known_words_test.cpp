// SPDX-License-Identifier: GPL-2.0-or-later
#include <iterator>
#include <sstream>
#include <utility>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

using nlohmann::json;

void check_answer(const std::vector<std::string>& words, const std::string& line) {
  const ProgramRun run = run_program(words);
  CAPTURE(words);
  CHECK(run.exit_code == 2);
  CHECK(run.output.empty());
  CHECK(run.errors.starts_with("magicmass: " + line));
  CHECK(lines_of(run.errors).size() == 1);
}

/// With its first two letters the other way round.
std::string misspelt(std::string word) {
  std::swap(word[0], word[1]);
  return word;
}

std::vector<std::string> words_of(const json& command) {
  std::istringstream text(command["name"].get<std::string>());
  std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
  words.erase(words.begin());  // the program
  return words;
}

/// Every visible command below this one, and each of its long options, misspelt.
void check_below(const json& command, int& checked) {
  for (const json& option : command["options"])
    for (const json& name : option["names"]) {
      const std::string option_name = name;
      if (option_name.size() < 5 || option_name == "--help") continue;
      std::vector<std::string> words = words_of(command);
      words.push_back("--" + misspelt(option_name.substr(2)));
      check_answer(words, command["name"].get<std::string>() + " has no option " + words.back() +
                              "; did you mean " + option_name + "? see ");
      ++checked;
    }
  for (const json& below : command["commands"]) {
    if (below["hidden"]) continue;
    std::vector<std::string> words = words_of(below);
    const std::string right = words.back();
    words.back() = misspelt(right);
    const ProgramRun run = run_program(words);
    CAPTURE(words);
    CHECK(run.exit_code == 2);
    CHECK(run.errors.find("\"" + words.back() + "\"; did you mean " + right + "?") !=
          std::string::npos);
    ++checked;
    check_below(below, checked);
  }
}

}  // namespace

TEST_CASE("every command and option of the tree is suggested where it is misspelt", "[exam]") {
  int checked = 0;
  check_below(json_of({"manual"}), checked);
  CHECK(checked > 100);
}

TEST_CASE("an exercise, figure, chapter or quantity is suggested where it is misspelt", "[exam]") {
  check_answer({"learn", "show", "half_angel"},
               "no exercise is called \"half_angel\"; did you mean half_angle?");
  check_answer({"figure", "terminl"}, "no figure is called \"terminl\"; did you mean terminal?");
  check_answer({"derive", "powr"}, "no chapter or step is called \"powr\"; did you mean power?");
  check_answer({"derive", "--from", "a_nn"}, "no result is called \"a_nn\"; did you mean a_n?");
  check_answer({"generate", "--quantity", "a_tt"},
               "no quantity is called \"a_tt\"; did you mean a_t?");
}

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
