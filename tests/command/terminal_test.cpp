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

TEST_CASE("restitution other than 1 is refused honestly", "[exam]") {
  CHECK(run_program({"terminal", "--alpha", "0.1", "--restitution", "1"}).exit_code == 0);
  const ProgramRun run = run_program({"terminal", "--alpha", "0.1", "--restitution", "0.9"});
  CHECK(run.exit_code == 2);
  CHECK(run.errors.find("not derived yet") != std::string::npos);
}
