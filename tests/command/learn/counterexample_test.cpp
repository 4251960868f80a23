// SPDX-License-Identifier: GPL-2.0-or-later
// What a student is shown against a wrong answer is true: an oracle that shares nothing with the program says so.
#include <cmath>
#include <filesystem>
#include <regex>
#include <stdexcept>

#include <catch2/catch.hpp>
#include <toml++/toml.h>

#include "learn_run.hpp"
#include "typed_oracle.hpp"

namespace {

namespace fs = std::filesystem;

long double shown_number(const std::string& shown) {  // "2", "-1/2", "0.866025..."
  const std::size_t line = shown.find('/');
  if (line != std::string::npos)
    return std::stold(shown.substr(0, line)) / std::stold(shown.substr(line + 1));
  return std::stold(shown);
}

bool agrees(long double value, const std::string& shown) {
  return std::abs(value - shown_number(shown)) <= 1e-5L * (1 + std::abs(value));
}

/// Row and column of a typed matrix, or all of an expression.
std::string entry(const std::string& typed, std::size_t row, std::size_t column) {
  const std::regex rows(R"(\[([^\[\]]*)\])");
  std::sregex_iterator found(typed.begin(), typed.end(), rows);
  std::advance(found, static_cast<long>(row) - 1);
  std::string cells = (*found)[1].str();
  for (; column > 1; --column) cells = cells.substr(cells.find(',') + 1);
  return cells.substr(0, cells.find(','));
}

struct Claim {
  std::string answer, solution, feedback;
};

/// Empty where the claim is true, and no point is simpler; else what is wrong with it.
std::string complaint(Claim claim) {
  std::smatch match;
  const std::regex place(R"(Row (\d+), column (\d+): )");
  if (std::regex_search(claim.feedback, match, place)) {
    const std::size_t row = std::stoul(match[1]);
    const std::size_t column = std::stoul(match[2]);
    claim.answer = entry(claim.answer, row, column);
    claim.solution = entry(claim.solution, row, column);
  }
  const std::regex constant(R"(Yours is (\S+), which is too (large|small))");
  if (std::regex_search(claim.feedback, match, constant)) {
    const long double yours = oracle_value(claim.answer, {});
    const bool is_large = yours > oracle_value(claim.solution, {});
    if (!agrees(yours, match[1])) return "the answer is another number";
    return is_large == (match[2] == "large") ? "" : "too " + match[2].str() + " is not so";
  }
  const std::regex at(R"([Aa]t (.+?) yours is (\S+), where it should be (\S+?)(?:\.(?: |$)|$))");
  if (!std::regex_search(claim.feedback, match, at)) return "no counterexample";
  Point point;
  Point simplest;
  const std::string assignments = match[1];
  const std::regex one(R"((\w+) = ([-\d./]+))");
  for (std::sregex_iterator i(assignments.begin(), assignments.end(), one), end; i != end; ++i) {
    point[(*i)[1]] = shown_number((*i)[2]);
    simplest[(*i)[1]] = 1;
  }
  const long double yours = oracle_value(claim.answer, point);
  const long double ours = oracle_value(claim.solution, point);
  if (!agrees(yours, match[2])) return "the answer has another value there";
  if (!agrees(ours, match[3])) return "the solution has another value there";
  if (std::abs(yours - ours) < 1e-6L) return "both have the same value there";
  const long double apart =
      oracle_value(claim.answer, simplest) - oracle_value(claim.solution, simplest);
  if (point != simplest && std::isfinite(apart) && std::abs(apart) > 1e-6L)
    return "where all is 1 they differ already";
  return {};
}

std::string last_line(const fs::path& file) {
  std::string last;
  for (const std::string& line : lines_of(read_file(file)))
    if (!line.empty() && line.front() != '#') last = line;
  return last;
}

}  // namespace

TEST_CASE("every counterexample to a wrong answer is true, and none is simpler", "[exam]") {
  const Student student;
  int confirmed = 0;
  for (const auto& file : fs::recursive_directory_iterator(MAGICMASS_SOURCE_DIR "/tutorials")) {
    if (file.path().filename() != "exercise.toml") continue;
    const toml::table exercise = toml::parse_file(file.path().string());
    const std::string shape = exercise["shape"].value_or("expression");
    if (exercise["kind"].value_or("") != std::string("symbolic") ||
        (shape != "expression" && shape != "matrix") || exercise.contains("variants"))
      continue;
    const std::string solution = last_line(file.path().parent_path() / "solution" / "answer.txt");
    for (const toml::node& wrong : *exercise["wrong"].as_array()) {
      const std::string answer = wrong.value_or("");
      const nlohmann::json verdict = student.check(exercise["id"].value_or(""), answer);
      const std::string feedback = verdict.at("feedback");
      if (verdict.at("verdict") != "wrong" || !verdict.at("misconception").is_null() ||
          feedback.find("ours is ") == std::string::npos ||
          feedback.find("minus") != std::string::npos)
        continue;
      INFO(exercise["id"].value_or("") << ": " << answer << ": " << feedback);
      CHECK(complaint({answer, solution, feedback}).empty());
      ++confirmed;
    }
  }
  CHECK(confirmed >= 60);
}

TEST_CASE("the oracle of the counterexamples refuses false ones", "[exam]") {
  const std::string rest = " A hint: none.";
  const auto said = [&](const std::string& feedback) {
    return complaint({"1+alpha", "1/(1+alpha)", "Not right. " + feedback + rest});
  };
  CHECK(said("At alpha = 1 yours is 2, where it should be 1/2.").empty());
  CHECK(said("At alpha = 1 yours is 3, where it should be 1/2.") ==
        "the answer has another value there");
  CHECK(said("At alpha = 1 yours is 2, where it should be 1/3.") ==
        "the solution has another value there");
  CHECK(said("At alpha = 0 yours is 1, where it should be 1.") == "both have the same value there");
  CHECK(said("At alpha = 2 yours is 3, where it should be 1/3.") ==
        "where all is 1 they differ already");
  CHECK(complaint({"1/4", "sqrt(5) - 2", "Yours is 1/4, which is too large."}).empty());
  CHECK_FALSE(complaint({"1/4", "sqrt(5) - 2", "Yours is 1/4, which is too small."}).empty());
  CHECK(complaint({"[[1],[1]]", "[[1],[sqrt(alpha)]]",
                   "Row 2, column 1: at alpha = 2 yours is 1, where it should be 1.414213..."})
            .empty());
  CHECK_THROWS(oracle_value("1+gamma", {}));
}
