// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <chrono>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"

// Not gated on: a loaded machine may be slow.
TEST_CASE("magicmass help is there within a tenth of a second", "[time]") {
  std::vector<double> seconds;
  for (int i = 0; i < 11; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const ProgramRun help = run_program({"--help"});
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    REQUIRE(help.exit_code == 0);
    seconds.push_back(time.count());
  }
  std::sort(seconds.begin(), seconds.end());
  WARN("median " << seconds[5] << " s, least " << seconds[0] << " s");
  CHECK(seconds[5] < 0.1);
}
