// SPDX-License-Identifier: GPL-2.0-or-later
// What is said to answers, to exercises that are not sound, and to files that are no exercises.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "answers/errors.hpp"
#include "catch.hpp"
#include "learn/judge.hpp"

using learn::Exercise;

namespace {

const std::string source = MAGICMASS_SOURCE;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

const std::map<std::string, Exercise>& exercises() {
  static const std::map<std::string, Exercise> all = [] {
    std::map<std::string, Exercise> found;
    for (const auto& file : std::filesystem::recursive_directory_iterator(source + "/tutorials"))
      if (file.path().parent_path().filename() == "exercises") {
        const Exercise e = learn::read_exercise(text_of(file.path()), file.path());
        found.emplace(e.id, e);
      }
    return found;
  }();
  return all;
}

const std::string sound = R"toml(id = "x"
title = "x"
chapter = "x"
kind = "symbolic"
prompt = "x"
symbols = ["alpha"]
answer = "1/(1 + alpha)"
hints = ["x"]
)toml";
const std::string misconception = R"toml(
[[misconceptions]]
answers = ["1 + alpha"]
feedback = "Upside down."
)toml";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}
std::string all_faults(const std::string& text) {
  std::string all;
  for (const std::string& fault : learn::faults(learn::read_exercise(text, "x.toml")))
    all += fault + "\n";
  return all;
}
std::string refusal(const std::string& text) {
  try {
    learn::read_exercise(text, "x.toml");
  } catch (const answers::InvalidInput& error) {
    return error.what();
  }
  return "read";
}

}  // namespace

TEST_CASE("Answers are judged as in answers.tsv") {
  std::istringstream rows(text_of(source + "/tests/src/learn/answers.tsv"));
  std::string id, answer, verdict, part;
  int judged = 0;
  for (std::string line; std::getline(rows, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    std::getline(fields, id, '\t');
    std::getline(fields, answer, '\t');
    std::getline(fields, verdict, '\t');
    part.clear();
    std::getline(fields, part);
    const learn::Judgement said = learn::judge(exercises().at(id), answer);
    INFO(line << "\n" << said.feedback);
    CHECK(word(said.mark) == verdict);
    CHECK_THAT(said.feedback, ContainsSubstring(part));
    CHECK(said.feedback.find("typed_") == std::string::npos);
    ++judged;
  }
  CHECK(judged >= 500);
}

TEST_CASE("Each exercise is sound") {
  CHECK(exercises().size() == 40);
  for (const auto& [id, e] : exercises()) {
    INFO(id);
    CHECK(learn::faults(e) == learn::Texts{});
  }
}

TEST_CASE("What is spoilt in an exercise is a fault of it") {
  REQUIRE(all_faults(sound + misconception) == "");
  const auto faults = [](const std::string& from, const std::string& to) {
    return all_faults(changed(sound + misconception, from, to));
  };
  CHECK_THAT(faults("1 + alpha\"]", "1/(alpha + 1)\"]"), ContainsSubstring("is judged right"));
  CHECK_THAT(faults("1 + alpha\"]", "1 + alpha\", \"1 - (\"]"),
             ContainsSubstring("1 - ( is judged unread"));
  CHECK_THAT(faults("answer =", "answer_from = \"rotation.psi\"\nanswer ="),
             ContainsSubstring("its own answer is judged wrong"));
  CHECK_THAT(faults("answer =", "form = \"no difference\"\nanswer_from = \"nowhere.x\"\nanswer ="),
             ContainsSubstring("nowhere.x"));
  CHECK_THAT(faults("1/(1 + alpha)\"", "1/(1 + alpha\""),
             ContainsSubstring("1/(1 + alpha: column"));
  CHECK_THAT(faults("answer = \"1/", "form = \"factored\"\nanswer = \"0 + 1/"),
             ContainsSubstring("judged other form"));
  CHECK_THAT(faults("hints = [\"x\"]", "hints = []"), ContainsSubstring("hints are missing"));
  CHECK_THAT(faults("symbolic\"", "predict\"\nrun = \"walk --alpha 1\""),
             ContainsSubstring("run: allowed"));
  CHECK_THAT(
      faults("symbolic\"", "predict\"\nchoices = [\"x\", \"y\"]\nwhen = [\"1 = 1\", \"0 < 1\"]"),
      ContainsSubstring("2 choices are right"));
}

TEST_CASE("A file that is no exercise is refused by line") {
  REQUIRE(refusal(sound) == "read");
  const auto refused = [](const std::string& from, const std::string& to) {
    return refusal(changed(sound + misconception, from, to));
  };
  CHECK_THAT(refused("title = \"x\"\n", ""), ContainsSubstring("title is missing"));
  CHECK_THAT(refused("hints", "hint"),
             ContainsSubstring("x.toml:8: no such key: hint; is hints meant?"));
  CHECK_THAT(refused("symbolic", "code"), ContainsSubstring("not in this version yet"));
  CHECK_THAT(refused("symbolic", "riddle"), ContainsSubstring("kind: allowed: symbolic"));
  CHECK_THAT(refused("answer =", "form = \"nice\"\nanswer ="),
             ContainsSubstring("form: allowed: no trig"));
  CHECK_THAT(refused("[\"alpha\"]", "\"alpha\""), ContainsSubstring("x.toml:6: symbols: texts"));
  CHECK_THAT(refused("[\"alpha\"]", "[1]"), ContainsSubstring("symbols: a text is expected"));
  CHECK_THAT(refused("answer = \"1/(1 + alpha)\"\n", ""), ContainsSubstring("answer is missing"));
  CHECK_THAT(refused("feedback", "says"), ContainsSubstring("no such key in a misconception"));
  CHECK_THAT(refused("feedback = \"Upside down.\"\n", ""),
             ContainsSubstring("needs answers and feedback"));
  CHECK_THAT(refused("symbolic", "derivation"), ContainsSubstring("laws are missing"));
  CHECK_THAT(refused("kind = ", "kind "), ContainsSubstring("allowed: an exercise in TOML"));
  CHECK_THAT(refused("answer =", "choices = [\"x\"]\nwhen = []\nvalues = 3\nanswer ="),
             ContainsSubstring("values: names and texts"));
}

TEST_CASE("A byte order mark, comments and lines of an answer's file are read as typed") {
  const Exercise e = learn::read_exercise(sound, "x.toml");
  CHECK(learn::judge(e, "\xEF\xBB\xBF# mine\r\n  1/(1 + alpha)\r\n\n").mark == learn::Mark::right);
  CHECK(learn::judge(e, "# nothing\n").mark == learn::Mark::unread);
  CHECK(learn::judge(e, std::string(30000, '(')).mark == learn::Mark::unread);
  CHECK(learn::judge(e, "\x1b[2J").feedback.find('\x1b') == std::string::npos);
}
