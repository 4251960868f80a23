// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <utility>
#include <vector>

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

TEST_CASE("at a threshold there is no spurious event, though the nearest double is beyond it",
          "[exam]") {
  const TemporaryFolder folder;
  for (int k = 1; k <= 40; ++k) {
    write_file(folder / "scene.toml",
               "alpha = \"magic:" + std::to_string(k) + "\"\noutputs = [\"events\"]\n");
    const nlohmann::json result = json_of({"simulate", folder / "scene.toml"});
    INFO(k);
    CHECK(result.at("status") == "complete");
    CHECK(result.at("events").size() == static_cast<std::size_t>(2 * k));
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

TEST_CASE("the paper's cradle makes a thousand round trips and leaves nothing behind", "[exam]") {
  const nlohmann::json result = json_of({"simulate", scene_file("cradle")});
  CHECK(result.at("plan").at("model") == "transfers");
  CHECK(result.at("contacts") == 42000);
  CHECK(result.at("cradle") ==
        nlohmann::json{{"transfers", 8000}, {"round_trips", 1000}, {"mover", "A_1"}});
  for (const auto& [body, v] : result.at("velocities").items())
    CHECK(v.get<double>() == (body == "A_1" ? 1.0 : 0.0));
}

TEST_CASE("a plan tells model, reason and events, and nothing is stepped without need", "[exam]") {
  CHECK(json_of({"plan", scene_file("trajectory_c")}).at("events") == 7);
  for (const char* name : {"wall", "unequal_blocks", "collapse"}) {
    const nlohmann::json plan = json_of({"plan", scene_file(name)});
    CHECK(plan.at("model") == "closed form");
    CHECK(plan.at("events") == 0);
    CHECK(json_of({"simulate", scene_file(name)}).at("stepped") == 0);
  }
  const nlohmann::json counted = json_of({"simulate", scene_file("wall")});
  CHECK(counted.at("evaluated") == 2);  // two velocities
  const TemporaryFolder folder;
  write_file(folder / "counts.toml", "kind = \"wall\"\nmass_ratio = 1e4\noutputs = [\"counts\"]\n");
  CHECK(json_of({"simulate", folder / "counts.toml"}).at("evaluated") == 0);
  CHECK(json_of({"simulate", folder / "counts.toml", "--model", "event-driven"}).at("stepped") ==
        314);
}

TEST_CASE("a trajectory of 10^15 events is refused with what to ask for instead", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "long.toml", "alpha = 1e-30\noutputs = [\"trajectory\"]\n");
  const ProgramRun run = run_program({"simulate", folder / "long.toml"});
  CHECK(run.exit_code == 2);
  CHECK(run.output.empty());
  CHECK(run.errors.find("2221441469079183 events") != std::string::npos);
  CHECK(run.errors.find("every = ") != std::string::npos);
  CHECK(run.errors.find("times = [...]") != std::string::npos);
  write_file(folder / "times.toml",
             "alpha = 1e-30\noutputs = [\"trajectory\"]\ntimes = [0.5, 2]\n");
  const nlohmann::json result = json_of({"simulate", folder / "times.toml"});
  CHECK(result.at("stepped") == 0);
  CHECK(result.at("trajectory").size() == 6);
  const ProgramRun model =
      run_program({"simulate", scene_file("trajectory_a"), "--model", "velocity-stepping"});
  CHECK(model.exit_code == 2);
  CHECK(model.errors.find("neither places nor times") != std::string::npos);
}

TEST_CASE("a collapse has a time and a place, and a hostile chain ends", "[exam]") {
  const nlohmann::json result = json_of({"simulate", scene_file("collapse")});
  CHECK(result.at("status") == "collapse");
  CHECK(result.at("collapse").at("time").get<double>() == Approx(3.257866648640732));
  const TemporaryFolder folder;
  write_file(folder / "chain.toml",
             "kind = \"chain\"\nblocks = 4\nballs = 0.3\nwalls = \"both\"\nrestitution = 0.05\n");
  CHECK(json_of({"simulate", folder / "chain.toml"}).at("status") == "collapse");
  write_file(folder / "forever.toml",
             "kind = \"chain\"\nblocks = 4\nballs = 0.3\nwalls = \"both\"\nmax_events = 5000\n");
  CHECK(json_of({"simulate", folder / "forever.toml"}).at("status") == "limited");
}

TEST_CASE("JSON lines hold each event and at last the result", "[exam]") {
  const std::vector<std::string> lines =
      lines_of(run_program({"simulate", scene_file("chain"), "--format", "jsonl"}).output);
  REQUIRE(lines.size() == 12);
  CHECK(nlohmann::json::parse(lines[0]).at("event").at("number") == 2);
  CHECK(nlohmann::json::parse(lines[11]).at("result").at("status") == "complete");
}

TEST_CASE("events are stepped in the numbers that are asked for", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "scene.toml", "masses = [1, 0.1, 2]\n");
  const auto velocity = [&](const std::string& scalar) {
    const nlohmann::json result =
        json_of({"simulate", folder / "scene.toml", "--scalar", scalar, "--model", "event-driven"});
    CHECK(result.at("status") == "complete");
    const auto& v = result.at("velocities").at("A");
    return v.is_string() ? v.get<std::string>() : v.dump();
  };
  CHECK(velocity("exact").find('/') != std::string::npos);
  const double in_doubles = std::stod(velocity("double"));
  CHECK(std::stod(velocity("long-double")) == Approx(in_doubles).epsilon(1e-14));
  const std::string text =
      run_program({"simulate", folder / "scene.toml", "--scalar", "long-double"}).output;
  CHECK(text.find("velocity stepping: asked for") != std::string::npos);
  for (const auto& [scalar, model] : {std::pair("exact", "velocity-stepping"),
                                      {"double", "closed-form"},
                                      {"double", "exact-events"}}) {
    const ProgramRun run =
        run_program({"simulate", folder / "scene.toml", "--scalar", scalar, "--model", model});
    CHECK(run.exit_code == 2);
    CHECK(run.errors.find("--scalar does not go with the model") != std::string::npos);
  }
  CHECK(run_program({"simulate", folder / "scene.toml", "--scalar", "float"}).exit_code == 2);
}

TEST_CASE("counts are told whatever the model", "[exam]") {
  const TemporaryFolder folder;
  const auto counts_of = [&](const std::string& kind, const std::string& outputs) {
    write_file(folder / "scene.toml", kind + "outputs = [" + outputs + "]\n");
    const nlohmann::json result = json_of({"simulate", folder / "scene.toml"});
    INFO(result.at("plan").dump());
    CHECK(result.at("status") == "complete");
    CHECK((result.at("stepped") == 0) == (outputs == "\"counts\""));
    return result.at("counts");
  };
  for (const std::string kind : {"kind = \"three-body\"\nalpha = \"1\"\nrestitution = \"9/125\"\n",
                                 "kind = \"wall\"\nmass_ratio = \"100^2\"\n"}) {
    INFO(kind);
    const nlohmann::json foretold = counts_of(kind, "\"counts\"");
    CHECK(foretold.at("N_A") > 3);
    CHECK(counts_of(kind, "\"counts\", \"events\"") == foretold);
  }
}

TEST_CASE("states that no theorem speaks of have no closed form, and are stepped", "[exam]") {
  const TemporaryFolder folder;
  for (const char* scene :
       {"masses = [1, 0.3, 2]\npositions = [0, 1, 2]\nvelocities = [1, 0.5, -1]\n",
        "masses = [1, 0.3, 2]\npositions = [0, 1, 1]\nvelocities = [1, 0, 0]\n",
        "kind = \"wall\"\nmasses = [1, 0.3]\npositions = [0, 1]\nvelocities = [1, 1]\nwall = "
        "3\n"}) {
    write_file(folder / "state.toml", scene);
    const ProgramRun run =
        run_program({"simulate", folder / "state.toml", "--model", "closed-form"});
    INFO(scene);
    CHECK(run.exit_code == 2);
    CHECK(run.errors.find("theorems hold for one block moving") != std::string::npos);
    CHECK(json_of({"simulate", folder / "state.toml"}).at("status") == "complete");
  }
}

TEST_CASE("energy is audited from the states, and momentum is missing where it was not measured",
          "[exam]") {
  const TemporaryFolder folder;
  const auto drift = [&](const std::string& scene) {
    write_file(folder / "audit.toml", scene + "\noutputs = [\"counts\", \"energy\"]\n");
    return json_of({"simulate", folder / "audit.toml"}).at("energy");
  };
  const std::string cradle = "kind = \"chain\"\nblocks = 3\nballs = \"magic:2\"\n";
  CHECK(drift(cradle).at("momentum_drift") == 0.0);
  const nlohmann::json walled = drift(cradle + "walls = \"both\"\nuntil = 33\n");
  CHECK(walled.at("energy_drift") == 0.0);
  CHECK(walled.at("momentum_drift").is_null());
  const nlohmann::json rounded = drift("kind = \"wall\"\nmasses = [11, 3]");
  CHECK(rounded.at("energy_drift").get<double>() > 0.0);  // of velocities that are rounded
  CHECK(rounded.at("energy_drift").get<double>() < 1e-15);
}
