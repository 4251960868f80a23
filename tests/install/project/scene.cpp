// SPDX-License-Identifier: GPL-2.0-or-later
// What the examples leave out: the part of the runtime that another library is behind.
#include <cstdio>

#include "magicmass/scenes/scene.hpp"

int main() {
  const auto scene = magicmass::parse_scene("alpha = 0.12", "scene");
  std::printf("%zu bodies\n", scene.masses.size());
}
