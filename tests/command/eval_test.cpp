// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdlib>
#include <random>
#include <string>

#include <catch2/catch.hpp>
#include <cln/cln.h>

#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "program_run.hpp"

namespace reference = magicmass::reference;

TEST_CASE("the start shows no negative zero", "[exam]") {
  const ProgramRun start = run_program({"eval", "--alpha", "0.1", "--n", "0", "--format", "csv"});
  CHECK(start.exit_code == 0);
  CHECK(lines_of(start.output).at(1) == "0.1,0,fast,1,0,0,0");
}

TEST_CASE("exact velocities at 1/7", "[exam]") {
  const nlohmann::json v = json_of({"eval", "--alpha", "1/7", "--n", "2", "--tier", "exact"});
  CHECK(v == nlohmann::json::parse(
                 R"({"alpha": "1/7", "n": 2, "tier": "exact", "a": "15/64", "b": "231/256",
                                       "c": "147/64", "c_prime": "-245/256"})"));
}

TEST_CASE("exact velocities are those of stepping the collisions", "[check]") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> part(1, 40);
  std::string table = "alpha,n\n";
  std::vector<magicmass::BodyVelocities<cln::cl_RA>> expected;  // a, b, and c' in c
  std::vector<cln::cl_RA> expected_c;
  while (expected.size() < 300) {
    const cln::cl_RA alpha = cln::cl_RA(part(random)) / part(random);
    cln::cl_RA a = 1;
    cln::cl_RA c = 0;
    for (const auto& event : magicmass::record_three_body(alpha).events) {
      if (event.body == magicmass::Body::A) {
        a = event.after.a;
        c = event.after.c;
        continue;
      }
      table += reference::to_text(cln::numerator(alpha)) + "/" +
               reference::to_text(cln::denominator(alpha)) + "," + std::to_string(event.n) + "\n";
      expected.push_back({a, event.after.b, event.after.c});
      expected_c.push_back(c);
    }
  }
  const ProgramRun run =
      run_program({"eval", "--input", "-", "--tier", "exact", "--format", "json"}, table);
  REQUIRE(run.exit_code == 0);
  const nlohmann::json rows = nlohmann::json::parse(run.output);
  REQUIRE(rows.size() == expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    INFO(rows[i]);
    CHECK(rows[i].at("a") == reference::to_text(expected[i].a));
    CHECK(rows[i].at("b") == reference::to_text(expected[i].b));
    CHECK(rows[i].at("c") == reference::to_text(expected_c[i]));
    CHECK(rows[i].at("c_prime") == reference::to_text(expected[i].c));
  }
}

TEST_CASE("many answers are a table where 80 columns are enough for it, else one below the other",
          "[exam]") {
  const std::string table = "alpha,n\n1/7,2\n1/7,3\n";
  const std::vector<std::string> rows =
      lines_of(run_program({"eval", "--input", "-", "--tier", "exact"}, table).output);
  REQUIRE(rows.size() == 3);
  for (const std::string n : {"2", "3"}) {
    const nlohmann::json v = json_of({"eval", "--alpha", "1/7", "--n", n, "--tier", "exact"});
    const std::string& row = rows[n == "2" ? 1 : 2];
    CHECK(row.size() <= 80);
    for (const char* column : {"a", "b", "c", "c_prime"}) {
      const std::string value = v.at(column);
      const std::size_t place = (rows[0] + " ").find(" " + std::string(column) + " ") + 1;
      CHECK(row.substr(place - 2, value.size() + 2) == "  " + value);
    }
  }
  const std::vector<std::string> wide =
      lines_of(run_program({"eval", "--input", "-", "--digits", "30"}, table).output);
  REQUIRE(wide.size() == 15);
  CHECK(wide[0] == "alpha    1/7");
  CHECK(wide[7].empty());
  CHECK(wide[8] == "alpha    1/7");
  CHECK(wide[9] == "n        3");
}

TEST_CASE("digits are those of the exact fraction", "[exam]") {
  const nlohmann::json v = json_of({"eval", "--alpha", "1/7", "--n", "2", "--digits", "12"});
  CHECK(v.at("tier") == "exact");
  CHECK(v.at("a") == "0.234375000000");
  CHECK(v.at("b") == "0.902343750000");
}

TEST_CASE("at a magic ratio the zeros and the one are exact", "[exam]") {
  const nlohmann::json v = json_of({"eval", "--alpha", "magic:3", "--n", "3", "--tier", "exact"});
  CHECK(v.at("a") == "0");
  CHECK(v.at("b") == "1");
  CHECK(v.at("c_prime") == "0");
  // 2/(1 + alpha_3) = 2 cos(pi/7), the larger root of x^3 - x^2 - 2 x + 1
  CHECK(v.at("c") == "1.80193773580483825247220463901");
}

TEST_CASE("n may be larger than 64 bits", "[exam]") {
  const std::string n = "5000000000000000000000000000000000000000000000000000000000000";
  const ProgramRun run =
      run_program({"eval", "--alpha", "1e-200", "--n", n, "--digits", "20", "--format", "json"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("\"n\": " + n + ",") != std::string::npos);
  const ProgramRun fast = run_program({"eval", "--alpha", "1e-200", "--n", n});
  CHECK(fast.exit_code == 3);
  CHECK(lines_of(fast.errors).size() == 1);
}

TEST_CASE("fractions too long to print are refused with advice", "[exam]") {
  const ProgramRun run =
      run_program({"eval", "--alpha", "1/1000000000001", "--n", "1000000", "--tier", "exact"});
  CHECK(run.exit_code == 3);
  CHECK(run.output.empty());
  CHECK(run.errors.find("--digits") != std::string::npos);
}

TEST_CASE("fast doubles are within 4 eps of the exact velocities", "[exam]") {
  const nlohmann::json v = json_of({"eval", "--alpha", "0.12", "--n", "2"});
  const nlohmann::json exact = json_of({"eval", "--alpha", "0.12", "--n", "2", "--digits", "25"});
  CHECK(v.at("tier") == "fast");
  // The promise of tier fast is 4 eps times the body's largest velocity; here all are below 4.
  for (const char* name : {"a", "b", "c", "c_prime"})
    CHECK(std::abs(v.at(name).get<double>() - std::stod(exact.at(name).get<std::string>())) <=
          16 * 2.3e-16);
}

TEST_CASE("tier accurate gives the doubles next to the certified digits, tier fast stays near",
          "[exam]") {
  const auto next_to = [](const nlohmann::json& digits) {
    return std::strtod(digits.get<std::string>().c_str(), nullptr);  // stod refuses subnormals
  };
  const auto compare = [&](const std::vector<std::string>& arguments,
                           const std::vector<std::string>& names, bool fast_too) {
    const auto with = [&](const char* option, const char* value) {
      std::vector<std::string> all = arguments;
      all.insert(all.end(), {option, value});
      return json_of(all);
    };
    const nlohmann::json exact = with("--digits", "40"), accurate = with("--tier", "accurate");
    const nlohmann::json fast = with("--tier", "fast");
    for (const std::string& name : names) {
      INFO(arguments[2] << " " << name);
      const double nearest = next_to(exact.at(name));
      CHECK(accurate.at(name).get<double>() == nearest);
      if (fast_too)  // inputs whose rounding costs less than an ulp
        CHECK_THAT(fast.at(name).get<double>(), Catch::Matchers::WithinULP(nearest, 2));
    }
  };
  const std::vector<std::string> velocities{"a", "b", "c", "c_prime"};
  const std::vector<std::string> last{"a_t", "b_t", "c_t", "rho"};
  const auto eval = [](const char* alpha, const char* n) {
    return std::vector<std::string>{"eval", "--alpha", alpha, "--n", n};
  };
  const auto terminal = [](const char* alpha) {
    return std::vector<std::string>{"terminal", "--alpha", alpha};
  };
  compare(eval("0.12", "2"), velocities, false);
  compare(eval("1e308", "1"), velocities, true);
  compare(eval("1e-308", "3"), velocities, true);
  compare(eval("0x1.1c7397cb68b7ep-18", "539"), velocities, false);  // closest to its threshold
  compare(eval("1/7", "2"), velocities, false);                      // at 1/7, which is no double
  compare(eval("magic:3", "3"), velocities, false);
  compare(terminal("3"), last, true);
  compare(terminal("1e17"), last, true);
  compare(terminal("1e-10"), last, false);
  compare(terminal("1/300"), last, false);
  compare(terminal("deficient:7"), last, false);
}

TEST_CASE("where Q_n does not happen a note says so, on stderr", "[exam]") {
  const ProgramRun run = run_program({"eval", "--alpha", "0.1", "--n", "4"});
  CHECK(run.exit_code == 0);
  CHECK(run.errors.find("note") != std::string::npos);
  CHECK(run_program({"eval", "--alpha", "0.1", "--n", "3"}).errors.empty());
}
