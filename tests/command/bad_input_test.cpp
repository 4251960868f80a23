// SPDX-License-Identifier: GPL-2.0-or-later
// One clear line on stderr, exit code 2, nothing on stdout, no file.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

namespace {

void check_command_refused(std::vector<std::string> arguments, const std::string& part_of_message) {
  const TemporaryFolder folder;
  arguments.insert(arguments.end(), {"-o", folder / "answer"});
  for (const bool to_file : {true, false}) {
    if (!to_file) arguments.resize(arguments.size() - 2);
    const ProgramRun run = run_program(arguments);
    CAPTURE(arguments);
    check_refused(run, part_of_message);
    CHECK(folder.names().empty());
  }
}

void check_scene_refused(const std::string& scene, const std::string& part_of_message) {
  const TemporaryFolder folder;
  write_file(folder / "scene.toml", scene);
  check_command_refused({"simulate", folder / "scene.toml"}, part_of_message);
}

}  // namespace

TEST_CASE("mass ratios that are none", "[exam]") {
  for (const std::string command : {"count", "terminal"})
    for (const std::string alpha :
         {"0", "-0.1", "nan", "inf", "-inf", "", "1/0", "0x", "0/3", "1e999", "x"})
      check_command_refused({command, "--alpha", alpha}, "alpha");
  for (const std::string alpha : {"magic:0", "deficient:0", "magic:x"})
    check_command_refused({"eval", "--alpha", alpha, "--n", "1"}, alpha);
}

TEST_CASE("collisions that do not happen", "[exam]") {
  for (const std::string n : {"-1", "2.5", "", "x", "1e3"})
    check_command_refused({"eval", "--alpha", "0.1", "--n", n}, "n must be a whole number");
  check_command_refused(
      {"eval", "--alpha", "0.1", "--n", "7"},
      "n = 7 is beyond the last collision: N_A = 4 at alpha = 0.1; the formula goes on, "
      "physics does not");
  check_command_refused({"eval", "--alpha", "magic:3", "--n", "4", "--tier", "exact"},
                        "N_A = 3 at alpha = magic:3");
  check_command_refused({"eval", "--alpha", "1", "--n", "99999999999999999999999999"}, "N_A = 1");
}

TEST_CASE("tiers and digits", "[exam]") {
  check_command_refused({"eval", "--alpha", "0.1", "--n", "1", "--tier", "turbo"},
                        "unknown tier \"turbo\"; allowed: fast, accurate, exact");
  check_command_refused(
      {"eval", "--alpha", "0.1", "--n", "1", "--tier", "accurate", "--digits", "5"},
      "--digits goes with --tier exact; tier accurate computes in doubles");
  for (const std::string digits : {"0", "-3", "100001", "ten", ""})
    check_command_refused({"eval", "--alpha", "0.1", "--n", "1", "--digits", digits},
                          "from 1 to 100000,");
  check_command_refused({"eval", "--alpha", "0.1", "--n", "1", "--tier", "fast", "--digits", "5"},
                        "--digits goes with");
}

TEST_CASE("usage", "[exam]") {
  check_command_refused({"eval", "--alpha", "0.1"}, "--n");
  check_command_refused({"count"}, "--alpha");
  check_command_refused({"count", "--alpha", "0.1", "--input", "x.csv"}, "exclude each other");
  check_command_refused({"count", "--alpha", "0.1", "--bogus"}, "--bogus");
  check_command_refused({"count", "--alpha", "0.1", "--format", "xml"},
                        "unknown format \"xml\"; allowed: text, json, csv");
  check_command_refused({"ratios", "--count", "0"}, "--count");
  check_command_refused({"derive", "powr"}, "did you mean power?");
  check_command_refused({"simulate"}, "SCENE");
  check_command_refused({"nonsense"}, "no command is called \"nonsense\"");
}

TEST_CASE("unreadable and malformed files", "[exam]") {
  check_command_refused({"count", "--input", "/no/such.csv"}, "/no/such.csv: cannot be read");
  check_command_refused({"count", "--input", "/"}, "cannot be read");
  check_command_refused({"simulate", "/no/such.toml"}, "/no/such.toml: cannot be read");
  check_scene_refused("alpha = \n", "scene.toml:1: ");
  check_scene_refused("title = \"x\"\nalpha = -1\n", "scene.toml:2: alpha: ");
  check_scene_refused("alpha = 0.1\nspeed = 3\n", "scene.toml:2: speed: unknown key");
  check_scene_refused("alpha = 0.1\nrestitution = 1.1\n", "scene.toml:2: restitution: ");
  check_scene_refused("alpha = 0.1\noutputs = [\"colour\"]\n", "scene.toml:2: outputs: ");
  check_scene_refused("V = 1.0\n", "alpha: missing");
  check_scene_refused("alpha = 1\ntitle = \"\\u001b[31m\"\n",
                      "scene.toml:2: title: a control character");
  std::string key = "a";
  for (int i = 0; i < 35000; ++i) key += ".a";
  check_scene_refused(key + " = 1\n", "a key of more than 1000 parts");
  check_scene_refused("[" + key + "]\n", "a key of more than 1000 parts");
  check_scene_refused("x = {" + key + " = 1}\n", "a key of more than 1000 parts");
  check_command_refused({"count", "--input", "/dev/zero"}, "larger than 100 megabytes");
}

TEST_CASE("messages show control characters instead of obeying them", "[exam]") {
  const ProgramRun run = run_program({"count", "--alpha", "\x1b[31m1\n2"});
  CHECK(run.exit_code == 2);
  CHECK(lines_of(run.errors).size() == 1);
  CHECK(run.errors.find('\x1b') == std::string::npos);
}
