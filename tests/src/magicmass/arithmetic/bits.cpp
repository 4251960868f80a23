// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled once for each target: a fingerprint of all operations on many numbers.
#include <random>
#include <vector>

#include "magicmass/arithmetic/functions.hpp"
#include "magicmass/arithmetic/rounding_test.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {
std::uint64_t fingerprint();
namespace {
// Taylor's series: good enough to compare bits.
struct Series {
  static constexpr int size = 6;
  static constexpr int pairs = 3;
  static constexpr double centre = 0x1.5555555555556p-3;
  static constexpr double high[] = {1.0,
                                    -0x1.5555555555555p-3,
                                    0x1.1111111111111p-7,
                                    -0x1.a01a01a01a01ap-13,
                                    0x1.71de3a556c734p-19,
                                    -0x1p-26};
  static constexpr double low[] = {0.0, -0x1.5555555555555p-57, 0x1.1111111111111p-63};
};
struct Tier {
  using ArcTangent = Series;
  using Sine = Series;
  using Cosine = Series;
  using SmallSine = Series;
  using SmallCosine = Series;
};
template <class T>
struct Sample {
  T x, y;
  std::vector<T> results() const {
    using D = DoubleDouble<T>;
    const D a = two_product(x, y);
    const D b = two_sum(x, all<T>(0.3));
    const D root = reciprocal_root(a);
    const D t = quotient(scaled(a, 0.25), b);
    const D z = t * t;
    const D angle = arc_tangent<Tier>(root, z);
    const SineCosine<D> large = sine_cosine<Tier>(b);
    const SineCosine<D> small = sine_cosine_small<Tier>(scaled(a, 0.125));
    const D rest = cancelling_sum(a, -b), size = magnitude(times(rest, x));
    std::vector<T> all_of_them;
    for (const D& d : {a + b, root, t, z, angle, large.sine, large.cosine, small.sine, small.cosine,
                       rest, size, near_sum(b, -b), quotient(x, b)}) {
      all_of_them.push_back(d.high);
      all_of_them.push_back(d.low);
      all_of_them.push_back(rounding_test(d, all<T>(0x1p-60)).value);
    }
    all_of_them.push_back(nearest(x * 1000.0));
    all_of_them.push_back(times_sign_of(x, rest.high));
    return all_of_them;
  }
};
void mix(std::uint64_t& sum, double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  sum = (sum ^ bits) * 0x100000001b3 + (sum >> 29);
}
}  // namespace

std::uint64_t fingerprint() {
  std::mt19937_64 random(20261125);
  const auto uniform = [&] { return 0.3 + double(random() >> 11) * 0x1p-53; };
  std::uint64_t sum = 0;
  for (int row = 0; row < 2000; ++row) {
    constexpr int all_lanes = 8;
    double x[all_lanes], y[all_lanes];
    for (int k = 0; k < all_lanes; ++k) {
      x[k] = uniform();
      y[k] = uniform();
    }
    for (int first = 0; first < all_lanes; first += lanes) {
      const std::vector<Simd> many =
          Sample<Simd>{load<Simd>(x + first), load<Simd>(y + first)}.results();
      for (int k = 0; k < lanes; ++k) {
        const std::vector<double> one = Sample<double>{x[first + k], y[first + k]}.results();
        for (std::size_t i = 0; i < one.size(); ++i) {
          mix(sum, one[i]);
          // A lane that differs from the single number spoils the fingerprint.
          if (std::memcmp(&one[i], reinterpret_cast<const double*>(&many[i]) + k, 8) != 0)
            mix(sum, 1.0);
        }
      }
    }
  }
  return sum;
}
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
