// SPDX-License-Identifier: GPL-2.0-or-later
// Times and places of the collisions: by simulation, by formula, and as points of
// one straight line.
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "magicmass/accurate.hpp"
#include "magicmass/simulator/three_body.hpp"

using magicmass::Body;

int main() {
  const double alpha = 0.1;
  // The angle of the wedge.
  const double h = magicmass::accurate::angle(alpha) / 2;
  std::printf("alpha: %g\n", alpha);
  std::printf(
      "events:\n  collision | t simulated | t(j) | A to B simulated | s(j)\n");

  const auto recorded = magicmass::record_three_body(alpha);
  std::int64_t j = 0;
  for (const auto& event : recorded.events) {
    const auto formula = magicmass::accurate::encounters(alpha, j++);
    std::printf("  %c %lld | %.6f | %.6f | %.6f | %.6f\n",
                event.body == Body::A ? 'P' : 'Q', static_cast<long long>(event.n),
                event.time, formula.t, event.positions.b - event.positions.a,
                formula.s);
  }

  std::printf("line:\n  j | turned in radians | along | across\n");
  for (j = 0; j < static_cast<std::int64_t>(recorded.events.size()); ++j) {
    const auto [t, s] = magicmass::accurate::encounters(alpha, j);
    const double angle = static_cast<double>(j + 1) * h;
    std::printf("  %lld | %.6f | %.6f | %.6f\n", static_cast<long long>(j), angle,
                t + s * std::cos(angle), s * std::sin(angle));
  }
  std::printf("cosine: %.6f\nsine: %.6f\n", std::cos(h), std::sin(h));

  // How close do the blocks come? A light ball keeps them apart, by how much?
  std::printf(
      "closest:\n  alpha | smallest distance at a collision | sin(h) | "
      "h\n");
  for (const double light : {0.5, 0.1, 0.01, 0.0001, 0.000001}) {
    double smallest = 1;
    magicmass::simulate_three_body(
        light, 1.0, 1.0, 10'000'000, [&](const auto& event) {
          smallest = std::fmin(smallest, event.positions.b - event.positions.a);
        });
    const double half = magicmass::accurate::angle(light) / 2;
    std::printf("  %g | %.6f | %.6f | %.6f\n", light, smallest, std::sin(half),
                half);
  }
}
