// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

namespace {

/// count reading this CSV text from a file called rows.csv.
ProgramRun count(const std::string& table) {
  const TemporaryFolder folder;
  write_file(folder / "rows.csv", table);
  return run_program({"count", "--input", folder / "rows.csv", "--format", "csv"});
}

void check_table_refused(const std::string& table, const std::string& part_of_message) {
  INFO(table);
  check_refused(count(table), part_of_message);
}

}  // namespace

TEST_CASE("answers come in the order of the rows", "[exam]") {
  CHECK(count("alpha\n0.1\nmagic:3\n1/7\n1\n0.1\n").output ==
        "alpha,N_A,N_B\n0.1,4,3\nmagic:3,3,3\n1/7,3,3\n1,1,1\n0.1,4,3\n");
}

TEST_CASE("quotes, CRLF, blanks, a byte-order mark and empty last lines are understood", "[exam]") {
  const std::string expected = "alpha,N_A,N_B\n0.1,4,3\n0.12,3,3\n";
  CHECK(count("alpha\r\n0.1\r\n0.12\r\n").output == expected);
  CHECK(count("alpha\n\"0.1\"\n \"0.12\" ").output == expected);
  CHECK(count("\"alpha\"\n 0.1\t\n0.12\n\n\n").output == expected);
  CHECK(count("\xef\xbb\xbf"
              "alpha\n0.1\n0.12")
            .output == expected);
  CHECK(count("alpha\n").output == "alpha,N_A,N_B\n");
}

TEST_CASE("malformed CSV is refused with file, line and column", "[exam]") {
  check_table_refused("", "rows.csv:1: ");
  check_table_refused("0.1\n0.2\n",
                      "rows.csv:1: the first line must name the columns, got 0.1; allowed: alpha");
  check_table_refused("Alpha\n0.1\n", "rows.csv:1: ");
  check_table_refused("\"alpha,n\"\n0.1\n",
                      "rows.csv:1: the column \"alpha,n\" has a comma in its name");
  check_table_refused("alpha,n\n0.1,1\n", "rows.csv:1: ");
  check_table_refused("alpha\n0.1\n0.2,3\n", "rows.csv:3: 2 fields where the header names 1");
  check_table_refused("alpha\n0.1\n\n0.2\n", "rows.csv:3: alpha: empty");
  check_table_refused("alpha\n\"0.1\n", "rows.csv:2: a quoted field has no closing quote");
  check_table_refused("alpha\n\"0.1\"x\n", "rows.csv:2: something follows a quoted field");
  check_table_refused("alpha\n0.1\n-1\n",
                      "rows.csv:3: alpha must be a positive finite number, got -1");
  check_table_refused("alpha\n0.1\nabc\n", "rows.csv:3: alpha is not a number");
  check_table_refused(std::string("alpha\n0.1\0\n", 11), "rows.csv:2: alpha is not a number");
}

TEST_CASE("n comes from its column, or from --n", "[exam]") {
  const std::string expected =
      "alpha,n,tier,a,b,c,c_prime\n1/7,2,exact,15/64,231/256,147/64,-245/256\n";
  const std::vector<std::string> exact = {"eval",  "--input",  "-",  "--tier",
                                          "exact", "--format", "csv"};
  CHECK(run_program(exact, "alpha,n\n1/7,2\n").output == expected);
  std::vector<std::string> with_n = exact;
  with_n.insert(with_n.end(), {"--n", "2"});
  CHECK(run_program(with_n, "alpha\n1/7\n").output == expected);
  CHECK(run_program(exact, "alpha\n1/7\n").exit_code == 2);
  CHECK(run_program(with_n, "alpha,n\n1/7,2\n").exit_code == 2);
  const ProgramRun beyond = run_program(exact, "alpha,n\n1/7,2\n1/7,9\n");
  CHECK(beyond.exit_code == 2);
  CHECK(beyond.output.empty());
  CHECK(beyond.errors.find("stdin:3: n = 9 is beyond the last collision") != std::string::npos);
  const ProgramRun missing = run_program(exact, "alpha,n\n1/7\n");
  CHECK(missing.errors.find("stdin:2: n: missing") != std::string::npos);
}

TEST_CASE("many rows make a JSON array, one alpha an object", "[exam]") {
  const ProgramRun run = run_program({"count", "--input", "-", "--format", "json"}, "alpha\n0.1\n");
  CHECK(nlohmann::json::parse(run.output) ==
        nlohmann::json::parse(R"([{"alpha": 0.1, "N_A": 4, "N_B": 3}])"));
  CHECK(json_of({"count", "--alpha", "0.1"}).is_object());
  CHECK(nlohmann::json::parse(
            run_program({"count", "--input", "-", "--format", "json"}, "alpha\n").output) ==
        nlohmann::json::array());
}
