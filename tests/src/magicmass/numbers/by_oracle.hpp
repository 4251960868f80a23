// The oracle's answers in the types of the numeric functions.
#pragma once

#include "magicmass/numbers/values.hpp"
#include "magicmass/oracle/certain.hpp"

namespace magicmass::testing {
inline cln::cl_I whole(std::int64_t n) { return static_cast<long long>(n); }
/// The doubles nearest to it.
std::vector<double> nearest_doubles(double alpha, const auto& quantity) {
  return oracle::certain(oracle::ratio(oracle::exact(alpha)), quantity, oracle::to_double());
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
}  // namespace magicmass::testing
