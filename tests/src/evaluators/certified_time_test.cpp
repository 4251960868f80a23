// SPDX-License-Identifier: GPL-2.0-or-later
// How long certified results take, family by family. Measures and reports; the one check is that there is something
// to report. `ctest -L time` runs it, CI does not.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/counts.hpp"
#include "magicmass/evaluators/certified_angles.hpp"
#include "magicmass/evaluators/certified_encounters.hpp"
#include "magicmass/evaluators/certified_velocities.hpp"
#include "report/family.hpp"
#include "report/transcription.hpp"

using namespace magicmass;
using report::Input;

namespace {

/// Nanoseconds of the median and of the slowest call, each input's being the best of five.
template <class Call>
void measure(const std::string& quantity, const char* label, const Call& call) {
  for (const report::Family& family : report::families(quantity, 200)) {
    std::vector<double> times;
    double sum = 0;
    for (const Input& input : family.inputs) {
      double best = 1e12;
      for (int repetition = 0; repetition < 5; ++repetition) {
        const auto start = std::chrono::steady_clock::now();
        sum += call(input);
        const std::chrono::duration<double, std::nano> time =
            std::chrono::steady_clock::now() - start;
        best = std::min(best, time.count());
      }
      times.push_back(best);
    }
    REQUIRE_FALSE(std::isnan(sum));  // and so nothing is thrown away
    std::sort(times.begin(), times.end());
    std::printf("%-16s %-22s median %8.0f ns, slowest %8.0f ns\n", label, family.name.c_str(),
                times[times.size() / 2], times.back());
  }
}

/// Nanoseconds a call over a whole family, the best of many rounds.
template <class Call>
double throughput(const std::vector<Input>& inputs, const Call& call) {
  double best = 1e12;
  for (int round = 0; round < 50; ++round) {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0;
    for (const Input& input : inputs) sum += static_cast<double>(call(input.alpha).N_A);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    REQUIRE(std::fabs(sum) > 0);
    best = std::min(best, time.count() / static_cast<double>(inputs.size()));
  }
  return best;
}

}  // namespace

TEST_CASE("time of a certified result", "[time]") {
  measure("velocities", "four velocities", [](const Input& input) {
    const auto v = certified_velocities(input.alpha, input.index);
    return v.a + v.b + v.c + v.c_prime;
  });
  measure("velocities", "b alone", [](const Input& input) {
    return certified_velocity(Velocity::b, input.alpha, input.index);
  });
  measure("encounters", "t and s", [](const Input& input) {
    const auto encounter = certified_encounters(input.alpha, input.index);
    return encounter.t + encounter.s;
  });
  measure("angle", "psi", [](const Input& input) { return certified_angle(input.alpha); });
  measure("ratios", "alpha_k, beta_k", [](const Input& input) {
    const auto ratios = certified_ratios(input.index);
    return ratios.magic + ratios.deficient;
  });
}

TEST_CASE("time of a count, and its ratio to the paper's formula", "[time]") {
  for (const report::Family& family : report::families("counts", 2000)) {
    const double naive = throughput(
        family.inputs, [](double alpha) { return report::transcription::counts<double>(alpha); });
    const double exact = throughput(family.inputs, [](double alpha) {
      return count_collisions(alpha).value_or(Counts{1, 1});
    });
    std::printf("%-22s naive %7.1f ns, exact %9.1f ns, ratio %7.2f\n", family.name.c_str(), naive,
                exact, exact / naive);
  }
}
