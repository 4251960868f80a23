// Everyday and hard mass ratios, and cycles to ask for; all from whole random numbers, so that a
// seed gives the same rows everywhere but for libm's last bits. What the oracle answers to them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/oracle/certain.hpp"

namespace magicmass::testing {
using Random = std::mt19937_64;
inline double uniform(Random& random) { return double(random() >> 11) * 0x1p-53; }
inline double log_uniform(Random& random, double low, double high) {
  return std::exp(std::log(low) + (std::log(high) - std::log(low)) * uniform(random));
}
/// So many doubles above x, or below.
inline double neighbour(double x, std::int64_t steps) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + steps);
}
/// At most so many doubles away from x.
inline double some_neighbour(Random& random, double x, std::int64_t most) {
  return neighbour(x, std::int64_t(random() % std::uint64_t(2 * most + 1)) - most);
}
inline std::int64_t some_whole(Random& random, double high) {
  return std::int64_t(std::floor(log_uniform(random, 1, high)));
}
inline double pick(Random& random, const std::vector<double>& values) {
  return values[random() % values.size()];
}

struct Family {
  std::string name;
  double (*alpha)(Random&);
};
inline const std::vector<Family> families{
    {"everyday", [](Random& r) { return log_uniform(r, 1e-4, 10); }},
    {"wide", [](Random& r) { return log_uniform(r, 1e-12, 1e12); }},
    {"tiny", [](Random& r) { return log_uniform(r, 1e-300, 1e-30); }},
    {"many collisions", [](Random& r) { return log_uniform(r, 5.9e-38, 1e-18); }},
    {"subnormal", [](Random& r) { return std::bit_cast<double>(1 + r() % ((1ULL << 52) - 1)); }},
    {"huge", [](Random& r) { return neighbour(0x1.fffffffffffffp1023, -std::int64_t(r() >> 3)); }},
    {"any double", [](Random& r) { return std::bit_cast<double>(1 + r() % 0x7fefffffffffffff); }},
    {"magic neighbours",
     [](Random& r) { return some_neighbour(r, accurate::ratios(some_whole(r, 1e6)).magic, 3); }},
    {"deficient neighbours",
     [](Random& r) {
       return some_neighbour(r, accurate::ratios(some_whole(r, 1e6)).deficient, 3);
     }},
    {"far magic neighbours",
     [](Random& r) { return some_neighbour(r, accurate::ratios(some_whole(r, 0x1p50)).magic, 3); }},
    {"above 2^32 cycles", [](Random& r) { return log_uniform(r, 1e-24, 6e-20); }},
    {"near 2^53 cycles", [](Random& r) { return log_uniform(r, 1.2e-32, 1.9e-32); }},
    {"near powers of 2 less 1",
     [](Random& r) { return some_neighbour(r, std::ldexp(1.0, int(1 + r() % 53)) - 1, 1); }},
    {"closest to thresholds, and 1", [](Random& r) {
       return pick(r, {0x1.1c7397cb68b7ep-18, 0x1.bc7fb47556f22p-29, 1.0, neighbour(1, -1),
                       neighbour(1, 1), 0.5, 0x1p-53, 0x1.5acd9597016aap-968, 0x1p-1074});
     }}};

/// 0 to 3, one of the last two, or any between; `last` may be INT64_MAX.
inline std::int64_t some_index(Random& random, std::int64_t last) {
  const std::uint64_t way = random() % 5;
  if (way == 0) return std::min(std::int64_t(random() % 4), last);
  if (way <= 2) return last - std::int64_t(random() % 2);
  if (way == 3) return std::int64_t(random() % (std::uint64_t(last) + 1));
  return std::int64_t(std::fmin(std::floor(log_uniform(random, 1, 0x1p62)), double(last / 2)));
}
/// Where N_A + N_B is beyond 63 bits, any number below 2^62.
inline std::int64_t some_cycle(Random& random, double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  return some_index(random, counts ? counts->N_A : INT64_MAX / 2);
}
/// N_A + N_B, or INT64_MAX.
inline std::int64_t number_of_collisions(double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  return counts ? counts->N_A + counts->N_B : INT64_MAX;
}
inline std::int64_t some_collision(Random& random, double alpha) {
  return some_index(random, number_of_collisions(alpha) - 1);
}
inline std::string in_hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

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
