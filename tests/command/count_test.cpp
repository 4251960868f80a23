// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"

TEST_CASE("count prints integers of any size, unquoted", "[exam]") {
  const ProgramRun run = run_program({"count", "--alpha", "1e-200", "--format", "json"});
  CHECK(run.exit_code == 0);
  // pi/sqrt(8e-200) = 1.1107...e100: pi/sqrt 8 = 1.110720734539591...
  CHECK(run.output.starts_with("{\"alpha\": 1e-200, \"N_A\": 11107207345395915"));
  const std::size_t begin = run.output.find("\"N_A\": ") + 7;
  const std::size_t end = run.output.find(',', begin);
  CHECK(end - begin == 101);
  CHECK(run.output.substr(begin, end - begin).find_first_not_of("0123456789") == std::string::npos);
  CHECK(nlohmann::json::accept(run.output));
}

TEST_CASE("thresholds are counted exactly", "[exam]") {
  const auto counts = [](const std::string& alpha) {
    const nlohmann::json answer = json_of({"count", "--alpha", alpha});
    return std::pair(answer.at("N_A").get<std::int64_t>(), answer.at("N_B").get<std::int64_t>());
  };
  CHECK(counts("1") == std::pair<std::int64_t, std::int64_t>(1, 1));
  CHECK(counts("magic:1000000") == std::pair<std::int64_t, std::int64_t>(1000000, 1000000));
  CHECK(counts("deficient:7") == std::pair<std::int64_t, std::int64_t>(8, 7));
  CHECK(counts("1/7") == std::pair<std::int64_t, std::int64_t>(3, 3));
  CHECK(counts("0.12") == std::pair<std::int64_t, std::int64_t>(3, 3));
  CHECK(counts("0.1") == std::pair<std::int64_t, std::int64_t>(4, 3));
  // The doubles next to 1: alpha = 1 is the threshold from which on N_A = 1.
  CHECK(counts("0x1.fffffffffffffp-1") == std::pair<std::int64_t, std::int64_t>(2, 1));
  CHECK(counts("0x1.0000000000001p0") == std::pair<std::int64_t, std::int64_t>(1, 1));
}

TEST_CASE("alpha comes back as it was meant", "[exam]") {
  CHECK(json_of({"count", "--alpha", "0x1.8p-3"}).at("alpha") == 0.1875);
  CHECK(json_of({"count", "--alpha", "2/14"}).at("alpha") == "2/14");
  CHECK(json_of({"count", "--alpha", "magic:3"}).at("alpha") == "magic:3");
}

TEST_CASE("a near tie is told, with its threshold and the distance to it", "[exam]") {
  const auto asked = [](const std::string& alpha) {
    return json_of({"count", "--alpha", alpha, "--near-tie"});
  };
  const nlohmann::json closest = asked("0x1.1c7397cb68b7ep-18");
  CHECK(closest.at("near_tie") == true);
  CHECK(closest.at("threshold") == "magic:539");
  CHECK(std::abs(closest.at("distance").get<double>()) < 1e-19);  // not a double's eps away
  const nlohmann::json clear = asked("0.5");
  CHECK(clear.at("near_tie") == false);
  CHECK(clear.at("threshold") == "deficient:1");  // beta_1 = sqrt 2 - 1
  CHECK_THAT(clear.at("distance").get<double>(),
             Catch::Matchers::WithinRel(0.5 / (std::sqrt(2.0) - 1) - 1, 1e-14));
  CHECK(asked("deficient:7").at("distance") == 0.0);
  for (const char* one : {"1", "1/1", "magic:1"}) {  // the one threshold that is a double
    const nlohmann::json at = asked(one);
    CHECK(at.at("near_tie") == true);
    CHECK(at.at("threshold") == "magic:1");
    CHECK(at.at("distance") == 0.0);
  }
  CHECK(asked("1/2").at("distance") == clear.at("distance"));
  CHECK(asked("1/7").at("near_tie").is_null());
  CHECK_FALSE(json_of({"count", "--alpha", "0.5"}).contains("near_tie"));
}
