// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/scene.hpp"

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"

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
  CHECK(a ==
        Scene{"Paper, Fig. trajectories (a)", "three-body", Magic{3}, 1.0, 1.0, 1.0, all_outputs});
  CHECK(read_scene(scenes + "/trajectory_b.toml").alpha == MassRatio(0.12));
  CHECK(read_scene(scenes + "/trajectory_c.toml").alpha == MassRatio(0.10));
}

TEST_CASE("every key but alpha has a default", "[exam]") {
  const Scene scene = parse_scene("alpha = \"1/7\"", "f.toml");
  CHECK(
      scene ==
      Scene{
          "", "three-body", Fraction{"1", "7"}, 1.0, 1.0, 1.0, {Output::counts, Output::terminal}});
  CHECK(wants(scene, Output::counts));
  CHECK_FALSE(wants(scene, Output::energy));
}

TEST_CASE("numbers may be floats or integers and outputs come in any order", "[exam]") {
  const Scene scene =
      parse_scene("alpha = 3\nV = 2\nL = 0.5\noutputs = [\"energy\", \"counts\"]", "f.toml");
  CHECK(scene.alpha == MassRatio(3.0));
  CHECK(scene.V == 2.0);
  CHECK(scene.L == 0.5);
  CHECK(scene.outputs == std::vector<Output>{Output::counts, Output::energy});
  CHECK(parse_scene("alpha = 1.0000000000000002", "f.toml").alpha ==
        MassRatio(0x1.0000000000001p0));
  CHECK(std::string(to_text(Output::trajectory)) == "trajectory");
}

TEST_CASE("each bad scene is refused with file, line, key, and what is allowed", "[exam]") {
  const std::string ratios =
      "; allowed: a positive finite number, or a string with a decimal, a hex float, a "
      "fraction like \"1/7\", \"magic:k\" or \"deficient:k\"";
  const std::string outputs =
      "; allowed: an array of \"counts\", \"terminal\", \"events\", \"trajectory\", "
      "\"energy\", each at most once";
  const std::string positive = "; allowed: a positive finite number";
  const std::string elastic = "; allowed: 1.0 (only elastic collisions so far)";
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"", "f.toml:1: alpha: missing; allowed: a line like alpha = 0.1 or alpha = \"magic:3\""},
      {"alpha = -0.1",
       "f.toml:1: alpha: alpha must be a positive finite number, got -0.1" + ratios},
      {"\nalpha = inf",
       "f.toml:2: alpha: alpha must be a positive finite number, got inf" + ratios},
      {"alpha = 0", "f.toml:1: alpha: alpha must be a positive finite number, got 0" + ratios},
      {"alpha = \"1/0\"", "f.toml:1: alpha: alpha divides by zero: 1/0" + ratios},
      {"alpha = \"rubbish\"", "f.toml:1: alpha: alpha is not a number: \"rubbish\"" + ratios},
      {"alpha = true", "f.toml:1: alpha: expected a number, got a TOML boolean" + ratios},
      {"alpha = 1\n\nbeta = 2",
       "f.toml:3: beta: unknown key; allowed: title, kind, alpha, V, L, restitution, outputs"},
      {"alpha = 1\n[walls]\nx = 1",
       "f.toml:2: walls: unknown key; allowed: title, kind, alpha, V, L, restitution, outputs"},
      {"alpha = 1\ntitle = 3",
       "f.toml:2: title: expected a string, got a TOML integer; allowed: a string"},
      {"alpha = 1\nkind = \"wall\"",
       "f.toml:2: kind: \"wall\" is not available yet; allowed: \"three-body\""},
      {"alpha = 1\nkind = \"chain\"",
       "f.toml:2: kind: \"chain\" is not available yet; allowed: \"three-body\""},
      {"alpha = 1\nkind = \"x\\ty\"",
       "f.toml:2: kind: unknown kind \"x\\x09y\"; allowed: \"three-body\""},
      {"alpha = 1\nV = 0", "f.toml:2: V: got 0" + positive},
      {"alpha = 1\nV = nan", "f.toml:2: V: got nan" + positive},
      {"alpha = 1\nL = \"1\"", "f.toml:2: L: expected a number, got a TOML string" + positive},
      {"alpha = 1\nrestitution = 0.9", "f.toml:2: restitution: got 0.9" + elastic},
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
