// SPDX-License-Identifier: GPL-2.0-or-later
// Equal formulas, unequal errors: the same velocities by five evaluators,
// measured against exact fractions.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <cln/rational.h>

#include "magicmass/accurate.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/velocities_closed.hpp"
#include "magicmass/velocities_product.hpp"
#include "magicmass/velocities_tangent.hpp"

namespace generated = magicmass::generated;
namespace reference = magicmass::reference;
using Velocities = generated::Velocities<double>;
using Evaluator = std::function<Velocities(double, std::int64_t)>;

const std::vector<std::pair<std::string, Evaluator>> evaluators{
    {"paper", generated::velocities_closed<double>},
    {"products", generated::velocities_product<double>},
    {"tangents", generated::velocities_tangent<double>},
    {"fast", magicmass::fast::velocities},
    {"accurate", magicmass::accurate::velocities}};

// The largest error of the four velocities, in units of the last digit that a
// double has there.
double worst_ulp(const Velocities& got, double alpha, std::int64_t n) {
  const auto exact =
      reference::exact_velocities(reference::exact(alpha), static_cast<long>(n));
  return std::max({reference::ulp_error(got.a, exact.a),
                   reference::ulp_error(got.b, exact.b),
                   reference::ulp_error(got.c, exact.c),
                   reference::ulp_error(got.c_prime, exact.c_prime)});
}

// In classes that are far apart: the last digit of sines and cosines differs
// between C libraries.
std::string in_words(double ulp) {
  if (ulp <= 0.5) return "nearest";
  if (ulp <= 16) return "last digit";
  if (ulp <= 1e4) return "few lost";
  if (ulp <= 1e12) return "many lost";
  return "none right";
}

void print_row(const char* what, double alpha, std::int64_t first,
               std::int64_t last) {
  std::printf("  %s", what);
  for (const auto& [name, evaluate] : evaluators) {
    double worst = 0;
    for (std::int64_t n = first; n <= last; ++n)
      worst = std::max(worst, worst_ulp(evaluate(alpha, n), alpha, n));
    std::printf(" | %s", in_words(worst).c_str());
  }
  std::printf("\n");
}

int main() {
  std::printf("errors:\n  input");
  for (const auto& [name, evaluate] : evaluators)
    std::printf(" | %s", name.c_str());
  std::printf("\n");
  const double magic = magicmass::accurate::ratios(3).magic;
  // No double is closer to its threshold alpha_k; k = 539.
  const double closest = 0x1.1c7397cb68b7ep-18;
  print_row("one half, all cycles", 0.5, 1, magicmass::count_collisions(0.5)->N_B);
  print_row("one thousandth, all cycles", 0.001, 1,
            magicmass::count_collisions(0.001)->N_B);
  print_row("one part in a billion, ten cycles", 1e-9, 40, 49);
  print_row("nearest to alpha_3, last cycle", magic, 3, 3);
  print_row("closest to a threshold, last cycle", closest, 539, 539);
  print_row("ten to the 200, first cycle", 1e200, 1, 1);

  // The hardest of these: the ball after its last contact has nearly stopped.
  // What do the evaluators say?
  const auto exact = reference::exact_velocities(reference::exact(closest), 539);
  std::printf("exact: %s\n", reference::to_decimal(exact.c_prime, 25).c_str());
  std::printf("by_fast: %.17g\n",
              magicmass::fast::velocities(closest, 539).c_prime);
  std::printf("by_accurate: %.17g\n",
              magicmass::accurate::velocities(closest, 539).c_prime);

  // How much of that is the input's fault: the doubles around it.
  double alpha = closest;
  for (int step = 0; step < 5; ++step) alpha = std::nextafter(alpha, 0.0);
  std::string neighbours = "neighbours:\n  input | exact velocity of the ball\n";
  std::printf("around:\n  doubles away | exact velocity of the ball\n");
  for (int away = -5; away <= 5; ++away, alpha = std::nextafter(alpha, 1.0)) {
    const auto velocity =
        reference::exact_velocities(reference::exact(alpha), 539).c_prime;
    const std::string digits = reference::to_decimal(velocity, 10);
    std::printf("  %d | %s\n", away, digits.c_str());
    std::array<char, 32> input{};
    std::snprintf(input.data(), input.size(), "%.17g", alpha);
    if (std::abs(away) <= 1)
      neighbours += "  " + std::string(input.data()) + " | " + digits + "\n";
  }
  std::printf("%s", neighbours.c_str());
}
