// SPDX-License-Identifier: GPL-2.0-or-later
// Calls one scalar function so many times on everyday inputs, for callgrind to count instructions.
//   scalar_calls FUNCTION CALLS
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "magicmass/accurate.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/fast.hpp"
#include "report/transcription.hpp"

using namespace magicmass;

namespace {

double sum(const generated::Velocities<double>& v) { return v.a + v.b + v.c + v.c_prime; }
double sum(const Terminal& v) { return v.a_t + v.b_t + v.c_t; }

/// a_t, b_t, c_t as anybody would: the naive counts, then the naive velocities at both.
double naive_terminal(double alpha) {
  const Counts counts = report::transcription::counts(alpha);
  const auto at_A = report::transcription::velocities(alpha, counts.N_A);
  const auto at_B = report::transcription::velocities(alpha, counts.N_B);
  return at_A.a + at_B.b + (counts.N_A == counts.N_B ? at_B.c_prime : at_A.c);
}

struct Named {
  const char* name;
  double (*call)(double alpha, std::int64_t n);
};
constexpr Named functions[] = {
    {"nothing", [](double alpha, std::int64_t) { return alpha; }},
    {"naive_velocities",
     [](double alpha, std::int64_t n) { return sum(report::transcription::velocities(alpha, n)); }},
    {"fast_velocities",
     [](double alpha, std::int64_t n) { return sum(fast::velocities(alpha, n)); }},
    {"accurate_velocities",
     [](double alpha, std::int64_t n) { return sum(accurate::velocities(alpha, n)); }},
    {"naive_terminal", [](double alpha, std::int64_t) { return naive_terminal(alpha); }},
    {"fast_terminal", [](double alpha, std::int64_t) { return sum(*fast::terminal(alpha)); }},
    {"accurate_terminal",
     [](double alpha, std::int64_t) { return sum(*accurate::terminal(alpha)); }},
    {"naive_counts",
     [](double alpha, std::int64_t) {
       return static_cast<double>(report::transcription::counts(alpha).N_A);
     }},
    {"exact_counts",
     [](double alpha, std::int64_t) { return static_cast<double>(count_collisions(alpha)->N_A); }},
};

}  // namespace

int main(int arguments, char** values) {
  if (arguments != 3) return 2;
  for (const Named& function : functions) {
    if (std::strcmp(function.name, values[1]) != 0) continue;
    double total = 0;
    const long calls = std::strtol(values[2], nullptr, 10);
    for (long i = 0; i < calls; ++i) {
      const double alpha = 1e-4 + static_cast<double>(i * 7919 % 10007) / 10008;  // below 1
      total += function.call(alpha, 1 + i % 2 * (alpha < 0.4 ? 1 : 0));
    }
    std::printf("%g\n", total);  // and so no call is left out
    return std::isfinite(total) ? 0 : 1;
  }
  return 2;
}
