// SPDX-License-Identifier: MIT
// The cheapest model that answers a scene, and why. Needs magicmass::symbolic.
#include <iostream>

#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/scene_plan.hpp"

int main() {
  for (const char* outputs : {"[\"counts\"]", "[\"events\"]"}) {
    const std::string scene = "alpha = \"magic:3\"\noutputs = " + std::string(outputs);
    const auto plan = magicmass::reference::plan(magicmass::parse_scene(scene, "here"));
    std::cout << plan.model << ", " << magicmass::reference::to_text(plan.events)
              << " events: " << plan.reason << "\n";
  }
}
