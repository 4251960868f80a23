// SPDX-License-Identifier: GPL-2.0-or-later
// A scene file: refused in one line, or a scene whose numbers are exact or refused likewise.
#include "magicmass/scenes/scene.hpp"

#include "fuzz_target.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/exact_line.hpp"

namespace {

using namespace magicmass;

/// What is read back from its own text is the same.
void require_round_trip(const Value& value) {
  const std::string text = to_text(value);
  fuzz::require(to_text(parse_value(text)) == text, "a value is not read back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Scene scene = parse_scene(fuzz::text_of(data, size), "scene.toml");
    if (scene.alpha)
      fuzz::require(parse_mass_ratio(to_text(*scene.alpha)) == *scene.alpha,
                    "a ratio is not read back");
    for (const auto* values : {&scene.masses, &scene.positions, &scene.velocities, &scene.times})
      for (const Value& value : *values) require_round_trip(value);
    constexpr std::size_t most = 50;  // more bodies take time and show nothing new
    if (scene.masses.size() <= most) reference::exact_line(scene);
  } catch (const InvalidInput& refusal) {
    fuzz::require_one_line(refusal);
  } catch (const Undecided& refusal) {
    fuzz::require_one_line(refusal);
  }
  return 0;
}
