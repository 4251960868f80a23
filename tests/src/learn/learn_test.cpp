// What is said to answers, to exercises that are not sound, and to files that are no exercises.
#include <cmath>

#include "classroom/classroom.hpp"
#include "magicmass/scenes/files.hpp"
#include "rows.hpp"

using learn::Exercise;
using learn::Texts;

namespace {

std::string text_of(const std::string& name) {
  return magicmass::scenes::text_of(MAGICMASS_SOURCE "/tests/src/learn/" + name, "a text");
}

learn::Rows seen;
/// Of each program what it gives for a case; "late" stops at the second one.
learn::Ran fake(const Exercise&, const std::string& code, const learn::Rows& inputs) {
  seen = inputs;
  if (code == "junk") return {.unread = "line 1"};
  learn::Ran ran;
  for (const learn::Numbers& in : inputs) {
    const double x = in[0], n = in[1], off = std::nextafter(2 * x, 100) - 2 * x;
    if (code == "late" && n == 1) {
      ran.stopped = "it stopped: why?";
      break;
    }
    ran.rows.push_back({code == "f(x) = x/2"      ? x / 2
                        : code == "zero"          ? 0
                        : code.starts_with("nan") ? std::nan("")
                        : code == "two ulp"       ? 2 * x + 2 * off
                        : code == "three ulp"     ? 2 * x + 3 * off
                                                  : 2 * x,
                        code == "sum" ? n : n + 3});
  }
  if (code == "one row") ran.rows.resize(1);
  return ran;
}

/// Why a file is no exercise, or else the first fault of the exercise.
std::string complaint(const std::string& text) {
  Texts faults;
  const std::string why = refusal<answers::InvalidInput>(
      [&] { faults = learn::faults(learn::read_exercise(text, "x.toml"), fake); });
  if (why != "not refused") return "refused: " + why;
  return faults.empty() ? "sound" : "faulty: " + faults[0];
}

}  // namespace

TEST_CASE("Prompt, list and judge agree on what an answer may use; no example gives it away") {
  for (std::size_t variant = 0; variant < 2; ++variant)
    for (const Exercise& e : classroom::exercises("", variant)) {
      if (!e.choices.empty() || (e.kind != "symbolic" && e.kind != "predict")) continue;
      INFO(e.id << ": " << learn::rules(e)[0]);
      const Texts list = learn::matched(learn::rules(e)[0], "An answer may use: (.*)");
      for (const std::string& name : learn::split(list.empty() ? "" : list[1], ',')) {
        CHECK(!learn::matched(e.prompt, R"([\s\S]*\b)" + name + R"(\b[\s\S]*)").empty());
        CHECK(learn::judge(e, name).mark != learn::Mark::unread);
      }
      const std::string how = learn::how_to_write(e, learn::judge(e, "(").feedback);
      const std::string example = how.substr(how.find(" answer: ") + 9);
      const learn::Judgement said = learn::judge(e, example);
      CHECK(example.find(learn::own_answer(e)) == example.npos);
      CHECK((said.mark == learn::Mark::wrong && said.notes.empty()));
    }
}

TEST_CASE("Answers are judged as in both tables, one of which has five to each exercise") {
  std::vector<Texts> rows = rows_of("src/learn/five_answers.tsv", 5);
  std::map<std::string, Exercise> exercises;
  for (const Exercise& e : classroom::exercises()) {
    exercises.emplace(e.id, e);
    CHECK(std::ranges::count_if(rows, [&](const Texts& row) { return row[0] == e.id; }) == 5);
  }
  std::ranges::move(rows_of("src/learn/answers.tsv", 5), std::back_inserter(rows));
  CHECK(rows.size() >= 1000);
  for (Texts row : rows) {
    learn::replace_all(row[1], "<CR>", "\r");
    learn::replace_all(row[1], "\\n", "\n");
    const learn::Judgement said = learn::judge(exercises.at(row[0]), row[1], classroom::run_code);
    INFO(answers::joined(row) << "\n" << said.feedback);
    CHECK(word(said.mark) == row[2]);
    CHECK_THAT(said.feedback + "|", ContainsSubstring(row[3]));
    CHECK_THAT("|" + answers::joined(said.notes) + "|", ContainsSubstring(row[4]));
    CHECK(said.feedback.find("typed_") == std::string::npos);
  }
}

TEST_CASE("What is spoilt in an exercise is refused by line, or a fault of it") {
  for (const char* name : {"symbolic.toml", "varied.toml", "code.toml", "derived.toml"})
    CHECK(complaint(text_of(name)) == "sound");
  for (Texts& row : rows_of("src/learn/spoilt.tsv", 5)) {
    INFO(answers::joined(row));
    for (std::string& text : row) learn::replace_all(text, "\\n", "\n");
    std::string text = text_of(row[0] + ".toml");
    learn::replace_all(text, row[1], row[2]);
    const std::string said = complaint(text);
    CHECK(said.starts_with(row[3]));
    CHECK_THAT(said, ContainsSubstring(row[4]));
  }
}

TEST_CASE("A program is held against exact results at its doubles") {
  const Exercise e = learn::read_exercise(text_of("code.toml"), "x.toml");
  for (const Texts& row : rows_of("src/learn/programs.tsv", 3)) {
    INFO(row[0]);
    const learn::Judgement said = learn::judge(e, row[0], fake);
    CHECK(word(said.mark) == row[1]);
    CHECK(said.feedback == row[2]);
  }
  CHECK(learn::judge(e, "f(x) = 2 x").mark == learn::Mark::undecided);
  CHECK(seen == learn::Rows{{0.125, 0}, {1 + 0x1p-52, 1}, {1.0 / 3, 2}});
}
