// SPDX-License-Identifier: GPL-2.0-or-later
// The oracle's answers in the types of the numeric functions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <cln/float.h>
#include <cln/real.h>

#include "magicmass/numbers/values.hpp"
#include "magicmass/oracle/certain.hpp"

namespace magicmass::testing {
inline cln::cl_I whole(std::int64_t n) { return static_cast<long long>(n); }
/// The doubles nearest to it.
std::vector<double> nearest_doubles(double alpha, const auto& quantity) {
  return oracle::certain(oracle::ratio(oracle::exact(alpha)), quantity, oracle::to_double());
}
/// The largest |got - exact|/envelope; a zero has no envelope and is to be met.
double in_envelopes(const std::vector<double>& got, double alpha, const auto& quantity) {
  const oracle::MassRatio ratio = oracle::ratio(oracle::exact(alpha));
  const auto exact = oracle::certain(ratio, quantity, oracle::to_within(120));
  const std::vector<double> envelopes = oracle::envelopes(ratio, quantity);
  double most = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double error = oracle::ulp_error(got[i], exact[i]);
    if (error > 0) most = std::max(most, std::isinf(envelopes[i]) ? 1e300 : error / envelopes[i]);
  }
  return most;
}
inline oracle::AtEnd at_end(const Counts& counts) {
  return oracle::AtEnd({whole(counts.N_A), whole(counts.N_B)});
}
inline std::optional<Counts> counts_by_oracle(double alpha) {
  const oracle::Counts counts = oracle::count_collisions(oracle::exact(alpha));
  if (cln::integer_length(counts.N_A + counts.N_B) > 63) return std::nullopt;
  return Counts{cln::cl_I_to_long(counts.N_A), cln::cl_I_to_long(counts.N_B)};
}
inline Velocities velocities_by_oracle(double alpha, std::int64_t n) {
  const auto v = nearest_doubles(alpha, oracle::OfCycle(whole(n)));
  return {v[0], v[1], v[2], v[3]};
}
inline Terminal terminal_by_oracle(double alpha, const Counts& counts) {
  const auto v = nearest_doubles(alpha, at_end(counts));
  return {counts, v[0], v[1], v[2], v[3]};
}
inline Collision collision_by_oracle(double alpha, std::int64_t j) {
  const auto c = nearest_doubles(alpha, oracle::AtCollision(whole(j)));
  return {c[0], c[1]};
}
inline Ratios ratios_by_oracle(std::int64_t k) {
  const auto rounded = [](const oracle::MassRatio& ratio) {
    return oracle::certain(ratio, oracle::Itself(), oracle::to_double())[0];
  };
  return {rounded(oracle::magic(whole(k))), rounded(oracle::deficient(whole(k)))};
}
/// psi = 2 atan(sqrt(alpha (2 + alpha))), from floats of 300 digits.
inline double angle_by_oracle(double alpha) {
  const cln::cl_R x = cln::cl_float(oracle::exact(alpha), cln::float_format(300));
  return oracle::nearest(cln::rational(2 * cln::atan(cln::sqrt(x * (x + 2)))));
}
inline double envelopes_of(const Velocities& got, double alpha, std::int64_t n) {
  return in_envelopes({got.a, got.b, got.c, got.c_prime}, alpha, oracle::OfCycle(whole(n)));
}
inline double envelopes_of(const Collision& got, double alpha, std::int64_t j) {
  return in_envelopes({got.t, got.s}, alpha, oracle::AtCollision(whole(j)));
}
inline double envelopes_of(const Terminal& got, double alpha) {
  return in_envelopes({got.a_t, got.b_t, got.c_t, got.rho}, alpha, at_end(got.counts));
}
inline std::string in_hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}
}  // namespace magicmass::testing
