// SPDX-License-Identifier: GPL-2.0-or-later
#include <chrono>
#include <cstddef>

#include <catch2/catch.hpp>
#include <sys/resource.h>

#include "program_run.hpp"

namespace {

ProgramRun equal(std::vector<std::string> arguments, const std::string& input = "") {
  arguments.insert(arguments.begin(), "equal");
  return run_program(arguments, input);
}

nlohmann::json json_of_equal(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--format", "json"});
  return nlohmann::json::parse(equal(std::move(arguments)).output);
}

std::string nested(const std::string& function, int times, const std::string& inside) {
  std::string text = inside;
  for (int i = 0; i < times; ++i) text.insert(0, function + "(").append(")");
  return text;
}

std::string joined(const std::string& before, int count, const std::string& after) {
  std::string text;
  for (int i = 1; i <= count; ++i)
    text += (text.empty() ? "" : "+") + before + std::to_string(i) + after;
  return text;
}

/// What a user might type to see the program on its knees: two sides each.
const std::vector<std::vector<std::string>>& hostile() {
  static const std::vector<std::vector<std::string>> questions{
      {"9^9^9^9", "1"},
      {std::string(50000, '('), "1"},
      {nested("sqrt", 1000, "2"), "1"},
      {nested("sqrt", 150, "2"), nested("sqrt", 149, "2")},
      {nested("sqrt", 90, "x"), nested("sqrt", 89, "x")},
      {"cos(pi/1000003)", "1"},
      {"cos(pi/1000003)^2+sin(pi/1000003)^2", "1"},
      {"cos(pi/10007)*cos(pi/10009)", "cos(pi/10009)*cos(pi/10007)+10^-99"},
      {"foo(2)", "1"},
      {"", "1"},
      {"\xff\xfe", "1"},
      {"1/0", "1"},
      {"2^(10^9)", "1"},
      {"(1+alpha)^100000", "1"},
      {"(1+alpha+x+y+z)^200", "(z+y+x+alpha+1)^199*(1+alpha+x+y+z)+x^9-x^9*1"},
      {"exp(exp(exp(exp(10))))", "1"},
      {"exp(exp(exp(exp(x))))", "exp(exp(exp(exp(x))))+1"},
      {joined("sqrt(", 300, ")"), joined("sqrt(", 300, ")") + "+0*x"},
      {joined("cos(pi/", 60, ")"), joined("cos(pi/", 60, ")") + "+10^-500"},
      {joined("atan(1/", 200, ")"), joined("atan(1/", 200, ")") + "+0*x"},
      {nested("tan", 90, "x"), nested("tan", 90, "2*x/2")},
      {nested("atan", 60, "x"), nested("atan", 60, "x+1-1")},
      {nested("asin", 60, "x"), nested("asin", 60, "(x^2+x)/(x+1)")},
      {joined("sqrt(1+x^", 100, ")"), joined("sqrt(1+x^", 100, ")") + "+x-x"},
      {joined("1/(x+", 400, ")"), joined("1/(x+", 400, ")") + "+sin(x)^2+cos(x)^2-1"},
      {"cos(x)^200+sin(x)^200", "1"},
      {"n^n^n^n", "n^(n^(n^n))+0"},
      {"root(2, 97)*root(3, 97)", "root(6, 97)"},
      {"sin(n*pi/999983)", "sin(n*pi/999983+2*pi)"},
      {"0." + std::string(19000, '3'), "1/3"},
  };
  return questions;
}

}  // namespace

TEST_CASE("equal answers in the exit code and in words", "[exam]") {
  const ProgramRun same = equal({"sec(pi/5)-1", "sqrt(5)-2"});
  CHECK(same.exit_code == 0);
  CHECK_THAT(same.output, Catch::StartsWith("equal\n"));
  CHECK_THAT(same.output, Catch::Contains("proof"));
  const ProgramRun other = equal({"sqrt(x^2)", "x"});
  CHECK(other.exit_code == 1);
  CHECK_THAT(other.output, Catch::StartsWith("different\n") && Catch::Contains("x = -1"));
  const ProgramRun open = equal({"log(exp(x))", "x"});
  CHECK(open.exit_code == 3);
  CHECK_THAT(open.output, Catch::StartsWith("undecided\n") && Catch::Contains("digits"));
  for (const ProgramRun* run : {&same, &other, &open})
    for (const std::string& line : lines_of(run->output)) CHECK(line.size() <= 80);
}

TEST_CASE("equal prints JSON with the fields that others rely on", "[exam]") {
  const nlohmann::json same = json_of_equal({"(alpha^2-1)/(alpha-1)", "alpha+1"});
  CHECK(same.at("verdict") == "equal");
  CHECK(same.at("counterexample").is_null());
  CHECK(same.at("conditions") == nlohmann::json{"alpha - 1 != 0"});
  CHECK(same.at("domain") == nlohmann::json{"alpha > 0"});
  const nlohmann::json other = json_of_equal({"alpha*V", "alpha+V", "--domain", "V>=3, alpha>1"});
  CHECK(other.at("verdict") == "different");
  CHECK(other.at("counterexample").at("at").at("V") == "3");
  CHECK(other.at("counterexample").at("left") == "6");
  CHECK(other.at("counterexample").at("right") == "5");
  const nlohmann::json open = json_of_equal({"log(exp(x))", "x"});
  CHECK(open.at("verdict") == "undecided");
  CHECK(open.at("agreeing_digits") > 60);
}

TEST_CASE("an expression may begin with a minus, or come from stdin", "[exam]") {
  CHECK(equal({"-x", "-(2*x)/2"}).exit_code == 0);
  CHECK(equal({"atan(x)+atan(1/x)", "-pi/2", "--domain", "-9<x<0"}).exit_code == 0);
  CHECK(equal({"-", "x+1"}, "1 + x\n").exit_code == 0);
  CHECK(equal({"x+1", "-"}, "2 + x\n").exit_code == 1);
  CHECK(equal({"-", "-"}, "1").exit_code == 2);
}

TEST_CASE("what is no question is refused in one line", "[exam]") {
  for (const std::vector<std::string>& bad :
       std::vector<std::vector<std::string>>{{"1"},
                                             {"1", "2", "3"},
                                             {"1", "("},
                                             {"x", "x", "--domain", "y>0"},
                                             {"x", "x", "--domain", "x>1", "--domain", "x<0"},
                                             {"x", "x", "--format", "csv"},
                                             {"sqrt(-1)", "1"}}) {
    const ProgramRun run = equal(bad);
    CHECK(run.exit_code == 2);
    CHECK(run.output.empty());
    CHECK(lines_of(run.errors).size() == 1);
  }
  CHECK(equal({"-", "1"}, std::string("1\0+1", 4)).exit_code == 2);
}

TEST_CASE("hostile input is answered or refused", "[exam]") {
  for (const std::vector<std::string>& question : hostile()) {
    INFO(question[0].substr(0, 60) << " and " << question[1].substr(0, 60));
    const ProgramRun run = equal(question);
    INFO(run.output << run.errors);
    CHECK(run.exit_code >= 0);
    CHECK(run.exit_code <= 3);
    CHECK(lines_of(run.output + run.errors).size() < 40);
  }
  CHECK(equal({"-", "1"}, std::string(10'000'000, '1')).exit_code == 2);
  CHECK(equal({"-", "1"}, std::string(1'000'000, '(')).exit_code == 2);
}

TEST_CASE("every answer comes within two seconds and 512 MiB", "[time]") {
  for (const std::vector<std::string>& question : hostile()) {
    INFO(question[0].substr(0, 60) << " and " << question[1].substr(0, 60));
    const auto start = std::chrono::steady_clock::now();
    equal(question);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
  }
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);  // the largest of all children
  CHECK(usage.ru_maxrss < 512 * 1024);
}
