// SPDX-License-Identifier: MIT
// The paper's scene, event by event: A hits the ball C, which hits B, and so on.
#include <cstdio>

#include "magicmass/simulator/three_body.hpp"

int main() {
  const auto recorded = magicmass::record_three_body(0.12);  // alpha; V = L = 1; any field will do
  for (const auto& event : recorded.events)
    std::printf("t = %.4f, x = %.4f: C meets %s\n", event.time, event.position,
                event.body == magicmass::Body::A ? "A" : "B");
  const auto& last = recorded.run.terminal;
  std::printf("a_t = %.4f, b_t = %.4f, c_t = %.4f\n", last.a, last.b, last.c);
}
