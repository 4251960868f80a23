// Equal formulas, unequal errors: the same velocities by five evaluators, against exact fractions.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <cln/cln.h>

#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/fast.hpp"
#include "magicmass/plain/closed.hpp"
#include "magicmass/plain/product.hpp"
#include "magicmass/plain/tangent.hpp"

using namespace magicmass;

cln::cl_RA exact(double x) { return cln::rational(cln::cl_R(x)); }
// In units of the last digit that a double has there.
double error(double got, const cln::cl_RA& wanted) {
  const double near = std::fabs(cln::double_approx(wanted));
  const cln::cl_RA unit = exact(std::nextafter(near, INFINITY)) - exact(near);
  return cln::double_approx(cln::abs(exact(got) - wanted) / unit);
}
// The worst of these cycles, in words that are far apart: the last digits depend on the C library.
void print_worst(const auto& evaluate, double alpha, std::int64_t first, std::int64_t last) {
  double ulp = 0;
  for (std::int64_t n = first; n <= last; ++n) {
    const auto got = evaluate(alpha, n);
    const auto wanted = generated::velocities_exact(exact(alpha), n);
    ulp = std::max({ulp, error(got.a, wanted.a), error(got.b, wanted.b), error(got.c, wanted.c),
                    error(got.c_prime, wanted.c_prime)});
  }
  std::printf(" | %s", ulp <= 0.5    ? "nearest"
                       : ulp <= 10   ? "last digit"
                       : ulp <= 1e4  ? "few lost"
                       : ulp <= 1e12 ? "many lost"
                                     : "none right");
}
void print_row(const char* what, double alpha, std::int64_t first, std::int64_t last) {
  std::printf("  %s", what);
  print_worst(generated::velocities_closed<double>, alpha, first, last);
  print_worst(generated::velocities_product<double>, alpha, first, last);
  print_worst(generated::velocities_tangent<double>, alpha, first, last);
  print_worst([](double x, auto n) { return fast::velocities(x, n); }, alpha, first, last);
  print_worst([](double x, auto n) { return accurate::velocities(x, n); }, alpha, first, last);
  std::printf("\n");
}

int main() {
  constexpr int bits = std::numeric_limits<double>::digits;
  std::printf("bits: %d\ndecimals: %.0f\n", bits, bits * std::log10(2));
  const double closest = 0x1.1c7397cb68b7ep-18;  // very close to alpha_539: the ball nearly stops
  std::printf("errors:\n  input | paper | products | tangents | fast | accurate\n");
  print_row("one half, first cycle", 0.5, 1, 1);
  print_row("one thousandth, all cycles", 0.001, 1, 35);
  print_row("one part in a billion, ten cycles", 1e-9, 40, 49);
  print_row("nearest to alpha_3, last cycle", accurate::ratios(3).magic, 3, 3);
  print_row("closest to a threshold, last cycle", closest, 539, 539);
  print_row("one million, first cycle", 1e6, 1, 1);

  const auto c_prime = [](double x) { return generated::velocities_exact(exact(x), 539).c_prime; };
  std::printf("by_fast: %.17g\nby_accurate: %.17g\n", fast::velocities(closest, 539).c_prime,
              accurate::velocities(closest, 539).c_prime);
  std::printf("neighbours:\n  input | exact velocity of the ball\n");
  for (const double alpha : {std::nextafter(closest, 0), closest, std::nextafter(closest, 1)})
    std::printf("  %.17g | %.9e\n", alpha, cln::double_approx(c_prime(alpha)));
}
