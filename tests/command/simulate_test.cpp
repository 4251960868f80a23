// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "program_run.hpp"

namespace {

std::string scene_file(const std::string& name) {
  return MAGICMASS_SOURCE_DIR "/tutorials/scenes/" + name + ".toml";
}

}  // namespace

TEST_CASE("the paper's scenes run to the end with the exact counts", "[exam]") {
  for (const auto& [name, N_A, N_B] :
       {std::tuple("trajectory_a", 3, 3), {"trajectory_b", 3, 3}, {"trajectory_c", 4, 3}}) {
    const nlohmann::json result = json_of({"simulate", scene_file(name)});
    INFO(name);
    CHECK(result.at("status") == "complete");
    CHECK(result.at("plan").at("model") == "event-driven");
    CHECK(result.at("plan").at("events") == N_A + N_B);
    CHECK(result.at("counts") == nlohmann::json{{"N_A", N_A}, {"N_B", N_B}});
    CHECK(result.at("stepped") == result.at("counts"));
    CHECK(result.at("events").size() == static_cast<std::size_t>(N_A + N_B));
    CHECK(result.at("trajectory").size() == static_cast<std::size_t>(N_A + N_B + 2));
    CHECK(result.at("energy").at("energy_drift").get<double>() < 1e-14);
  }
}

TEST_CASE("exact scenes end with the exact terminal velocities and without drift", "[exam]") {
  const TemporaryFolder folder;
  write_file(
      folder / "scene.toml",
      "alpha = \"1/7\"\nV = 3.0\nL = 0.5\noutputs = [\"terminal\", \"events\", \"energy\"]\n");
  const nlohmann::json result = json_of({"simulate", "--exact", folder / "scene.toml"});
  CHECK(result.at("terminal") == nlohmann::json{{"a_t", "-195/1024"},
                                                {"b_t", "11781/4096"},
                                                {"c_t", "9009/4096"},
                                                {"rho", "15421329/16777216"}});
  CHECK(result.at("energy") == nlohmann::json{{"energy_drift", "0"}, {"momentum_drift", "0"}});
  CHECK(result.at("events").at(1).at("time") == "2/21");  // (L/V) (1 + alpha)/2
  CHECK(result.at("events").at(1).at("position") == "1/2");
}

TEST_CASE("no event is stepped where nobody asks for places or times", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "scene.toml",
             "alpha = 1e-30\noutputs = [\"counts\", \"terminal\", \"energy\"]\n");
  const nlohmann::json result = json_of({"simulate", folder / "scene.toml"});
  CHECK(result.at("plan").at("model") == "closed form");
  CHECK(result.at("plan").at("events") == 0);
  CHECK(result.at("counts").at("N_A").get<double>() ==
        Approx(1.1107207345395915e15).epsilon(1e-15));
  CHECK(result.at("events").empty());
  CHECK(result.at("stepped").is_null());
}

TEST_CASE("a run that reaches --max-events says so and claims no terminal velocities", "[exam]") {
  const nlohmann::json result =
      json_of({"simulate", scene_file("trajectory_b"), "--max-events", "4"});
  CHECK(result.at("status") == "limited");
  CHECK(result.at("events").size() == 4);
  CHECK(result.at("counts") == nlohmann::json{{"N_A", 3}, {"N_B", 3}});
  CHECK(result.at("stepped") == nlohmann::json{{"N_A", 2}, {"N_B", 2}});
  CHECK(result.at("terminal").is_null());
}

TEST_CASE("CSV holds the events", "[exam]") {
  const std::vector<std::string> lines =
      lines_of(run_program({"simulate", scene_file("trajectory_c"), "--format", "csv"}).output);
  REQUIRE(lines.size() == 8);
  CHECK(lines[0] == "body,n,time,position,a,b,c");
  CHECK(lines[1].starts_with("A,1,0,0,"));
}

TEST_CASE("an irrational alpha has no exact run", "[exam]") {
  const ProgramRun run = run_program({"simulate", scene_file("trajectory_a"), "--exact"});
  CHECK(run.exit_code == 2);
  CHECK(run.output.empty());
}

TEST_CASE("text shows fractions in the table of events as decimals", "[exam]") {
  const ProgramRun run = run_program({"simulate", scene_file("trajectory_b"), "--exact"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.find("   B      1      0.56000            1") !=
        std::string::npos);  // t = (1 + alpha)/2
}
