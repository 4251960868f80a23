// SPDX-License-Identifier: GPL-2.0-or-later
// Library functions called from several threads at once, with no care taken: each gives what it gives alone. The
// preset `tsan` looks at the same calls for data races.
#include <bit>
#include <functional>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/parallel.hpp"
#include "magicmass/scenes/scene.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); }
void add(Bits& bits, const generated::Velocities<double>& v) {
  for (const double x : {v.a, v.b, v.c, v.c_prime}) add(bits, x);
}

void add_one_by_one(Bits& bits, double alpha) {
  const auto counts = count_collisions(alpha).value();
  bits.push_back(static_cast<std::uint64_t>(counts.N_A));
  for (std::int64_t n = 0; n <= 2; ++n) {
    add(bits, fast::velocities(alpha, n));
    add(bits, accurate::velocities(alpha, n));
  }
  add(bits, fast::angle(alpha));
  add(bits, accurate::angle(alpha));
  add(bits, accurate::encounters(alpha, 1).t);
  add(bits, accurate::terminal(alpha).value().b_t);
  add(bits, fast::ratios(counts.N_A).magic);
  add(bits, fast::terminal(alpha, 0.9L, counts).b_t);
}

/// In two threads of its own.
void add_batch(Bits& bits, const std::vector<double>& alpha) {
  std::vector<std::int64_t> n(alpha.size(), 1);
  std::vector<double> a(alpha.size()), b(a), c(a), c_prime(a);
  accurate::velocities(alpha, n, a, b, c, c_prime, Threads{2});
  for (const auto* column : {&a, &b, &c, &c_prime})
    for (const double x : *column) add(bits, x);
}

Bits everything() {
  testing::Generator generator(29);
  Bits bits;
  std::vector<double> alphas;
  for (int i = 0; i < 150; ++i) alphas.push_back(testing::log_uniform(generator, 1e-6, 0.9));
  for (const double alpha : alphas) add_one_by_one(bits, alpha);
  alphas.resize(2 * least_part, 0.125);
  add_batch(bits, alphas);
  const Scene scene =
      parse_scene("kind = \"wall\"\nmasses = [1, \"1/7\"]\nV = 0.5\n", "scene.toml");
  bits.push_back(scene.masses.size());
  return bits;
}

}  // namespace

TEST_CASE("functions called from several threads at once give what they give alone", "[check]") {
  std::vector<Bits> results(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(results.size());
    for (Bits& result : results) threads.emplace_back([&result] { result = everything(); });
  }
  const Bits alone = everything();
  CHECK(alone.size() > 1000);
  for (const Bits& result : results) CHECK(result == alone);
}
