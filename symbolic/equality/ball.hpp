// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include <cln/float.h>
#include <cln/rational.h>

namespace magicmass::equality {

// A real number within `radius` of `middle`. Operations round; how much is added to the radius each time is
// argued in ball.cpp. Nothing comes back where the operation is not certain to be defined.
struct Ball {
  cln::cl_F middle;
  cln::cl_F radius;
};

class BallArithmetic {
public:
  explicit BallArithmetic(int digits);

  Ball number(const cln::cl_RA& value) const;
  Ball pi() const;
  Ball sum(const Ball& x, const Ball& y) const;
  Ball product(const Ball& x, const Ball& y) const;
  std::optional<Ball> reciprocal(const Ball& x) const;        // 0 is not in x
  std::optional<Ball> root(const Ball& x, long order) const;  // x > 0
  Ball absolute(const Ball& x) const;
  std::optional<Ball> sine(const Ball& x) const;
  std::optional<Ball> cosine(const Ball& x) const;
  Ball arctangent(const Ball& x) const;
  std::optional<Ball> exponential(const Ball& x) const;
  std::optional<Ball> logarithm(const Ball& x) const;  // x > 0

private:
  Ball rounded(const cln::cl_F& middle, const cln::cl_F& radius) const;

  cln::float_format_t format_;
  cln::cl_F unit_;  // more than any rounding error relative to a result
};

// -1, +1, 0 for the number 0 alone; nothing where the ball leaves it open.
std::optional<int> sign(const Ball& ball);

// The certain digits, at most so many, rounded: "0.4142135624", "-3", "1.2e-50".
std::string shown(const Ball& ball, int digits);

}  // namespace magicmass::equality
