// SPDX-License-Identifier: GPL-2.0-or-later
// CodeRunner questions as a quiz server runs them: template and answer in one file, output against what is expected.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <catch2/catch.hpp>

#include "learn_run.hpp"
#include "xml_reader.hpp"

namespace {

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = 0; (at = text.find(part)) != std::string::npos;)
    text.erase(at, part.size());
  return text;
}

/// What Twig makes of the template.
std::string filled_template(const XmlElement& question, const std::string& answer) {
  std::string text =
      without(without(question.one("template").text, "{% verbatim %}"), "{% endverbatim %}");
  const std::string place = "{{ STUDENT_ANSWER }}";
  return text.replace(text.find(place), place.size(), answer);
}

bool is_compiled(const TemporaryFolder& folder, const std::string& program) {
  write_file(folder / "all.cpp", program);
  return std::system(("c++ -std=c++20 -w -o " + (folder / "all") + " " + (folder / "all.cpp") +
                      " 2>" + (folder / "errors"))
                         .c_str()) == 0;
}

/// How many cases come out as expected.
long passed(const TemporaryFolder& folder, const XmlElement& question) {
  long count = 0;
  for (const XmlElement* one : question.one("testcases").all("testcase")) {
    write_file(folder / "in", one->text_in("stdin"));
    if (std::system(((folder / "all") + " <" + (folder / "in") + " >" + (folder / "out") + " 2>&1")
                        .c_str()) != 0)
      continue;
    std::istringstream got(read_file(folder / "out"));
    std::istringstream expected(one->text_in("expected"));
    const std::vector<std::string> left{std::istream_iterator<std::string>(got), {}};
    const std::vector<std::string> right{std::istream_iterator<std::string>(expected), {}};
    count += left == right ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("exported code questions compile, pass with their answer and fail with the starter",
          "[exam]") {
  const ProgramRun run = run_program({"learn", "export", "--format", "moodle"});
  REQUIRE(run.exit_code == 0);
  const TemporaryFolder folder;
  int questions = 0;
  const XmlElement quiz = read_xml(run.output);
  for (const XmlElement* question : quiz.all("question")) {
    if (question->attributes.at("type") != "coderunner") continue;
    ++questions;
    const auto cases = static_cast<long>(question->one("testcases").all("testcase").size());
    INFO(question->text_in("name"));
    CHECK(is_compiled(folder, filled_template(*question, question->one("answer").text)));
    INFO(read_file(folder / "errors").substr(0, 500));
    CHECK(passed(folder, *question) == cases);
    CHECK(is_compiled(folder, filled_template(*question, question->one("answerpreload").text)));
    CHECK(passed(folder, *question) < cases);
  }
  CHECK(questions >= 10);
}
