// SPDX-License-Identifier: GPL-2.0-or-later
// What several threads gain on arrays past the cache, as ratios in one run. Measures and reports; `ctest -L time` runs it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/parallel.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

constexpr std::size_t how_many = std::size_t{1} << 21U;

template <class Call>
double nanoseconds_a_row(const Call& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  return time.count() / static_cast<double>(how_many);
}

/// Of all threads: twice as much work shows here where two threads hide it.
template <class Call>
double processor_nanoseconds_a_row(const Call& call) {
  const std::clock_t start = std::clock();
  call();
  return static_cast<double>(std::clock() - start) * (1e9 / CLOCKS_PER_SEC) /
         static_cast<double>(how_many);
}

template <class Serial, class Parallel>
void compare(const char* what, const Serial& serial, const Parallel& parallel) {
  std::vector<double> alone, together, ratios;
  for (int round = 0; round < 9; ++round) {
    alone.push_back(nanoseconds_a_row(serial));
    together.push_back(nanoseconds_a_row(parallel));
    ratios.push_back(alone.back() / together.back());
  }
  for (auto* times : {&alone, &together, &ratios}) std::sort(times->begin(), times->end());
  const double work = processor_nanoseconds_a_row(parallel) / processor_nanoseconds_a_row(serial);
  std::printf(
      "%-20s 1 thread %6.2f ns a row, %u threads %6.2f ns, speed-up %.2f (%.2f to %.2f), "
      "processor time %.2f of 1 thread's\n",
      what, alone[4], Threads::all().count, together[4], ratios[4], ratios[0], ratios[8], work);
}

}  // namespace

TEST_CASE("speed-up of all processors on two million how_many", "[time]") {
  testing::Generator generator(2);
  std::vector<double> alpha(how_many), a(how_many), b(how_many), c(how_many), d(how_many);
  std::vector<std::int64_t> n(how_many), N_A(how_many), N_B(how_many);
  for (double& x : alpha) x = testing::log_uniform(generator, 1e-4, 1);
  count_collisions(alpha, N_A, N_B);
  for (std::size_t i = 0; i < how_many; ++i) n[i] = testing::whole(generator, 0, N_A[i]);
  const Threads all = Threads::all();
  compare(
      "counts", [&] { count_collisions(alpha, N_A, N_B); },
      [&] { count_collisions(alpha, N_A, N_B, all); });
  compare(
      "fast velocities", [&] { fast::velocities(alpha, n, a, b, c, d); },
      [&] { fast::velocities(alpha, n, a, b, c, d, all); });
  compare(
      "accurate velocities", [&] { accurate::velocities(alpha, n, a, b, c, d); },
      [&] { accurate::velocities(alpha, n, a, b, c, d, all); });
  compare(
      "fast terminal", [&] { fast::terminal(alpha, N_A, N_B, a, b, c); },
      [&] { fast::terminal(alpha, N_A, N_B, a, b, c, all); });
  compare(
      "accurate terminal", [&] { accurate::terminal(alpha, N_A, N_B, a, b, c); },
      [&] { accurate::terminal(alpha, N_A, N_B, a, b, c, all); });
  CHECK(std::isfinite(a[0] + d[0]));
}
