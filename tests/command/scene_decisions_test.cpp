// SPDX-License-Identifier: GPL-2.0-or-later
// Decisions of scenes that rounding cannot make: each is exact, or said to be a near tie. Every scene here is held against
// its run in exact numbers.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"
#include "refusal.hpp"

namespace {

nlohmann::json simulated(const std::string& scene, std::vector<std::string> options = {}) {
  const TemporaryFolder folder;
  write_file(folder / "scene.toml", scene);
  std::vector<std::string> arguments{"simulate", folder / "scene.toml"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return json_of(arguments);
}

}  // namespace

TEST_CASE("a contact at the very end of a run takes place", "[exam]") {
  for (const char* scene :
       {"kind = \"chain\"\nmasses = [1]\npositions = [2]\nvelocities = [\"-1/7\"]\n"
        "left_wall = \"11/7\"\nuntil = 3\n",
        "masses = [1, \"1/3\", 1]\nV = \"1/7\"\nL = \"3/7\"\nuntil = 10\n"}) {
    INFO(scene);
    const nlohmann::json planned = simulated(scene);
    const nlohmann::json exact = simulated(scene, {"--exact"});
    CHECK(planned.at("contacts") == exact.at("contacts"));
    CHECK(planned.at("contacts") > 0);
  }
}

TEST_CASE("a run that ends within a transfer is no run by transfers", "[exam]") {
  const std::string cradle =
      "kind = \"chain\"\nblocks = 4\nballs = [\"magic:2\", \"magic:2\", 1]\ngap = \"7/5\"\n"
      "L = \"1/3\"\nV = \"1/3\"\nwalls = \"both\"\n";
  for (const char* until : {"20/3", "4", "21/5", "5", "26/5", "6", "31/5", "10", "100", "1000/7"}) {
    INFO("until " << until);
    const std::string scene = cradle + "until = \"" + until + "\"\n";
    const nlohmann::json planned = simulated(scene);
    const nlohmann::json stepped = simulated(scene, {"--model", "event-driven"});
    CHECK(planned.at("contacts") == stepped.at("contacts"));
  }
}

TEST_CASE("velocities alone are stepped to the exact number of contacts", "[exam]") {
  for (const char* scene : {"kind = \"wall\"\nmasses = [\"1/3\", 1]\nV = \"5/3\"\n",
                            "masses = [10, 1, \"11/9\"]\nV = 7\n"}) {
    INFO(scene);
    const nlohmann::json stepped = simulated(scene, {"--scalar", "double"});
    CHECK(stepped.at("contacts") == simulated(scene).at("contacts"));
    CHECK(stepped.at("status") == "complete");
  }
}

TEST_CASE("a collapse is timed right however small the restitution", "[exam]") {
  for (const char* e : {"1e-100", "1e-300", "1e-320", "5e-324", "\"1/10^400\"", "\"1/10^1000\""}) {
    INFO("e = " << e);
    const nlohmann::json run =
        simulated(std::string("masses = [1, 1, 3]\nrestitution = ") + e + "\n");
    CHECK(run.at("status") == "collapse");
    const double t = run.at("collapse").at("time"), x = run.at("collapse").at("position");
    CHECK_THAT(t, Catch::WithinULP(2.0, 0));
    CHECK_THAT(x, Catch::WithinULP(1.0, 0));
  }
}

TEST_CASE("numbers too small for a double's usual range are shown in tables", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "scene.toml", "alpha = 1.5e-310\noutputs = [\"events\"]\nmax_events = 4\n");
  const ProgramRun run = run_program({"simulate", folder / "scene.toml"});
  CHECK(run.exit_code == 0);
  CHECK(run.errors.empty());
  CHECK(run.output.find("limited") != std::string::npos);
  CHECK(lines_of(run.output).size() > 6);  // the four events among them
}

TEST_CASE("numbers beyond doubles are refused where events are stepped, and what remains is named",
          "[exam]") {
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.toml";
  write_file(scene, "alpha = \"100^200\"\noutputs = [\"events\"]\n");
  const ProgramRun refused = run_program({"simulate", scene});
  CHECK(refused.exit_code == 3);
  CHECK(refused.errors ==
        "magicmass: a mass of the scene is too large for doubles; allowed: simulate --exact\n");
  CHECK(run_program({"simulate", scene, "--exact"}).exit_code == 0);
  write_file(scene, "kind = \"wall\"\nmass_ratio = \"100^300\"\noutputs = [\"events\"]\n");
  check_refused(run_program({"simulate", scene}),
                "a list of all 3.14159e300 events is over the limit of 1000000; allowed: times = ");
}

TEST_CASE("the paper's counts are known whatever the units, and beyond doubles", "[exam]") {
  for (const char* units : {"V = \"1/3\"\n", "L = \"1/3\"\n", "V = \"sqrt(2)\"\n", ""}) {
    INFO(units);
    const nlohmann::json run = simulated(std::string("alpha = \"magic:100\"\n") + units);
    CHECK(run.at("counts") == simulated("alpha = \"magic:100\"\n").at("counts"));
    CHECK(run.at("status") == "complete");
  }
  const std::string tiny = "alpha = \"1/1" + std::string(400, '0') + "\"\n";
  CHECK(simulated(tiny).at("status") == "complete");
  CHECK(simulated("alpha = 1e-300\n").at("status") == "complete");
}
