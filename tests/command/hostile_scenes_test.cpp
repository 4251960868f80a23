// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes that nobody would write but to see what happens: each ends, in bounded time and memory, and says how.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "program_run.hpp"

TEST_CASE("a box that cools for ever is never complete, whatever its restitution", "[exam]") {
  const TemporaryFolder folder;
  for (const char* e : {"0.01", "0.1", "0.3", "0.6", "0.9", "0.99"})
    for (const char* bodies : {"blocks = 2\nballs = 0.3\n", "masses = [1]\nvelocities = [1]\n",
                               "masses = [1, 1e-9, 1e9, 1]\n"}) {
      write_file(folder / "box.toml", std::string("kind = \"chain\"\nwalls = \"both\"\n") + bodies +
                                          "restitution = " + e + "\n");
      const nlohmann::json result = json_of({"simulate", folder / "box.toml"});
      INFO(bodies << e << result.dump());
      CHECK((result.at("status") == "limited" || result.at("status") == "collapse"));
      CHECK_FALSE(result.at("why").get<std::string>().empty());
      CHECK(result.at("terminal").is_null());
    }
}

TEST_CASE("hostile scenes end, and say how", "[exam]") {
  const TemporaryFolder folder;
  for (const char* scene :
       {"masses = [1e-300, 1e300, 1e-300]\nvelocities = [1, 0, -1]\npositions = [0, 1, 2]\n",
        "masses = [1, 1, 1]\nvelocities = [1e-300, 0, 0]\npositions = [0, 1e300, 1e300]\n",
        "masses = [1, 2, 1, 2]\nvelocities = [3, 2, 1, 0]\npositions = [0, 0, 0, 0]\n",
        "masses = [1, 3, 1]\nvelocities = [1, 0, -1]\npositions = [0, 0, 0]\nrestitution = 0.5\n",
        "masses = [1, 1]\nvelocities = [1, 0]\nwalls = \"both\"\ngap = 0\nL = 1e-300\n",
        "masses = [2, 1]\npositions = [0, 0]\nleft_wall = 0\nright_wall = 0\nvelocities = [1, "
        "-1]\n",
        "masses = [2, 1]\npositions = [0, 0]\nleft_wall = 0\nright_wall = 0\nvelocities = [1, -1]\n"
        "restitution = 1e-300\n"}) {
    write_file(folder / "hostile.toml", std::string("kind = \"chain\"\n") + scene);
    const nlohmann::json result = json_of({"simulate", folder / "hostile.toml"});
    INFO(scene << result.dump());
    const std::string status = result.at("status");
    CHECK((status == "complete" || status == "limited" || status == "collapse"));
    CHECK((status == "complete") == result.at("why").get<std::string>().empty());
  }
}

TEST_CASE("what a hunt for hostile scenes found ends, and says how", "[exam]") {
  const TemporaryFolder folder;
  struct Hostile {
    const char* scene;
    std::vector<std::string> options;
    const char* status;
  };
  const std::vector<Hostile> found = {
      // Exact numbers that grow by thousands of bits an event.
      {"masses = [1e-308, 1e-200, \"1/3\", 1e-308, \"magic:3\", 1e17, \"1/10^400\", 1e17]\n"
       "walls = \"both\"",
       {"--scalar", "exact", "--max-events", "400"},
       "limited"},
      // A due time that is no number: infinitely far, infinitely fast.
      {"masses = [1, 1]\npositions = [-1e308, 1e308]\nvelocities = [1e308, -1e308]\n"
       "left_wall = -1.5e308\nright_wall = 1.5e308",
       {"--scalar", "double", "--max-events", "1000"},
       "limited"},
      // Times that rounding does not move on.
      {"masses = [3, 1e17]\npositions = [0, 0]\nleft_wall = 0\nright_wall = 1e-320\n"
       "velocities = [1, 0]",
       {"--scalar", "long-double", "--max-events", "1000"},
       "limited"},
      {"masses = [1e17, 1e-17, 1e17]\nrestitution = 1e-300\nwalls = \"both\"",
       {"--scalar", "double"},
       "collapse"},
      {"masses = [1e-300, 1e300, 1e-300, 1e300]\nwalls = \"both\"",
       {"--scalar", "double", "--max-events", "1000"},
       "limited"}};
  for (const Hostile& one : found) {
    write_file(folder / "hostile.toml", std::string("kind = \"chain\"\n") + one.scene + "\n");
    std::vector<std::string> words = {"simulate", folder / "hostile.toml"};
    words.insert(words.end(), one.options.begin(), one.options.end());
    const nlohmann::json result = json_of(words);
    INFO(one.scene << result.dump());
    CHECK(result.at("status") == one.status);
    CHECK_FALSE(result.at("why").get<std::string>().empty());
  }
  // What a double cannot hold is not taken for 0.
  write_file(folder / "tiny.toml",
             "kind = \"chain\"\nmasses = [1, 2]\nvelocities = [\"1/10^400\", 0]\n");
  const ProgramRun tiny = run_program({"simulate", folder / "tiny.toml", "--scalar", "double"});
  CHECK(tiny.exit_code == 3);
  CHECK(lines_of(tiny.errors).size() == 1);
  CHECK(json_of({"simulate", folder / "tiny.toml", "--scalar", "exact"}).at("status") ==
        "complete");
}

TEST_CASE("rows that are kept in memory have a limit", "[exam]") {
  const TemporaryFolder folder;
  write_file(folder / "long.toml",
             "alpha = 1e-14\noutputs = [\"events\"]\nmax_events = 1000000000\n");
  const ProgramRun run = run_program({"simulate", folder / "long.toml"});
  CHECK(run.exit_code == 2);
  CHECK(run.errors.find("--format jsonl") != std::string::npos);
}
