// SPDX-License-Identifier: GPL-2.0-or-later
// The exercises themselves: `learn test` is green over all of them, and red where one is spoiled.
#include <filesystem>

#include <catch2/catch.hpp>

#include "learn_run.hpp"

using Catch::Contains;

namespace {

namespace fs = std::filesystem;

/// A course with a copy of one exercise, to be spoiled.
class Copy {
public:
  Copy(const std::string& chapter, const std::string& id) : id_(id) {
    folder_ = fs::path(content_ / "tutorials") / chapter / "exercises" / id;
    fs::create_directories(folder_);
    fs::copy(fs::path(MAGICMASS_SOURCE_DIR) / "tutorials" / chapter / "exercises" / id, folder_,
             fs::copy_options::recursive);
  }
  Copy& replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = read_file(folder_ / file);
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    write_file(folder_ / file, text.replace(at, from.size(), to));
    return *this;
  }
  Copy& add(const std::string& file, const std::string& line) {
    write_file(folder_ / file, read_file(folder_ / file) + line + "\n");
    return *this;
  }
  ProgramRun test() const {
    return run_program({"learn", "test", id_, "--content", content_ / "tutorials"});
  }
  fs::path folder() const { return folder_; }

private:
  TemporaryFolder content_;
  std::string id_;
  fs::path folder_;
};

void require_red(const Copy& copy, const std::string& complaint) {
  const ProgramRun run = copy.test();
  INFO(run.output << run.errors);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.output, Contains("FAILED") && Contains(complaint));
}

}  // namespace

TEST_CASE("all exercises hold what they promise", "[exam]") {
  const ProgramRun run = run_program({"learn", "test", "--format", "json"});
  INFO(run.output.substr(0, 4000) << run.errors);
  CHECK(run.exit_code == 0);
  const nlohmann::json report = nlohmann::json::parse(run.output);
  CHECK(report.at("checked") >= 40);
  CHECK(report.at("answers") >= 200);
  CHECK(report.at("failures").empty());
}

TEST_CASE("a copy of a good exercise is good", "[exam]") {
  const Copy copy("03_axis_and_angle", "half_angle");
  CHECK(copy.test().exit_code == 0);
}

TEST_CASE("a spoiled solution is red", "[exam]") {
  require_red(Copy("03_axis_and_angle", "half_angle")
                  .replace("solution/answer.txt", "1/(1 + alpha)", "1/(2 + alpha)"),
              "the solution is not what the theorem rotation.cos_half_psi says");
  require_red(Copy("01_contact", "collide").replace("solution/answer.cpp", "2 *", "3 *"),
              "the solution is judged wrong");
  require_red(Copy("05_counting", "count_them").replace("solution/answer.txt", "N_A", "2*N_A"),
              "right");
  require_red(Copy("01_contact", "momentum_lines")
                  .replace("solution/answer.txt", "u_1 + v_1 = u_2 + v_2", "u_1 = v_2"),
              "the solution is judged wrong");
}

TEST_CASE("a formula that a theorem does not carry is red, in code, too", "[exam]") {
  require_red(
      Copy("01_contact", "collide").replace("exercise.toml", "+ 2*M_2*u_2)", "+ 3*M_2*u_2)"),
      "the solution is not what the theorem contact.v_1 says");
  require_red(
      Copy("01_contact", "momentum_lines").replace("exercise.toml", "+ 2*M_1*u_1)", "+ 3*M_1*u_1)"),
      "contact.v_2");
  require_red(
      Copy("03_axis_and_angle", "half_angle").replace("exercise.toml", "cos_half_psi", "cos_half"),
      "there is none called rotation.cos_half");
}

TEST_CASE("a misconception that nobody can have, or that is right, is red", "[exam]") {
  require_red(Copy("03_axis_and_angle", "half_angle")
                  .replace("misconceptions.toml", "cos(psi/4)", "1/(1 + alpha)"),
              "is not recognised in 1/(1 + alpha)");
  require_red(
      Copy("01_contact", "collide").replace("sticking.cpp", "{common, common}", "{0, 2 * common}"),
      "misconception \"sticking\" is not recognised");
}

TEST_CASE("a spoiled number or formula in a text is red", "[exam]") {
  require_red(Copy("03_axis_and_angle", "half_angle")
                  .replace("after.md", "cos(psi/2) = 1/(1 + alpha)", "cos(psi/2) = 1/(2 + alpha)"),
              "after.md: {{cos(psi/2) = 1/(2 + alpha)}} is not proved");
  require_red(Copy("06_magic_ratios", "golden_ball").add("after.md", "It is about 0.236."),
              "after.md: a decimal number is typed in the text");
  require_red(
      Copy("03_axis_and_angle", "half_angle").add("prompt.md", "    " + std::string(90, 'x')),
      "prompt.md: a line is wider than 80 columns");
  require_red(Copy("03_axis_and_angle", "half_angle").add("prompt.md", "What is {{1/(}}?"),
              "prompt.md: ");
}

TEST_CASE("a starter that is right, and answers that are judged otherwise, are red", "[exam]") {
  require_red(Copy("03_axis_and_angle", "half_angle").add("answer.txt", "1/(1 + alpha)"),
              "the starter is right already");
  require_red(Copy("06_magic_ratios", "golden_ball").replace("exercise.toml", "√5−2", "√5−3"),
              "right answer √5−3 is judged wrong");
  require_red(
      Copy("06_magic_ratios", "golden_ball").replace("exercise.toml", "\"1/4\"", "\"√5-2\""),
      "wrong answer √5-2 is judged right");
}

TEST_CASE("every variant is tried", "[exam]") {
  require_red(Copy("06_magic_ratios", "deficient_in_radicals")
                  .replace("exercise.toml", "2/sqrt(3) - 1", "2/sqrt(3) - 2"),
              "with k = 2, radicals = 2/sqrt(3) - 2: ");
}

TEST_CASE("bad exercise files get one line: file, line, key and what is allowed", "[exam]") {
  struct Spoiled {
    std::string from, to, complaint;
  };
  for (const Spoiled& one : std::vector<Spoiled>{
           {"kind = \"symbolic\"", "kind = \"symbol\"",
            "line 3: kind: got \"symbol\"; allowed: symbolic, code, predict"},
           {"difficulty = 1", "difficulty = 9",
            "difficulty: got 9; allowed: a whole number from 1"},
           {"difficulty = 1", "difficulty = 1\nlevel = 2", "level: unknown key; allowed: "},
           {"id = \"half_angle\"", "id = \"other\"",
            "id: got \"other\"; allowed: the folder's name"},
           {"id = \"half_angle\"", "id = ", "not valid TOML"},
           {"title = ", "titel = ", "title: missing; allowed: a line like title"},
           {"form = \"no trig", "form = \"no nice", "form: got \"no nice"},
           {"symbols = [\"alpha\", \"psi\"]", "symbols = 3", "symbols: not a list; allowed: "},
           {"theorem = \"rotation.cos_half_psi\"\n", "", "theorem: missing; allowed: the id"},
           {"hints = [\n", "hints = [\n\"one more\",", "hints: 4 hints; allowed: three"}}) {
    Copy spoiled("03_axis_and_angle", "half_angle");
    spoiled.replace("exercise.toml", one.from, one.to);
    const ProgramRun run = spoiled.test();
    INFO(run.errors);
    CHECK(run.exit_code == 2);
    CHECK(lines_of(run.errors).size() == 1);
    CHECK_THAT(run.errors, Contains("exercise.toml: line ") && Contains(one.complaint));
  }
}

TEST_CASE("a new exercise of each kind works at once", "[exam]") {
  const TemporaryFolder course;
  for (const char* kind : {"symbolic", "code", "predict"}) {
    const std::string id = std::string("my_") + kind;
    const ProgramRun made = run_program({"learn", "new", id, "--kind", kind, "--chapter",
                                         "04_sequences", "--content", course.path().string()});
    INFO(made.errors);
    CHECK(made.exit_code == 0);
    const ProgramRun test = run_program({"learn", "test", id, "--content", course.path().string()});
    INFO(test.output);
    CHECK(test.exit_code == 0);
    CHECK(run_program({"learn", "new", id, "--chapter", "04_sequences", "--content",
                       course.path().string()})
              .exit_code == 2);
  }
  CHECK(run_program({"learn", "new", "../x", "--chapter", "04_sequences"}).exit_code == 2);
  CHECK(run_program({"learn", "new", "x", "--chapter", "..", "--kind", "code"}).exit_code == 2);
  CHECK(run_program({"learn", "new", "x", "--chapter", "a", "--kind", "essay"}).exit_code == 2);
}

TEST_CASE("a class is graded by what is in the files, not by what progress.txt claims", "[exam]") {
  const TemporaryFolder folder;
  for (const char* name : {"ada", "bob", "eve"}) fs::create_directories(folder.path() / name);
  const std::string answer = "03_axis_and_angle/half_angle/answer.txt";
  run_program({"learn", "check", "half_angle", "1/(1+alpha)", "--folder", folder / "ada"});
  run_program({"learn", "check", "half_angle", "cos(psi)", "--folder", folder / "bob"});
  write_file(folder / "bob/progress.txt", "seed 0\nhalf_angle right 1 0 0\n");
  write_file(folder / "eve/progress.txt", "nonsense\n");
  const ProgramRun run = run_program({"learn", "grade", folder.path().string(), "--format", "csv"});
  CHECK(run.exit_code == 0);
  const std::vector<std::string> lines = lines_of(run.output);
  REQUIRE(lines.size() == 4);
  CHECK_THAT(lines[0], Catch::StartsWith("student,right,of,"));
  CHECK_THAT(lines[1], Catch::StartsWith("ada,1,") && Contains(",right"));
  CHECK_THAT(lines[2], Catch::StartsWith("bob,0,") && Contains(",wrong"));
  CHECK_THAT(lines[3], Catch::StartsWith("eve,0,"));
  CHECK_THAT(run.errors, Contains("progress.txt: line 1"));
  CHECK(run_program({"learn", "grade", "/nowhere"}).exit_code == 2);
}
