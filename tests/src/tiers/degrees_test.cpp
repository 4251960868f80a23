// SPDX-License-Identifier: GPL-2.0-or-later
// Tracked numbers are as good as their degree says, and the rounding test allows for that of the formula. Here the generated kernels
// are evaluated in degrees alone.
#include <algorithm>

#include <catch2/catch.hpp>

#include "magicmass/arithmetic/tracked.hpp"
#include "magicmass/kernels/angle.hpp"
#include "magicmass/kernels/encounters.hpp"
#include "magicmass/kernels/ratios.hpp"
#include "magicmass/kernels/terminal.hpp"
#include "magicmass/kernels/velocities.hpp"
#include "magicmass/kernels/velocities_at_1.hpp"
#include "magicmass/kernels/velocities_at_2.hpp"

using namespace magicmass;

namespace {

/// Of a tracked number: what it costs at most in units of its size.
struct Degree {
  using Real = double;
  using ArcTangent = Degree;

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

/// The kernel's word for each of its results, and what comes out.
template <class Kernel, class Result>
void require_degrees(const Result& all) {
  const auto said = as_array(Kernel::degrees);
  const auto results = as_array(all);
  REQUIRE(said.size() == results.size());
  for (std::size_t i = 0; i < said.size(); ++i) {
    INFO("result " << i);
    CHECK(said[i] >= std::max(1, count(results[i])));
    CHECK(said[i] <= arithmetic::Tracked<double>::highest_degree);
  }
}

}  // namespace

TEST_CASE("each generated formula is of the degree that the rounding test allows for", "[exam]") {
  using namespace generated;
  for (const double alpha : {0.1, 2.0}) {
    require_degrees<VelocitiesKernel<Degree>>(VelocitiesKernel<Degree>::evaluate(alpha, 1.0));
    require_degrees<EncountersKernel<Degree>>(EncountersKernel<Degree>::evaluate(alpha, 1.0));
    require_degrees<TerminalKernel<Degree>>(TerminalKernel<Degree>::evaluate(alpha, 1.0, 1.0));
    require_degrees<VelocitiesAt1Kernel<Degree>>(VelocitiesAt1Kernel<Degree>::evaluate(alpha));
    require_degrees<VelocitiesAt2Kernel<Degree>>(VelocitiesAt2Kernel<Degree>::evaluate(alpha));
    CHECK(AngleKernel<Degree>::evaluate(alpha).count <=
          arithmetic::Tracked<double>::highest_degree);
  }
  require_degrees<RatiosKernel<Degree>>(RatiosKernel<Degree>::evaluate(1.0));
  // below alpha = 1 they are no higher than need be
  const auto terminal = TerminalKernel<Degree>::evaluate(0.1, 1.0, 1.0);
  CHECK(count(terminal.a_t) == TerminalKernel<Degree>::degrees.a_t);
  CHECK(count(terminal.rho) == TerminalKernel<Degree>::degrees.rho);
  const auto velocities = VelocitiesKernel<Degree>::evaluate(0.1, 1.0);
  CHECK(count(velocities.c) == VelocitiesKernel<Degree>::degrees.c);
}
