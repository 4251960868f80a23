// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/scene.hpp"

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/scene_keys.hpp"

using namespace magicmass;

namespace {

const std::string scenes = MAGICMASS_SCENES_DIRECTORY;

template <class Read>
std::string refusal_of(const Read& read) {
  try {
    read();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusal_of_text(std::string_view text) {
  return refusal_of([&] { parse_scene(text, "f.toml"); });
}

const std::vector<Output> all_outputs = {Output::counts, Output::terminal, Output::events,
                                         Output::trajectory, Output::energy};

}  // namespace

TEST_CASE("the paper's three trajectory scenes read as the paper has them", "[exam]") {
  const Scene a = read_scene(scenes + "/trajectory_a.toml");
  CHECK(a.title == "Paper, Fig. trajectories (a)");
  CHECK(a.kind == Kind::three_body);
  CHECK(a.alpha == MassRatio(Magic{3}));
  CHECK(a.outputs == all_outputs);
  CHECK(read_scene(scenes + "/trajectory_b.toml").alpha == MassRatio(0.12));
  CHECK(read_scene(scenes + "/trajectory_c.toml").alpha == MassRatio(0.10));
}

TEST_CASE("every key but the masses has a default", "[exam]") {
  const Scene scene = parse_scene("alpha = \"1/7\"", "f.toml");
  CHECK(scene.kind == Kind::three_body);
  CHECK(scene.alpha == MassRatio(Fraction{"1", "7"}));
  CHECK(scene.masses == std::vector<Value>{1.0, Expression{"1/7"}, 1.0});
  CHECK(scene.V == Value(1.0));
  CHECK(scene.L == Value(1.0));
  CHECK(scene.restitution == Value(1.0));
  CHECK(wants(scene, Output::counts));
  CHECK_FALSE(wants(scene, Output::energy));
}

TEST_CASE("numbers may be floats, integers or text and outputs come in any order", "[exam]") {
  const Scene scene =
      parse_scene("alpha = 3\nV = 2\nL = 0.5\noutputs = [\"energy\", \"counts\"]", "f.toml");
  CHECK(scene.alpha == MassRatio(3.0));
  CHECK(scene.V == Value(2.0));
  CHECK(scene.L == Value(0.5));
  CHECK(scene.outputs == std::vector<Output>{Output::counts, Output::energy});
  CHECK(parse_scene("alpha = 1.0000000000000002", "f.toml").alpha ==
        MassRatio(0x1.0000000000001p0));
  CHECK(std::string(to_text(Output::trajectory)) == "trajectory");
  CHECK(parse_scene("alpha = \"sqrt(5)-2\"", "f.toml").masses[1] == Value(Expression{"sqrt(5)-2"}));
  CHECK(parse_scene("alpha = 1\nV = \"1/3\"", "f.toml").alpha.has_value());
}

TEST_CASE("walls and chains are laid out or told", "[exam]") {
  const Scene wall = parse_scene("kind = \"wall\"\nmass_ratio = \"100^3\"", "f.toml");
  CHECK(wall.masses == std::vector<Value>{Expression{"100^3"}, 1.0});
  CHECK(wall.has_right_wall);
  CHECK_FALSE(wall.right_wall.has_value());
  const Scene cradle = read_scene(scenes + "/cradle.toml");
  CHECK(cradle.kind == Kind::chain);
  CHECK(cradle.masses ==
        std::vector<Value>{1.0, Magic{1}, 1.0, Magic{2}, 1.0, Magic{3}, 1.0, Magic{4}, 1.0});
  CHECK((cradle.has_left_wall && cradle.has_right_wall));
  CHECK(body_name(cradle, 3) == "C_2");
  const Scene chain = read_scene(scenes + "/chain.toml");
  CHECK(chain.positions.size() == 4);
  CHECK(chain.right_wall == Value(4.0));
  CHECK(chain.every == 2);
  CHECK(body_name(chain, 3) == "4");
}

TEST_CASE("each bad scene is refused with file, line, key, and what is allowed", "[exam]") {
  const std::string values = "; allowed: " + std::string(allowed_values);
  const std::string outputs =
      "; allowed: an array of \"counts\", \"terminal\", \"events\", \"trajectory\", "
      "\"energy\", each at most once";
  const std::string keys =
      "title, kind, alpha, masses, V, L, positions, velocities, restitution, outputs, every, "
      "times, until, max_events";
  std::string kinds;
  for (const SceneKind& row : scene_kinds())
    kinds += (kinds.empty() ? "\"" : ", \"") + std::string(row.name) + '"';
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"",
       "f.toml:1: alpha: missing; allowed: a line like alpha = 0.1 or alpha = \"magic:3\", or "
       "masses = [1, 0.1, 2]"},
      {"alpha = -0.1",
       "f.toml:1: alpha: alpha must be a positive finite number, got -0.1" + values},
      {"\nalpha = inf",
       "f.toml:2: alpha: alpha must be a positive finite number, got inf" + values},
      {"alpha = \"1/0\"", "f.toml:1: alpha: alpha divides by zero: 1/0" + values},
      {"alpha = \"rubbish\"", "f.toml:1: alpha: alpha is not a number: \"rubbish\"" + values},
      {"alpha = \"sqrt(5\"",
       "f.toml:1: alpha: got \"sqrt(5\": the expression stops short" + values},
      {"alpha = true", "f.toml:1: alpha: expected a number, got a TOML boolean" + values},
      {"alpha = 1\n\nbeta = 2", "f.toml:3: beta: unknown key; allowed: " + keys},
      {"alpha = 1\n[walls]\nx = 1", "f.toml:2: walls: unknown key; allowed: " + keys},
      {"alpha = 1\ntitle = 3",
       "f.toml:2: title: expected a string, got a TOML integer; allowed: a string"},
      {"alpha = 1\nkind = \"x\\ty\"",
       "f.toml:2: kind: unknown kind \"x\\x09y\"; allowed: " + kinds},
      {"alpha = 1\nV = nan",
       "f.toml:2: V: got \"nan\": the expression makes no sense from "
       "\"nan\" on" +
           values},
      {"alpha = 1\nmasses = [1, 2, 3]",
       "f.toml:2: masses: does not go with alpha; allowed: one of the two"},
      {"masses = [1, 2]", "f.toml:1: masses: got 2 masses; allowed: three: those of A, C and B"},
      {"alpha = 1\npositions = [1, 2]",
       "f.toml:2: positions: got 2; allowed: as many as there are bodies: 3"},
      {"kind = \"wall\"\nmass_ratio = 100\npositions = [0, 1]",
       "f.toml:1: wall: missing; allowed: where the wall is, as positions are given"},
      {"kind = \"chain\"\nballs = 1",
       "f.toml:1: blocks: missing; allowed: lines like blocks = 5 "
       "and balls = \"magic:3\", or masses = [1, 0.1, 1]"},
      {"kind = \"chain\"\nblocks = 3\nballs = [1]",
       "f.toml:3: balls: got 1 balls for 2 gaps between blocks; allowed: one value for all balls, "
       "or an array with one for each"},
      {"kind = \"chain\"\nblocks = 0",
       "f.toml:2: blocks: got 0; allowed: a whole number from 1 "
       "to 1000000"},
      {"alpha = 1\nevery = 10",
       "f.toml:2: every: there is nothing to leave out; allowed: every together with the output "
       "\"events\" or \"trajectory\""},
      {"alpha = 1\noutputs = \"counts\"",
       "f.toml:2: outputs: expected an array, got a TOML string" + outputs},
      {"alpha = 1\noutputs = []", "f.toml:2: outputs: no output asked for" + outputs},
      {"alpha = 1\noutputs = [1]",
       "f.toml:2: outputs: expected a string, got a TOML integer" + outputs},
      {"alpha = 1\noutputs = [\"counts\",\n\"count\"]",
       "f.toml:3: outputs: unknown output \"count\"" + outputs},
      {"alpha = 1\noutputs = [\"energy\", \"energy\"]",
       "f.toml:2: outputs: \"energy\" is there twice" + outputs},
  };
  for (const auto& [text, message] : refused) {
    CHECK(refusal_of_text(text) == message);
  }
}

TEST_CASE("what is not TOML is refused with its line", "[exam]") {
  CHECK_THAT(refusal_of_text("alpha ="), Catch::StartsWith("f.toml:1: not valid TOML: "));
  CHECK_THAT(refusal_of_text("alpha = 1\nalpha = 2"),
             Catch::StartsWith("f.toml:2: not valid TOML: "));
  CHECK_THAT(refusal_of_text("\xff\xfe"), Catch::StartsWith("f.toml:1: not valid TOML: "));
  CHECK_THAT(refusal_of_text(std::string("a\0b", 3)),
             Catch::StartsWith("f.toml:1: not valid TOML: "));
  CHECK_THAT(refusal_of_text("alpha = " + std::string(100000, '[')),
             Catch::StartsWith("f.toml:1: not valid TOML: "));
}

TEST_CASE("files that cannot be a scene are refused", "[exam]") {
  CHECK(refusal_of([] { read_scene("/nonexistent.toml"); }) ==
        "/nonexistent.toml: cannot be read; allowed: a scene file in TOML");
  CHECK(refusal_of([] { read_scene(scenes); }) ==
        scenes + ": cannot be read; allowed: a scene file in TOML");
  CHECK(refusal_of([] { read_scene("/dev/zero"); }) ==
        "/dev/zero: longer than 1048576 bytes; allowed: a scene file in TOML");
}
