// SPDX-License-Identifier: GPL-2.0-or-later
// The stream against the oracle that knows only the collision law, at n up to 2^40 and beyond.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

using Row = std::array<cln::cl_RA, 4>;
constexpr double allowed_eps = 3.0;  // stated in batch.hpp

Row exact_row(double alpha, std::int64_t n) {
  const auto row = reference::velocities_within(alpha, cln::cl_I(static_cast<long>(n)), 80);
  return {row.a, row.b, row.c, row.c_prime};
}

/// A lower bound of the largest velocity of each column's body: that at a few n that come near it.
std::array<double, 4> largest_of_body(double alpha, std::int64_t N_A) {
  std::array<double, 4> largest{};
  for (const std::int64_t n : {std::int64_t{0}, std::int64_t{1}, N_A / 2, N_A / 2 + 1, N_A}) {
    const Row row = exact_row(alpha, std::min(n, N_A));
    for (std::size_t v = 0; v < 4; ++v) {
      largest[v] = std::max(largest[v], std::fabs(cln::double_approx(row[v])));
    }
  }
  largest[2] = largest[3] = std::max(largest[2], largest[3]);
  return largest;
}

double error_in_eps(double got, const cln::cl_RA& exact, double largest) {
  const cln::cl_RA difference = reference::exact(got) - exact;
  return std::fabs(cln::double_approx(difference)) /
         (largest * std::numeric_limits<double>::epsilon());
}

struct Window {
  std::int64_t first_n;
  std::array<std::vector<double>, 4> columns;

  Window(double alpha, std::int64_t n, std::size_t size) : first_n(n) {
    for (auto& column : columns) column.resize(size);
    velocity_stream(alpha, n, columns[0], columns[1], columns[2], columns[3]);
  }

  double largest_error(double alpha, const std::array<double, 4>& largest, std::size_t row) const {
    const Row exact = exact_row(alpha, first_n + static_cast<std::int64_t>(row));
    double error = 0.0;
    for (std::size_t v = 0; v < 4; ++v) {
      error = std::max(error, error_in_eps(columns[v][row], exact[v], largest[v]));
    }
    return error;
  }
};

}  // namespace

TEST_CASE("short streams are as exact as stated, row by row", "[check]") {
  testing::Generator generator(61);
  double worst = 0.0;
  for (int i = 0; i < 150; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-4, i % 5 == 0 ? 1e3 : 1.0);
    const std::int64_t N_A = count_collisions(alpha)->N_A;
    const auto largest = largest_of_body(alpha, N_A);
    const Window window(alpha, 0, static_cast<std::size_t>(N_A + 1));
    for (std::size_t row = 0; row < window.columns[0].size(); ++row) {
      const double error = window.largest_error(alpha, largest, row);
      INFO("alpha = " << alpha << ", n = " << row);
      REQUIRE(error <= allowed_eps);
      worst = std::max(worst, error);
    }
  }
  CHECK(worst > 0.3);  // rounding is there, so the measure sees it
}

TEST_CASE("the error does not grow with n, up to the last of 2^44 cycles", "[check]") {
  testing::Generator generator(62);
  for (int i = 0; i < 60; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-26, 1e-4);
    const std::int64_t N_A = count_collisions(alpha)->N_A;
    const auto largest = largest_of_body(alpha, N_A);
    for (const std::int64_t first_n : {std::int64_t{0}, testing::whole(generator, 0, N_A), N_A / 2,
                                       std::max(N_A - 900, std::int64_t{0})}) {
      const Window window(alpha, first_n, 901);
      for (int sample = 0; sample < 6; ++sample) {
        const std::int64_t last = std::min(N_A - first_n, std::int64_t{900});
        const auto row =
            static_cast<std::size_t>(sample == 0 ? last : testing::whole(generator, 0, last));
        INFO("alpha = " << alpha << ", n = " << first_n << " + " << row);
        REQUIRE(window.largest_error(alpha, largest, row) <= allowed_eps);
      }
    }
  }
}

TEST_CASE("a million rows from one anchor are as exact at the end as at the beginning", "[check]") {
  const double alpha = 1.2e-12;
  const std::int64_t N_A = count_collisions(alpha)->N_A;
  REQUIRE(N_A > 1'000'000);
  const auto largest = largest_of_body(alpha, N_A);
  const Window window(alpha, 0, static_cast<std::size_t>(N_A + 1));
  for (const std::size_t row :
       {std::size_t{1}, std::size_t{255}, std::size_t{256}, std::size_t{500'000},
        static_cast<std::size_t>(N_A - 1), static_cast<std::size_t>(N_A)}) {
    CHECK(window.largest_error(alpha, largest, row) <= allowed_eps);
  }
}

TEST_CASE("an error of more than the allowed would be seen", "[exam]") {
  const double alpha = 1e-3;
  const auto largest = largest_of_body(alpha, count_collisions(alpha)->N_A);
  Window window(alpha, 0, 10);
  window.columns[2][5] += 6 * largest[2] * std::numeric_limits<double>::epsilon();
  CHECK(window.largest_error(alpha, largest, 4) <= allowed_eps);
  CHECK(window.largest_error(alpha, largest, 5) > allowed_eps);
}
