// SPDX-License-Identifier: GPL-2.0-or-later
// What holds of every option's value, whichever command it is of.
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

TEST_CASE("a whole number is decimal, whatever zeros it begins with", "[exam]") {
  const std::string ten = run_program({"ratios", "--count", "10"}).output;
  CHECK(run_program({"ratios", "--count", "010"}).output == ten);
  CHECK(run_program({"ratios", "--count=0010"}).output == ten);
  CHECK(run_program({"eval", "--alpha", "0.1", "--n", "02"}).output ==
        run_program({"eval", "--alpha", "0.1", "--n", "2"}).output);
  const TemporaryFolder folder;
  const auto shown = [&](const std::string& seed) {
    return run_program(
        {"learn", "show", "light_ball", "--seed", seed, "--folder", folder / "mine"});
  };
  CHECK(shown("010").output == shown("10").output);
  check_refused(run_program({"ratios", "--count", "00"}), "--count");
  for (const char* other : {"0x", "0x10", "+010", " 010", "1e1"})
    check_refused(run_program({"ratios", "--count", other}), "--count");
}

TEST_CASE("with -o - the answer goes to stdout", "[exam]") {
  const TemporaryFolder folder;
  const std::string expected = run_program({"ratios", "--count", "2"}).output;
  CHECK_FALSE(expected.empty());
  CHECK(run_program({"ratios", "--count", "2", "-o", "-"}).output == expected);
  CHECK(run_program({"ratios", "--count", "2", "--output=-"}).output == expected);
  CHECK(run_program({"figure", "counts", "-o", "-"}).output.find("<svg") != std::string::npos);
  CHECK(run_program({"derive", "contact", "-o", "-"}).output ==
        run_program({"derive", "contact"}).output);
  check_refused(run_program({"generate", "--quantity", "a_t", "--out", folder / "x", "-o", "-"}),
                "two places");
  CHECK_FALSE(std::filesystem::exists("-"));
}

TEST_CASE("an option that is given no value takes none from the next word", "[exam]") {
  check_refused(run_program({"ratios", "--count=", "3"}), "--count= has no value");
  check_refused(run_program({"derive", "--from=", "power"}), "--from= has no value");
  check_refused(run_program({"ratios", "-o=", "3"}), "-o= is no option");
  CHECK(run_program({"equal", "x", "x", "--domain=x>=0"}).exit_code == 0);
}

TEST_CASE("no file, no folder and no result is called nothing", "[exam]") {
  check_refused(run_program({"count", "--alpha", "1", "-o", ""}), "--output: no file name");
  check_refused(run_program({"count", "--input", ""}), "--input: no file name");
  check_refused(run_program({"manual", "--man", ""}), "--man: no folder name");
  check_refused(run_program({"learn", "list", "--folder", ""}), "--folder: no folder name");
  check_refused(run_program({"derive", "--from", ""}), "--from: no name");
}

TEST_CASE("two files of one answer have two names", "[exam]") {
  const TemporaryFolder folder;
  check_refused(run_program({"animate", MAGICMASS_SOURCE_DIR "/tutorials/scenes/cradle.toml", "-o",
                             folder / "x", "--gif", folder / "./x"}),
                "--gif and -o name one file");
  CHECK_FALSE(std::filesystem::exists(folder / "x"));
}
