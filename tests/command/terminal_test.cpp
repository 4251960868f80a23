// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <cln/cln.h>

#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "program_run.hpp"

namespace reference = magicmass::reference;

TEST_CASE("exact terminal velocities are those of the exact simulator", "[check]") {
  for (const int p : {1, 2, 3, 5, 8, 13, 21}) {
    const cln::cl_RA alpha = cln::cl_RA(p) / 30;
    const auto run = magicmass::record_three_body(alpha).run;
    const nlohmann::json v =
        json_of({"terminal", "--alpha", std::to_string(p) + "/30", "--tier", "exact"});
    INFO(v);
    CHECK(v.at("N_A") == run.counts.N_A);
    CHECK(v.at("N_B") == run.counts.N_B);
    CHECK(v.at("a_t") == reference::to_text(run.terminal.a));
    CHECK(v.at("b_t") == reference::to_text(run.terminal.b));
    CHECK(v.at("c_t") == reference::to_text(run.terminal.c));
    CHECK(v.at("rho") == reference::to_text(run.terminal.b * run.terminal.b));
  }
}

TEST_CASE("digits of the terminal velocities are those of the fractions", "[exam]") {
  const nlohmann::json v = json_of({"terminal", "--alpha", "1/7", "--digits", "8"});
  CHECK(v.at("a_t") == "-0.063476562");  // -65/1024 = -0.0634765625: ties go to even
  CHECK(v.at("b_t") == "0.95874023");    // 3927/4096
  CHECK(v.at("rho") == "0.91918284");    // 15421329/16777216 = 0.919182836...
}

TEST_CASE("at a magic ratio B gets everything", "[exam]") {
  const nlohmann::json v = json_of({"terminal", "--alpha", "magic:5", "--tier", "exact"});
  CHECK(v.at("a_t") == "0");
  CHECK(v.at("b_t") == "1");
  CHECK(v.at("c_t") == "0");
  CHECK(v.at("rho") == "1");
  CHECK(std::abs(json_of({"terminal", "--alpha", "magic:5"}).at("rho").get<double>() - 1.0) <
        1e-14);
}

TEST_CASE("at a deficient ratio C ends with the velocity of B", "[exam]") {
  const nlohmann::json v = json_of({"terminal", "--alpha", "deficient:4", "--digits", "40"});
  CHECK(v.at("N_A") == 5);
  CHECK(v.at("N_B") == 4);
  CHECK(v.at("b_t") == v.at("c_t"));
}

TEST_CASE("restitution 1, however it is written, answers as none does", "[exam]") {
  const std::string plain = run_program({"terminal", "--alpha", "0.1", "--format", "json"}).output;
  for (const char* one : {"1", "1.0", "3/3", "0x1p0"})
    CHECK(run_program({"terminal", "--alpha", "0.1", "--restitution", one, "--format", "json"})
              .output == plain);
}

TEST_CASE("with restitution the numbers are those of stepping in rationals", "[check]") {
  for (const int p : {1, 2, 3, 5, 8, 13, 21, 400})
    for (const int q : {3, 7, 9, 10}) {
      const cln::cl_RA alpha = cln::cl_RA(p) / 30, e = cln::cl_RA(q) / 11;
      cln::cl_RA a = 1, b = 0, c = 0;
      int collisions = 0;
      for (; collisions < 60; ++collisions) {  // typed from the restitution law
        cln::cl_RA& block = collisions % 2 == 0 ? a : b;
        if (!cln::plusp(collisions % 2 == 0 ? a - c : c - b)) break;
        const cln::cl_RA to_ball = (1 + e) * (block - c) / (1 + alpha);
        block = block - alpha * to_ball;
        c = c + to_ball;
      }
      const nlohmann::json v = json_of({"terminal", "--alpha", std::to_string(p) + "/30",
                                        "--restitution", std::to_string(q) + "/11"});
      INFO(v);
      if (collisions == 60) {
        CHECK(v.at("status") == "collapse");
        for (const char* name : {"N_A", "N_B", "a_t", "b_t", "c_t", "rho"})
          CHECK(v.at(name).is_null());
        CHECK(v.at("t_collapse") > 1);
        continue;
      }
      CHECK(v.at("status") == "complete");
      CHECK(v.at("t_collapse").is_null());
      CHECK(v.at("N_A") == (collisions + 1) / 2);
      CHECK(v.at("N_B") == collisions / 2);
      // fractions are rounded to long double, so nothing but the last rounding is seen
      CHECK(reference::ulp_error(v.at("a_t").get<double>(), a) <= 1);
      CHECK(reference::ulp_error(v.at("b_t").get<double>(), b) <= 1);
      CHECK(reference::ulp_error(v.at("c_t").get<double>(), c) <= 1);
      CHECK(reference::ulp_error(v.at("rho").get<double>(), b * b) <= 1);
    }
}

TEST_CASE("a collapse is said in one line, at the border too", "[exam]") {
  const ProgramRun run =
      run_program({"terminal", "--alpha", "1/4", "--restitution", "1/4", "--format", "json"});
  CHECK(run.exit_code == 0);
  CHECK(lines_of(run.errors).size() == 1);
  CHECK(run.errors.find("collapse at t = 2 L/V") != std::string::npos);
  const nlohmann::json above =
      json_of({"terminal", "--alpha", "0x1.0000000000001p-2", "--restitution", "0.25"});
  CHECK(above.at("status") == "complete");
  CHECK(above.at("N_A") > 100000000);
  const ProgramRun rows =
      run_program({"terminal", "--input", "-", "--restitution", "0.2", "--format", "csv"},
                  "alpha\n0.1\n0.2\n3\n");
  CHECK(rows.errors.find("collapse in 2 rows") != std::string::npos);
  CHECK(lines_of(rows.output).size() == 4);
}

TEST_CASE(
    "a restitution that is not above 0, or above 1, and exact tiers with one below 1, are refused",
    "[exam]") {
  for (const char* e : {"0", "-0.5", "1.0000001", "2", "nan", "inf", "magic:3", "", "x", "1/0"}) {
    const ProgramRun run = run_program({"terminal", "--alpha", "0.1", "--restitution", e});
    INFO(e << ": " << run.errors);
    CHECK(run.exit_code == 2);
    CHECK(lines_of(run.errors).size() == 1);
    CHECK(run.errors.find("restitution") != std::string::npos);
  }
  CHECK(run_program({"terminal", "--alpha", "0.1", "--restitution", "0.9", "--tier", "exact"})
            .exit_code == 2);
}
