// SPDX-License-Identifier: GPL-2.0-or-later
#include "src/magicmass/numbers/by_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <cln/float.h>
#include <cln/real.h>

#include "magicmass/oracle/certain.hpp"

namespace magicmass::testing {
namespace {
cln::cl_I whole(std::int64_t n) { return static_cast<long long>(n); }
/// |got - exact|/envelope; a zero has no envelope and is to be met.
double largest(const std::vector<double>& got, double alpha, const auto& quantity) {
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
oracle::AtEnd at_end(const Counts& counts) {
  return oracle::AtEnd({whole(counts.N_A), whole(counts.N_B)});
}
}  // namespace

std::optional<Counts> counts_by_oracle(double alpha) {
  const oracle::Counts counts = oracle::count_collisions(oracle::exact(alpha));
  if (cln::integer_length(counts.N_A + counts.N_B) > 63) return std::nullopt;
  return Counts{cln::cl_I_to_long(counts.N_A), cln::cl_I_to_long(counts.N_B)};
}
Velocities velocities_by_oracle(double alpha, std::int64_t n) {
  const auto v = oracle::certain(oracle::ratio(oracle::exact(alpha)), oracle::OfCycle(whole(n)),
                                 oracle::to_double());
  return {v[0], v[1], v[2], v[3]};
}
Terminal terminal_by_oracle(double alpha, const Counts& counts) {
  const auto v =
      oracle::certain(oracle::ratio(oracle::exact(alpha)), at_end(counts), oracle::to_double());
  return {counts, v[0], v[1], v[2], v[3]};
}
Collision collision_by_oracle(double alpha, std::int64_t j) {
  const auto c = oracle::certain(oracle::ratio(oracle::exact(alpha)), oracle::AtCollision(whole(j)),
                                 oracle::to_double());
  return {c[0], c[1]};
}
Ratios ratios_by_oracle(std::int64_t k) {
  const auto rounded = [](const oracle::MassRatio& ratio) {
    return oracle::certain(ratio, oracle::Itself(), oracle::to_double())[0];
  };
  return {rounded(oracle::magic(whole(k))), rounded(oracle::deficient(whole(k)))};
}
double angle_by_oracle(double alpha) {
  const cln::cl_R x = cln::cl_float(oracle::exact(alpha), cln::float_format(300));
  return oracle::nearest(cln::rational(2 * cln::atan(cln::sqrt(x * (x + 2)))));
}
double envelopes_of(const Velocities& got, double alpha, std::int64_t n) {
  return largest({got.a, got.b, got.c, got.c_prime}, alpha, oracle::OfCycle(whole(n)));
}
double envelopes_of(const Collision& got, double alpha, std::int64_t j) {
  return largest({got.t, got.s}, alpha, oracle::AtCollision(whole(j)));
}
double envelopes_of(const Terminal& got, double alpha) {
  return largest({got.a_t, got.b_t, got.c_t, got.rho}, alpha, at_end(got.counts));
}
std::string in_hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}
}  // namespace magicmass::testing
