// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/alpha_sources.hpp"

#include <cmath>
#include <limits>

#include "magicmass/reference/ratios.hpp"

namespace magicmass::report {
namespace {

constexpr std::int64_t largest_k = 1000000;
constexpr double largest_double = std::numeric_limits<double>::max();
constexpr double smallest_normal = std::numeric_limits<double>::min();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
/// The thresholds closest to a double, near alpha_539 and beta_19530.
constexpr double closest_magic = 0x1.1c7397cb68b7ep-18;
constexpr double closest_deficient = 0x1.bc7fb47556f22p-29;

void add_neighbours(std::vector<Alpha>& all, double x, std::int64_t k, int reach) {
  for (int step = 0; step < reach; ++step) x = std::nextafter(x, 0.0);
  for (int step = -reach; step <= reach; ++step) {
    all.push_back({x, k});
    x = std::nextafter(x, largest_double);
  }
}

template <class Draw>
std::vector<Alpha> drawn(std::size_t size, const Draw& draw) {
  std::vector<Alpha> all;
  for (std::size_t i = 0; i < size; ++i) all.push_back({draw()});
  return all;
}

/// Threshold after threshold with the doubles around it, k from 1 on with a uniform number of digits.
template <class Ratio>
std::vector<Alpha> neighbours(PortableRandom& random, std::size_t size, std::int64_t most,
                              int reach) {
  std::vector<Alpha> all;
  while (all.size() < size) {
    const std::int64_t k = random.log_whole(most);
    add_neighbours(all, reference::nearest_ratio<double>(Ratio{k}), k, reach);
  }
  all.resize(size);
  return all;
}

std::vector<Alpha> closest(PortableRandom&, std::size_t size) {
  std::vector<Alpha> all;
  while (all.size() < size) {
    add_neighbours(all, closest_magic, 539, 3);
    add_neighbours(all, closest_deficient, 19530, 3);
  }
  all.resize(size);
  return all;
}

std::vector<Alpha> zeros(PortableRandom& random, std::size_t size) {
  return neighbours<Magic>(random, size, std::int64_t{1} << 50U, 1);
}

std::vector<Alpha> magic(PortableRandom& random, std::size_t size) {
  return neighbours<Magic>(random, size, largest_k, 3);
}

std::vector<Alpha> deficient(PortableRandom& random, std::size_t size) {
  return neighbours<Deficient>(random, size, largest_k, 3);
}

std::vector<Alpha> near_2_53(PortableRandom& random, std::size_t size) {
  return drawn(size, [&] { return random.ordinal(1.3e-32, 1.8e-32); });
}

std::vector<Alpha> long_runs(PortableRandom& random, std::size_t size) {
  return drawn(size, [&] { return random.log_uniform(1e-36, 1e-20); });
}

std::vector<Alpha> tiny(PortableRandom& random, std::size_t size) {
  return drawn(size, [&] { return random.log_uniform(1e-300, 1e-30); });
}

std::vector<Alpha> small(PortableRandom& random, std::size_t size) {
  return drawn(size, [&] { return random.log_uniform(5.9e-38, 1e-30); });
}

std::vector<Alpha> subnormal(PortableRandom& random, std::size_t size) {
  std::vector<Alpha> all{{smallest}, {smallest_normal}, {std::nextafter(smallest_normal, 0.0)}};
  // as many leading zeros as one likes, else nearly all would be near the normal range
  while (all.size() < size)
    all.push_back({smallest * static_cast<double>(random.log_whole((std::int64_t{1} << 52U) - 1))});
  all.resize(size);
  return all;
}

std::vector<Alpha> huge(PortableRandom& random, std::size_t size) {
  std::vector<Alpha> all{{largest_double}, {0x1p1023}, {1e155}, {1e154}, {0x1p512}, {1e16}};
  while (all.size() < size) all.push_back({random.log_uniform(1e3, largest_double)});
  all.resize(size);
  return all;
}

std::vector<Alpha> one(PortableRandom&, std::size_t size) {
  std::vector<Alpha> all;
  add_neighbours(all, 1.0, 1, 3);
  for (const Alpha& alpha : std::vector<Alpha>(all)) all.push_back(alpha);  // n = 0 and n = 1
  if (all.size() > size) all.resize(size);
  return all;
}

std::vector<Alpha> wide(PortableRandom& random, std::size_t size) {
  return drawn(size, [&] { return random.log_uniform(1e-20, 1e2); });
}

std::vector<Alpha> any(PortableRandom& random, std::size_t size) {
  return drawn(size, [&] { return random.ordinal(smallest, largest_double); });
}

std::vector<Alpha> everyday(PortableRandom& random, std::size_t size) {
  return drawn(size, [&] { return random.log_uniform(1e-6, 10.0); });
}

}  // namespace

const std::vector<AlphaSource>& alpha_sources() {
  static const std::vector<AlphaSource> all{
      {"closest thresholds", "the two thresholds closest to a double, and 3 ulp around them", 1,
       Pick::around_threshold, closest},
      {"zeros", "alpha_k and 1 ulp around it, k to 2^50, where a_k and c'_k all but vanish", 2,
       Pick::at_threshold, zeros},
      {"magic neighbours", "alpha_k and 3 ulp around it, k to 1e6", 3, Pick::around_threshold,
       magic},
      {"deficient neighbours", "beta_k and 3 ulp around it, k to 1e6", 4, Pick::around_threshold,
       deficient},
      {"N near 2^53", "alpha near 1.5e-32: the last cycles' n hardly fits a double", 5,
       Pick::near_the_last, near_2_53},
      {"n above 2^32", "alpha 1e-36 to 1e-20, n beyond 2^32", 6, Pick::beyond_2_32, long_runs},
      {"tiny alpha", "alpha 1e-300 to 1e-30, log-uniform", 7, Pick::few, tiny, false},
      {"small alpha", "alpha 5.9e-38 to 1e-30, the least with counts below 2^63", 8, Pick::few,
       small},
      {"subnormal alpha", "alpha below 2.3e-308", 9, Pick::few, subnormal, false},
      {"huge alpha", "alpha 1e3 to the largest double, log-uniform", 10, Pick::ends, huge},
      {"alpha = 1", "1 and 3 ulp around it", 11, Pick::ends, one},
      {"first and last", "alpha 1e-20 to 100, n = 0, 1, N-1, N", 12, Pick::ends, wide},
      {"any double", "every positive double alike", 13, Pick::anywhere, any, false},
      {"everyday", "alpha 1e-6 to 10, log-uniform", 14, Pick::anywhere, everyday},
  };
  return all;
}

}  // namespace magicmass::report
