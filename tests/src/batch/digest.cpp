// SPDX-License-Identifier: GPL-2.0-or-later
// A number that stands for every bit of many results: a line for each function and instruction set that this machine has.
// What the lines say of one function is the same whatever compiler and instruction set, or something is wrong.
//   digest [SPOIL]   with any argument, one bit of one result is wrong
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <vector>

#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/tiers/single_kernels.hpp"

using namespace magicmass;

namespace {

constexpr std::size_t size = 100'003;

/// Fowler, Noll and Vo's hash.
class Digest {
public:
  template <class Value>
  void add(std::span<const Value> values) {
    for (const std::byte byte : std::as_bytes(values))
      hash_ = (hash_ ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3ULL;
  }
  template <class Value>
  void add(const std::vector<Value>& values) {
    add(std::span<const Value>(values));
  }
  void print(const char* function, InstructionSet set) const {
    std::printf("%-20s %-8s %016llx\n", function, to_text(set).c_str(),
                static_cast<unsigned long long>(hash_));
  }

private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// The sequence is the same everywhere: whole numbers alone make its doubles (Steele, Lea and Flood's splitmix64).
class Inputs {
public:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }
  /// Any exponent from 2^-60 to 2^20 mostly; some are anything at all, NaN and negative ones, too.
  double alpha() {
    const std::uint64_t bits = next();
    const std::uint64_t made = bits % 64 == 0 ? next() : (963 + next() % 81) << 52U | (bits >> 12U);
    double x = 0;
    std::memcpy(&x, &made, sizeof x);
    return x;
  }

private:
  std::uint64_t state_ = 1;
};

struct Columns {
  std::vector<double> a = std::vector<double>(size), b = a, c = a, d = a;
  std::vector<std::int64_t> N_A = std::vector<std::int64_t>(size), N_B = N_A;

  void print(const char* function, InstructionSet set) const {
    Digest digest;
    for (const auto* column : {&a, &b, &c, &d}) digest.add(*column);
    for (const auto* column : {&N_A, &N_B}) digest.add(*column);
    digest.print(function, set);
  }
};

}  // namespace

int main(int arguments, char**) {
  Inputs inputs;
  std::vector<double> alpha(size);
  std::vector<std::int64_t> n(size);
  for (double& x : alpha) x = inputs.alpha();
  for (const InstructionSet set : all_instruction_sets) {
    if (!is_available(set)) continue;
    Columns counts;
    count_collisions(alpha, counts.N_A, counts.N_B, set);
    if (arguments > 1) counts.N_A[size / 2] ^= 1;
    counts.print("counts", set);
    for (std::size_t i = 0; i < size; ++i)
      n[i] = counts.N_A[i] < 1 ? static_cast<std::int64_t>(i % 3) - 1
                               : static_cast<std::int64_t>(i * i) % (counts.N_A[i] + 1);
    Columns in;
    fast::velocities(alpha, n, in.a, in.b, in.c, in.d, set);
    in.print("fast velocities", set);
    accurate::velocities(alpha, n, in.a, in.b, in.c, in.d, set);
    in.print("accurate velocities", set);
    fast::terminal(alpha, in.N_A, in.N_B, in.a, in.b, in.c, set);
    in.print("fast terminal", set);
    accurate::terminal(alpha, in.N_A, in.N_B, in.a, in.b, in.c, set);
    in.print("accurate terminal", set);
    fast::ratios(-2, in.a, in.b, set);
    accurate::ratios(-2, in.c, in.d, set);
    in.print("ratios", set);
    velocity_stream(0x1p-40, 12345, in.a, in.b, in.c, in.d, set);
    in.print("stream", set);
    const tiers::SingleKernels& single = tiers::single_kernels(set);
    for (std::size_t i = 0; i < size; ++i) {
      const double x = alpha[i];
      if (!(x > 0x1p-60 && x < 0x1p20) || n[i] < 0) continue;
      const auto v = single.fast_velocities(x, static_cast<double>(n[i]), 0.0);
      in.a[i] = v.a;
      in.b[i] = v.b;
      in.c[i] = v.c;
      if (!single.angle(x, in.d[i])) in.d[i] = 0.0;
    }
    in.print("single velocities", set);
  }
}
