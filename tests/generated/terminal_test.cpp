// SPDX-License-Identifier: GPL-2.0-or-later
// Terminal velocities against certified digits of the velocities after each block's last collision.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>
#include <cln/integer.h>
#include <cln/real.h>
#include <nlohmann/json.hpp>

#include "magicmass/evaluators/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/terminal_offset.hpp"

using namespace magicmass;

namespace {

double eps_bound(const std::string& name) {
  std::ifstream file(std::filesystem::path(MAGICMASS_GENERATED) / "manifest.json");
  const nlohmann::json manifest = nlohmann::json::parse(file);
  for (const auto& entry : manifest.at("evaluators"))
    if (entry.at("name") == name) return entry.at("eps_bound");
  throw std::out_of_range(name);
}

struct Exact {
  Counts counts;
  cln::cl_RA a, b, c;
};

Exact exact_terminal(double alpha) {
  const Counts counts = count_collisions(alpha).value();
  const auto after = [alpha](std::int64_t n) {
    return reference::velocities_within(MassRatio(alpha), cln::cl_I(static_cast<long>(n)), 200);
  };
  const auto of_A = after(counts.N_A), of_B = after(counts.N_B);
  return {counts, of_A.a, of_B.b, counts.N_A == counts.N_B ? of_B.c_prime : of_A.c};
}

// In eps: of V for the blocks and of 1 for rho; for the ball of the largest velocity that it has at that alpha.
template <class Real, class Evaluate>
double largest_error(double low, double high, int count, const Evaluate& evaluate) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(low, high);
  double largest = 0;
  for (int i = 0; i < count; ++i) {
    const auto alpha = static_cast<double>(static_cast<float>(std::pow(10, exponent(random))));
    const Exact exact = exact_terminal(alpha);
    const generated::Terminal<Real> got = evaluate(static_cast<Real>(alpha), exact.counts);
    const double ball = std::max(1.0, (1 + std::sqrt(2 * (1 + alpha) / alpha)) / (2 + alpha));
    const auto error = [](Real value, const cln::cl_RA& expected) {
      return cln::double_approx(cln::abs(reference::exact(value) - expected)) /
             static_cast<double>(std::numeric_limits<Real>::epsilon());
    };
    largest = std::max({largest, error(got.a, exact.a), error(got.b, exact.b),
                        error(got.c, exact.c) / ball, error(got.rho, exact.b * exact.b)});
  }
  return largest;
}

}  // namespace

TEMPLATE_TEST_CASE("terminal velocities keep the bound that their form promises", "[check]", float,
                   double, long double) {
  const auto from_counts = [](TestType alpha, const Counts& counts) {
    return generated::terminal_offset(alpha, counts.N_A, counts.N_B);
  };
  const double promised = eps_bound("terminal_offset");
  CHECK(largest_error<TestType>(-8, 0, 600, from_counts) <= promised);
  CHECK(largest_error<TestType>(0, 8, 200, from_counts) <= promised);
  if (sizeof(TestType) > sizeof(float))
    CHECK(largest_error<TestType>(-30, -8, 300, from_counts) <= promised);
}

TEST_CASE("with a count that is one off they would not: the bound can fail", "[exam]") {
  CHECK(largest_error<double>(-4, 0, 20, [](double alpha, const Counts& counts) {
          return generated::terminal_offset(alpha, counts.N_A + 1, counts.N_B);
        }) > 1e6);
}
