// Three bodies by the law of one collision alone: the oracle of theorems and of answers.
#pragma once

#include <array>
#include <cstddef>

namespace law {
/// A, B and the ball C between them, which lose energy; 1/M_B is 0 where B is a wall.
template <class Number>
struct ThreeBodies {
  Number A_mass, per_B, ball, e;
  std::array<Number, 3> v, place;  ///< of A, B, C
  Number time = 0;
  int N = 0;  ///< collisions so far, with A and B by turns

  bool A_next() const { return N % 2 == 0; }
  Number approach() const { return A_next() ? v[0] - v[2] : v[2] - v[1]; }
  /// Both are reflected at the velocity of their common centre of mass.
  void collide() {
    const Number centre = A_next() ? (A_mass * v[0] + ball * v[2]) / (A_mass + ball)
                                   : (per_B * ball * v[2] + v[1]) / (per_B * ball + 1);
    for (std::size_t i : {A_next() ? std::size_t(0) : 1, std::size_t(2)})
      v[i] = (1 + e) * centre - e * v[i];
    ++N;
  }
  /// Until the next collision.
  void wait() {
    const Number gap = A_next() ? place[2] - place[0] : place[1] - place[2];
    const Number t = gap / approach();
    time = time + t;
    for (std::size_t i = 0; i < 3; ++i) place[i] = place[i] + t * v[i];
  }
};
/// Blocks of mass 1, B at 1 from A and the ball, V = 1.
template <class Number>
ThreeBodies<Number> equal_blocks(const Number& alpha, const Number& e = 1) {
  return {1, 1, alpha, e, {1, 0, 0}, {0, 1, 0}};
}
}  // namespace law
