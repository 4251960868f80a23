// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/count.hpp"

#include <cstdio>

#include "magicmass/fast.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/velocities_product.hpp"

int main() {
  const auto scene = magicmass::parse_scene("alpha = 0.12", "scene");
  const auto counts = magicmass::count_collisions(0.12).value();
  const auto last = magicmass::generated::velocities_product(0.12, counts.N_B);
  std::printf("%d + %d, %.6f, %zu bodies\n", int(counts.N_A), int(counts.N_B), last.b,
              scene.masses.size());
}
