// SPDX-License-Identifier: GPL-2.0-or-later
#include "refusal.hpp"

#include <catch2/catch.hpp>

void check_refused(const ProgramRun& run, const std::string& part_of_message) {
  CAPTURE(run.errors, part_of_message);
  CHECK(run.exit_code == 2);
  CHECK(run.output.empty());
  CHECK(lines_of(run.errors).size() == 1);
  CHECK(run.errors.starts_with("magicmass: "));
  CHECK(run.errors.find(part_of_message) != std::string::npos);
}
