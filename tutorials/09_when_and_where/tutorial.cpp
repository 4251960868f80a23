// Times and places of collisions: by simulation, by formula, and as points of a straight line.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/simulator/three_bodies.hpp"

using Motion = magicmass::simulator::ThreeBodies<double>;

double distance_of_blocks(const Motion& motion) {
  return motion.bodies()[2].position - motion.bodies()[0].position;
}

int main() {
  const double alpha = 0.1;
  const double h = magicmass::accurate::angle(alpha) / 2;  // the angle of the wedge
  std::printf("alpha: %g\nevents:\n", alpha);
  std::printf("  j | collision | t simulated | when_j | A to B simulated | apart_j\n");
  Motion motion(alpha);
  int collisions = 0;
  while (const auto event = motion.step()) {
    const auto [t, s] = magicmass::accurate::collision(alpha, collisions);
    std::printf("  %d | %c %d | %.6f | %.6f | %.6f | %.6f\n", collisions,
                event->gap == 1 ? 'P' : 'Q', collisions / 2 + 1, event->time, t,
                distance_of_blocks(motion), s);
    ++collisions;
  }
  std::printf("line:\n  j | angle of the ray | along | across\n");
  for (int j = 0; j < collisions; ++j) {
    const auto [t, s] = magicmass::accurate::collision(alpha, j);
    const double angle = (j + 1) * h;
    std::printf("  %d | %.6f | %.6f | %.6f\n", j, angle, t + s * std::cos(angle),
                s * std::sin(angle));
  }
  std::printf("cosine: %.6f\nsine: %.6f\n", std::cos(h), std::sin(h));

  // How close do the blocks come? A light ball keeps them apart, by how much?
  std::printf("closest:\n  alpha | smallest distance at a collision | sin(h) | h\n");
  for (const double light : {0.5, 0.1, 0.01, 0.0001, 0.000001}) {
    double smallest = 1;
    for (Motion squeezed(light); squeezed.step();)
      smallest = std::min(smallest, distance_of_blocks(squeezed));
    const double half = magicmass::accurate::angle(light) / 2;
    std::printf("  %g | %.6f | %.6f | %.6f\n", light, smallest, std::sin(half), half);
  }
}
