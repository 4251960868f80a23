// SPDX-License-Identifier: GPL-2.0-or-later
// The export against the rules of Moodle's XML, STACK's and CodeRunner's, as their documentation has them.
#include <set>

#include <catch2/catch.hpp>

#include "learn_run.hpp"
#include "xml_reader.hpp"

using Catch::Contains;

namespace {

void check_every_question(const XmlElement& question) {
  CHECK_FALSE(question.text_in("name").empty());
  CHECK(question.one("questiontext").attributes.at("format") == "html");
  CHECK_FALSE(question.text_in("questiontext").empty());
  CHECK(question.one("generalfeedback").attributes.at("format") == "html");
  CHECK(std::stod(question.one("defaultgrade").text) > 0);
  CHECK(question.one("hidden").text == "0");
}

/// Each node is reached, each way leads to a node or ends, and one right end exists.
void check_tree(const XmlElement& tree) {
  const auto nodes = tree.all("node");
  REQUIRE_FALSE(nodes.empty());
  std::set<std::string> names{"-1"};
  std::set<std::string> reached{"0", "-1"};
  for (const XmlElement* node : nodes) {
    CHECK(names.insert(node->one("name").text).second);
    reached.insert(node->one("truenextnode").text);
    reached.insert(node->one("falsenextnode").text);
    CHECK(node->one("answertest").text == "AlgEquiv");
    CHECK_FALSE(node->one("sans").text.empty());
    CHECK_FALSE(node->one("tans").text.empty());
    for (const char* score : {"truescore", "falsescore"}) {
      const double value = std::stod(node->one(score).text);
      CHECK((value == 0 || value == 1));
    }
  }
  CHECK(reached == names);
  CHECK(nodes.front()->one("truescore").text == "1");
}

void check_stack(const XmlElement& question) {
  CHECK_THAT(question.text_in("questiontext"),
             Contains("[[input:ans1]]") && Contains("[[validation:ans1]]"));
  CHECK(question.text_in("specificfeedback") == "[[feedback:prt1]]");
  CHECK_THAT(question.text_in("questionvariables"),
             Catch::StartsWith("ta:") && Catch::EndsWith(";"));
  CHECK_THAT(question.one("prt").text_in("feedbackvariables"), Catch::StartsWith("sa1:"));
  const XmlElement& input = question.one("input");
  CHECK(input.one("name").text == "ans1");
  CHECK((input.one("type").text == "algebraic" || input.one("type").text == "matrix"));
  CHECK(input.one("tans").text == "ta");
  check_tree(question.one("prt"));
}

void check_coderunner(const XmlElement& question) {
  CHECK(question.one("coderunnertype").text == "cpp_program");
  CHECK_THAT(question.one("template").text, Contains("{{ STUDENT_ANSWER }}"));
  CHECK_FALSE(question.one("answer").text.empty());
  const auto cases = question.one("testcases").all("testcase");
  REQUIRE_FALSE(cases.empty());
  for (const XmlElement* one : cases) {
    CHECK(std::stod(one->attributes.at("mark")) > 0);
    CHECK_FALSE(one->text_in("stdin").empty());
    CHECK_FALSE(one->text_in("expected").empty());
    CHECK(one->text_in("display") == "SHOW");
  }
}

void check_answers(const XmlElement& question) {
  int right = 0;
  for (const XmlElement* answer : question.all("answer")) {
    const std::string& fraction = answer->attributes.at("fraction");
    CHECK((fraction == "100" || fraction == "0"));
    right += fraction == "100" ? 1 : 0;
    CHECK_FALSE(answer->one("text").text.empty());
    if (question.attributes.at("type") == "numerical")
      CHECK_NOTHROW(std::stod(answer->one("text").text));
  }
  CHECK(right == 1);
}

void check_quiz(const XmlElement& quiz) {
  CHECK(quiz.name == "quiz");
  for (const XmlElement* question : quiz.all("question")) {
    const std::string& type = question->attributes.at("type");
    if (type == "category") {
      CHECK_THAT(question->text_in("category"), Catch::StartsWith("$course$/top/"));
      continue;
    }
    INFO(question->text_in("name"));
    check_every_question(*question);
    if (type == "stack")
      check_stack(*question);
    else if (type == "coderunner")
      check_coderunner(*question);
    else
      check_answers(*question);
  }
}

}  // namespace

TEST_CASE("the export is a quiz that keeps the formats' rules", "[exam]") {
  const ProgramRun run = run_program({"learn", "export", "--format", "moodle"});
  REQUIRE(run.exit_code == 0);
  const XmlElement quiz = read_xml(run.output);
  check_quiz(quiz);
  std::map<std::string, int> count;
  for (const XmlElement* question : quiz.all("question")) ++count[question->attributes.at("type")];
  CHECK(count["category"] == 13);
  CHECK(count["stack"] >= 20);
  CHECK(count["coderunner"] >= 5);
  CHECK(count["numerical"] >= 3);
  CHECK(count["multichoice"] >= 3);
}

TEST_CASE("one exercise, and another seed, can be exported", "[exam]") {
  const auto exported = [](const std::string& seed) {
    return run_program({"learn", "export", "exact_speeds", "--seed", seed, "--format", "moodle"})
        .output;
  };
  const XmlElement quiz = read_xml(exported("0"));
  CHECK(quiz.all("question").size() == 2);
  CHECK(exported("0") != exported("1"));
}

TEST_CASE("the reader of the test refuses what is no XML", "[exam]") {
  CHECK_THROWS(read_xml("<a><b></a></b>"));
  CHECK_THROWS(read_xml("<a>&nbsp;</a>"));
  CHECK_THROWS(read_xml("<a>"));
  CHECK_THROWS(read_xml("<a></a><b></b>"));
  CHECK(read_xml("<a x=\"1\">&lt;<b>2</b></a>").text == "<");
}

TEST_CASE("an export is no student's: it looks at no progress, and its variant is the seed's",
          "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "progress.txt", "of something else\n");
  const std::vector<std::string> there{"env", "-C", folder.path().string()};
  const ProgramRun plain = run_program({"learn", "export", "--format", "moodle"}, "", there);
  CHECK(plain.exit_code == 0);
  CHECK(plain.output == run_program({"learn", "export", "--format", "moodle"}).output);
  CHECK(plain.output !=
        run_program({"learn", "export", "--format", "moodle", "--seed", "1"}).output);
}
