// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/parallel.hpp"

#include <array>
#include <atomic>
#include <cstring>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

/// The parts of a call, in order.
std::set<std::pair<std::size_t, std::size_t>> parts(unsigned threads, std::size_t size) {
  std::set<std::pair<std::size_t, std::size_t>> all;
  std::mutex mutex;
  in_parallel({threads}, size, [&](std::size_t first, std::size_t rows) {
    const std::lock_guard lock(mutex);
    all.insert({first, rows});
  });
  return all;
}

template <class Value>
bool same_bits(const std::vector<Value>& x, const std::vector<Value>& y) {
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(Value)) == 0;
}

Doubles some_alphas(std::size_t size) {
  testing::Generator generator(17);
  Doubles alphas;
  for (std::size_t i = 0; i < size; ++i)
    alphas.push_back(i % 97 == 0 ? -1.0 : testing::log_uniform(generator, 1e-9, 100));
  return alphas;
}

}  // namespace

TEST_CASE("parts follow each other, are whole units and no more than the threads", "[exam]") {
  for (const std::size_t size : {0UL, 1UL, 4095UL, 4096UL, 4097UL, 50000UL, 123457UL})
    for (const unsigned threads : {1U, 2U, 3U, 7U, 64U}) {
      INFO(size << " rows, " << threads << " threads");
      const auto all = parts(threads, size);
      CHECK(all == parts(threads, size));
      CHECK(all.size() <= threads);
      std::size_t next = 0;
      for (const auto& [first, rows] : all) {
        CHECK(first == next);
        CHECK(first % least_part == 0);
        CHECK(rows > 0);
        next = first + rows;
      }
      CHECK(next == size);
    }
  CHECK(parts(64, 50000).size() == 13);
}

TEST_CASE("several threads give the same bits as none", "[check]") {
  const std::size_t size = 30011;
  const Doubles alpha = some_alphas(size);
  Integers n(size);
  for (std::size_t i = 0; i < size; ++i) n[i] = static_cast<std::int64_t>(i % 5) - 1;
  const auto run = [&](auto... threads) {
    std::vector<Doubles> numbers(29, Doubles(size));
    std::vector<Integers> counts(6, Integers(size));
    auto& v = numbers;
    count_collisions(alpha, counts[0], counts[1], threads...);
    fast::velocities(alpha, n, v[0], v[1], v[2], v[3], threads...);
    accurate::velocities(alpha, n, v[4], v[5], v[6], v[7], threads...);
    fast::terminal(alpha, counts[2], counts[3], v[8], v[9], v[10], threads...);
    accurate::terminal(alpha, counts[4], counts[5], v[11], v[12], v[13], threads...);
    fast::ratios(-100, v[14], v[15], threads...);
    accurate::ratios(-100, v[16], v[17], threads...);
    fast::ratios(std::numeric_limits<std::int64_t>::max() - 3, v[18], v[19], threads...);
    fast::velocities(alpha, 1, v[20], v[21], v[22], v[23], threads...);
    accurate::velocities(alpha, 3, v[24], v[25], v[26], v[27], threads...);
    fast::transmission(alpha, 0.9, v[28], threads...);
    return std::pair(numbers, counts);
  };
  const auto [numbers, counts] = run();
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    const auto [parallel_numbers, parallel_counts] = run(Threads{threads});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      INFO("column " << i << ", " << threads << " threads");
      CHECK(same_bits(numbers[i], parallel_numbers[i]));
    }
    for (std::size_t i = 0; i < counts.size(); ++i) CHECK(same_bits(counts[i], parallel_counts[i]));
  }
  Doubles other = numbers[0];
  other[1] = std::nextafter(other[1], 9.0);
  CHECK_FALSE(same_bits(numbers[0], other));
}

TEST_CASE("an exception of any part comes out, the first part's of several", "[exam]") {
  std::atomic<int> done = 0;
  const auto call = [&](std::size_t first, std::size_t) {
    if (first > 0) throw std::runtime_error(std::to_string(first));
    ++done;
  };
  CHECK_THROWS_WITH(in_parallel({4}, 4 * least_part, call), std::to_string(least_part));
  CHECK(done == 1);
}

TEST_CASE("columns are looked at whole: an output may not overlap another part's input", "[exam]") {
  Doubles memory(20000, 0.5);
  const std::span<double> all(memory);
  Integers n(10000, 1);
  Doubles b(10000), c(10000), d(10000);
  const Doubles before = memory;
  // the input of the first part is apart from its own output, but not from the second's
  CHECK_THROWS_AS(
      fast::velocities(all.first(10000), n, all.subspan(5000, 10000), b, c, d, Threads{2}),
      InvalidInput);
  CHECK(same_bits(memory, before));
  CHECK_THROWS_AS(count_collisions(b, n, n, Threads{2}), InvalidInput);
  CHECK_THROWS_WITH(fast::ratios(1, b, c, Threads{0}), "threads must be 1 or more, got 0");
  CHECK_THROWS_AS(
      fast::velocities(all.first(10000), 1, all.subspan(5000, 10000), b, c, d, Threads{2}),
      InvalidInput);
  CHECK_THROWS_AS(fast::transmission(b, 0.5, b, Threads{2}), InvalidInput);
  CHECK_THROWS_AS(fast::transmission({}, 2.0, {}, Threads{2}), InvalidInput);
  CHECK(Threads::all().count >= 1);
}
