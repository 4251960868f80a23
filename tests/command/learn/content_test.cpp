// SPDX-License-Identifier: GPL-2.0-or-later
// The exercises themselves: `learn test` is green over all of them, and red where one is spoiled.
#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include <catch2/catch.hpp>

#include "learn_run.hpp"

using Catch::Contains;

namespace {

namespace fs = std::filesystem;

/// A course of copies of exercises, to be spoiled.
class Course {
public:
  explicit Course(fs::path content) : content_(std::move(content)) {}

  /// A copy of an exercise under another name.
  Course& add(const std::string& chapter, const std::string& id, const std::string& name) {
    folder_ = content_ / chapter / "exercises" / name;
    fs::create_directories(folder_);
    fs::copy(fs::path(MAGICMASS_SOURCE_DIR) / "tutorials" / chapter / "exercises" / id, folder_,
             fs::copy_options::recursive);
    return replace("exercise.toml", "id = \"" + id + "\"", "id = \"" + name + "\"");
  }
  /// In the copy that was added last.
  Course& replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = read_file(folder_ / file);
    const std::size_t at = from.empty() ? text.size() : text.find(from);
    REQUIRE(at != std::string::npos);
    write_file(folder_ / file, text.replace(at, from.size(), to + (from.empty() ? "\n" : "")));
    return *this;
  }

private:
  fs::path content_, folder_;
};

/// A change to one exercise, and what `learn test` must say of it. An empty `from` adds to the file's end.
struct Spoiled {
  std::string chapter, id, file, from, to, complaint;
};

const std::vector<Spoiled>& spoiled() {
  static const std::string angle = "03_axis_and_angle";
  static const std::string contact = "01_contact";
  static const std::string magic = "06_magic_ratios";
  static const std::vector<Spoiled> all{
      // solutions
      {angle, "half_angle", "solution/answer.txt", "1/(1 + alpha)", "1/(2 + alpha)",
       "the solution is not what the theorem rotation.cos_half_psi says"},
      {contact, "collide", "solution/answer.cpp", "{2 * common", "{3 * common",
       "the solution is judged wrong"},
      {"05_counting", "count_them", "solution/answer.txt", "N_A", "2*N_A", "the law does not hold"},
      {contact, "momentum_lines", "solution/answer.txt", "u_1 + v_1 = u_2 + v_2", "u_1 = v_2",
       "the solution is judged wrong"},
      // formulas that no theorem carries
      {contact, "collide", "exercise.toml", "+ 2*M_2*u_2)", "+ 3*M_2*u_2)",
       "the solution is not what the theorem contact.v_1 says"},
      {contact, "momentum_lines", "exercise.toml", "+ 2*M_1*u_1)", "+ 3*M_1*u_1)",
       "the solution is not what the theorem contact.v_2 says"},
      {angle, "half_angle", "exercise.toml", "cos_half_psi", "cos_half",
       "there is none called rotation.cos_half"},
      // misconceptions that nobody can have, or that are right
      {angle, "half_angle", "misconceptions.toml", "cos(psi/4)", "1/(1 + alpha)",
       "is not recognised in 1/(1 + alpha)"},
      {contact, "collide", "sticking.cpp", "{common, common}",
       "{2 * common - u_1, 2 * common - u_2}", "misconception \"sticking\" is not recognised"},
      // numbers and formulas in texts
      {angle, "half_angle", "after.md", "cos(psi/2) = 1/(1 + alpha)", "cos(psi/2) = 1/(2 + alpha)",
       "after.md: {{cos(psi/2) = 1/(2 + alpha)}} is not proved"},
      {magic, "golden_ball", "after.md", "", "It is about 0.236.",
       "after.md: a decimal number is typed in the text"},
      {angle, "half_angle", "prompt.md", "", "    " + std::string(90, 'x'),
       "prompt.md: a line is wider than 80 columns"},
      {angle, "half_angle", "prompt.md", "", "What is {{1/(}}?", "prompt.md: "},
      {angle, "half_angle", "prompt.md", "", "Wh\xe4t is that?", "prompt.md: not UTF-8"},
      {angle, "half_angle", "prompt.md", "", "About {{sqrt(2) : many}}.",
       "{{sqrt(2) : many}}: a number of digits from 1 to 100 is expected"},
      // starters and answers
      {angle, "half_angle", "answer.txt", "", "1/(1 + alpha)", "the starter is right already"},
      {magic, "golden_ball", "exercise.toml", "√5−2", "√5−3", "right answer √5−3 is judged wrong"},
      {magic, "golden_ball", "exercise.toml", "\"1/4\"", "\"√5-2\"",
       "wrong answer √5-2 is judged right"},
      // a pass of the generator
      {"12_formula_to_code", "share_nodes", "exercise.toml", "power.a_product", "power.a_produced",
       "there is no theorem called power.a_produced; magicmass derive --list has them"},
      {"12_formula_to_code", "share_nodes", "solution/answer.cpp", "node.value};", "0.0};",
       "the solution is judged wrong"},
      // the second variant alone
      {magic, "deficient_in_radicals", "exercise.toml", "2/sqrt(3) - 1", "2/sqrt(3) - 2",
       "with k = 2, radicals = 2/sqrt(3) - 2: "},
  };
  return all;
}

}  // namespace

TEST_CASE("all exercises hold what they promise", "[exam]") {
  const ProgramRun run = run_program({"learn", "test", "--format", "json"});
  INFO(run.output.substr(0, 4000) << run.errors);
  CHECK(run.exit_code == 0);
  const nlohmann::json report = nlohmann::json::parse(run.output);
  CHECK(report.at("checked") >= 50);
  CHECK(report.at("answers") >= 200);
  CHECK(report.at("failures").empty());
}

TEST_CASE("whatever is spoiled in an exercise is red, and nothing else", "[exam]") {
  const TemporaryFolder content;
  Course course(content.path());
  course.add("03_axis_and_angle", "half_angle", "good");
  for (std::size_t i = 0; i < spoiled().size(); ++i) {
    const Spoiled& one = spoiled()[i];
    course.add(one.chapter, one.id, "spoiled_" + std::to_string(i))
        .replace(one.file, one.from, one.to);
  }
  const ProgramRun run =
      run_program({"learn", "test", "--content", content.path().string(), "--format", "json"});
  CHECK(run.exit_code == 1);
  std::map<std::string, std::string> complaints;
  const nlohmann::json report = nlohmann::json::parse(run.output);
  for (const auto& failure : report.at("failures"))
    complaints[failure.at("id").get<std::string>()] += failure.at("what").get<std::string>() + "\n";
  CHECK(complaints.count("good") == 0);
  for (std::size_t i = 0; i < spoiled().size(); ++i) {
    INFO(spoiled()[i].file << ": " << spoiled()[i].to);
    CHECK_THAT(complaints["spoiled_" + std::to_string(i)], Contains(spoiled()[i].complaint));
  }
}

TEST_CASE("bad exercise files get one line: file, line, key and what is allowed", "[exam]") {
  struct BadFile {
    std::string from, to, complaint;
  };
  for (const BadFile& one : std::vector<BadFile>{
           {"kind = \"symbolic\"", "kind = \"symbol\"",
            "line 3: kind: got \"symbol\"; allowed: symbolic, code, predict"},
           {"difficulty = 1", "difficulty = 9",
            "difficulty: got 9; allowed: a whole number from 1"},
           {"difficulty = 1", "difficulty = 1\nlevel = 2", "level: unknown key; allowed: "},
           {"id = \"half_angle\"", "id = \"other\"",
            "id: got \"other\"; allowed: the folder's name"},
           {"id = \"half_angle\"", "id = ", "not valid TOML"},
           {"title = ", "titel = ",
            "titel: unknown key; did you mean title?; allowed: a line like title"},
           {"form = \"no trig", "form = \"no nice", "form: got \"no nice"},
           {"symbols = [\"alpha\", \"psi\"]", "symbols = 3", "symbols: not a list; allowed: "},
           {"theorem = \"rotation.cos_half_psi\"\n", "", "theorem: missing; allowed: the id"},
           {"hints = [\n", "hints = [\n\"one more\",", "hints: 4 hints; allowed: three"}}) {
    const TemporaryFolder content;
    Course(content.path())
        .add("03_axis_and_angle", "half_angle", "half_angle")
        .replace("exercise.toml", one.from, one.to);
    const ProgramRun run = run_program({"learn", "list", "--content", content.path().string()});
    INFO(run.errors);
    CHECK(run.exit_code == 2);
    CHECK(lines_of(run.errors).size() == 1);
    CHECK_THAT(run.errors, Contains("exercise.toml: line ") && Contains(one.complaint));
  }
}

TEST_CASE("keys of inner sections are named with their lines, too", "[exam]") {
  const TemporaryFolder content;
  Course(content.path())
      .add("01_contact", "collide", "collide")
      .replace("exercise.toml", "words = \"velocity of first body\"", "word = \"x\"");
  const ProgramRun run = run_program({"learn", "list", "--content", content.path().string()});
  CHECK(run.exit_code == 2);
  const std::string toml =
      read_file(content.path() / "01_contact" / "exercises" / "collide" / "exercise.toml");
  const auto line =
      1 + std::count(toml.begin(), toml.begin() + static_cast<long>(toml.find("word = ")), '\n');
  CHECK_THAT(run.errors, Contains("line " + std::to_string(line) +
                                  ": word: unknown key; did you mean words?; allowed: "));
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
