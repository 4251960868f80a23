// A ball between a block and a wall: counting collisions, and the digits of pi among the counts.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <cln/cln.h>

#include "kernel/expr.hpp"
#include "magicmass/simulator/contact.hpp"

using Matrix = std::array<cln::cl_R, 4>;

// One by one, velocities alone: the block comes with 1, the ball rests, the wall is on the right.
int counted(double mass) {
  magicmass::simulator::Body<double> block{mass, 0, 1}, ball{1, 0, 0};
  for (int collisions = 0;; ++collisions) {
    if (ball.velocity < block.velocity)
      collide(block, ball);
    else if (ball.velocity > 0)
      ball.velocity = -ball.velocity;
    else
      return collisions;
  }
}
Matrix operator*(const Matrix& x, const Matrix& y) {
  return {x[0] * y[0] + x[1] * y[2], x[0] * y[1] + x[1] * y[3],  //
          x[2] * y[0] + x[3] * y[2], x[2] * y[1] + x[3] * y[3]};
}
constexpr unsigned carried = 200;
// By doubling and halving, in numbers of so many digits: in the first column are the velocities of
// block and ball, after so many cycles, each a collision of the two and one with the wall.
cln::cl_I counted_by_squaring(const cln::cl_RA& mass) {
  Matrix cycle;
  for (int i : {0, 1}) {
    magicmass::simulator::Body<cln::cl_RA> block{mass, 0, 1 - i}, ball{1, 0, i};
    collide(block, ball);
    cycle[std::size_t(i)] = cln::cl_float(block.velocity, cln::float_format(carried));
    cycle[std::size_t(i) + 2] = cln::cl_float(-ball.velocity, cln::float_format(carried));
  }
  const auto approaches = [](const Matrix& m) { return m[2] < m[0]; };
  std::vector<Matrix> doubled{cycle};
  while (approaches(doubled.back())) doubled.push_back(doubled.back() * doubled.back());
  Matrix now{1, 0, 0, 1};
  cln::cl_I cycles = 0;
  for (; !doubled.empty(); doubled.pop_back()) {
    const Matrix further = doubled.back() * now;
    const bool goes_on = approaches(further);
    if (goes_on) now = further;
    cycles = 2 * cycles + (goes_on ? 1 : 0);
  }
  // Block and ball meet once more; does the ball then go to the wall?
  return 2 * cycles + ((cycle * now)[2] < 0 ? 2 : 1);
}

int main() {
  std::printf("block_and_wall:\n  mass of the block | one by one | by squaring\n");
  cln::cl_I mass = 1;
  for (int k = 0; k <= 5; ++k, mass = 100 * mass)
    std::printf("  %s | %d | %s\n", kernel::digits(mass).c_str(), counted(cln::double_approx(mass)),
                kernel::digits(counted_by_squaring(mass)).c_str());
  const cln::cl_I many = counted_by_squaring(cln::expt_pos(cln::cl_I(100), 50));
  const auto doublings = cln::integer_length(cln::ash(many, -1));  // of cycles: two collisions each
  std::printf("many_digits: %s\n", kernel::digits(many).c_str());
  std::printf("doublings: %d\nlost: %.0f\ncarried: %u\n", int(doublings),
              double(doublings) * std::log10(2), carried);
  // At a billion collisions a second, with as many seconds in a year.
  std::printf("years: %.0g\n", 1e50 / 1e9 / 3.15e7);
}
