// SPDX-License-Identifier: GPL-2.0-or-later
// Tracked numbers are as good as their degree says, and the rounding test allows for the highest degree of any generated
// formula. Here the generated kernels are evaluated in degrees alone.
#include <algorithm>

#include <catch2/catch.hpp>

#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/kernels/angle.hpp"
#include "magicmass/kernels/encounters.hpp"
#include "magicmass/kernels/ratios.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/velocities.hpp"

using namespace magicmass;

namespace {

/// Of a tracked number: what it costs at most in units of its size.
struct Degree {
  using Real = double;

  int count = 0;

  Degree() = default;
  explicit Degree(double) {}
  static Degree of(int count) {
    Degree degree;
    degree.count = count;
    return degree;
  }
  static Degree sum(double, double) { return of(0); }
  static Degree product(double, double) { return of(0); }
  static Degree pi() { return of(0); }

  friend Degree operator-(Degree x) { return x; }
  friend Degree operator+(Degree x, Degree y) { return of(std::max(x.count, y.count)); }
  friend Degree operator-(Degree x, Degree y) { return x + y; }
  friend Degree operator+(Degree x, double) { return x; }
  friend Degree operator*(Degree x, Degree y) { return of(x.count + y.count); }
  friend Degree operator*(Degree x, double) { return x; }
  friend Degree scaled(Degree x, double) { return x; }
  friend Degree select(bool, Degree yes, Degree no) { return yes + no; }
  friend Degree reciprocal(Degree x) { return x; }
  // each primitive makes numbers of degree 1
  friend Degree reciprocal_square_root(Degree) { return of(1); }
  friend Degree half_arcsecant(double, Degree) { return of(1); }
  friend arithmetic::SineCosine<Degree> sine_cosine(Degree) { return {of(1), of(1)}; }
};

int count(Degree x) { return x.count; }
int count(const arithmetic::Product<Degree>& x) { return evaluated(x).count; }

template <class Result>
int highest(const Result& all) {
  int most = 0;
  for (const auto& member : as_array(all)) most = std::max(most, count(member));
  return most;
}

}  // namespace

TEST_CASE("no generated formula is of a higher degree than the rounding test allows for",
          "[exam]") {
  for (const double alpha : {0.1, 2.0}) {
    const int degrees[] = {
        highest(generated::VelocitiesKernel<Degree>::evaluate(alpha, 1.0)),
        highest(generated::EncountersKernel<Degree>::evaluate(alpha, 1.0)),
        highest(generated::TerminalKernel<Degree>::evaluate(alpha, 1.0, 1.0)),
        highest(generated::RatiosKernel<Degree>::evaluate(1.0)),
        generated::AngleKernel<Degree>::evaluate(alpha).count,
    };
    for (const int degree : degrees) {
      CHECK(degree <= arithmetic::Tracked<double>::highest_degree);
    }
    if (alpha < 1.0) CHECK(degrees[2] == 8);  // rho, the highest
  }
}
