// SPDX-License-Identifier: GPL-2.0-or-later
// The families hold what they say.
#include "report/families.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "catch.hpp"
#include "magicmass/numbers/counts.hpp"

namespace {

using namespace report;

constexpr std::size_t draws = 300;

std::int64_t steps_between(double x, double y) {
  return std::abs(std::bit_cast<std::int64_t>(x) - std::bit_cast<std::int64_t>(y));
}
std::int64_t last_of(double alpha) {
  const auto counts = magicmass::count_collisions(alpha);
  return counts ? counts->N_A : std::int64_t{1} << 62U;
}
bool is_threshold(double alpha, bool magic) {
  const auto nearest = magicmass::nearest_threshold(alpha);
  return nearest && nearest->is_magic == magic && std::abs(nearest->distance) < 0x1p-50;
}
bool is_end(const Input& input) {
  return input.index <= 1 || input.index >= last_of(input.alpha) - 1;
}

using Holds = bool (*)(const Input&);
const std::map<std::string, Holds> promises{
    {"closest thresholds",
     [](const Input& x) {
       return steps_between(x.alpha, 0x1.1c7397cb68b7ep-18) <= 3 ||
              steps_between(x.alpha, 0x1.bc7fb47556f22p-29) <= 3;
     }},
    {"magic neighbours", [](const Input& x) { return is_threshold(x.alpha, true); }},
    {"deficient neighbours", [](const Input& x) { return is_threshold(x.alpha, false); }},
    {"alpha = 1", [](const Input& x) { return steps_between(x.alpha, 1) <= 3; }},
    {"first and last",
     [](const Input& x) { return x.alpha >= 1e-20 && x.alpha <= 100 && is_end(x); }},
    {"many collisions",
     [](const Input& x) {
       const std::int64_t last = last_of(x.alpha);
       return last >= std::int64_t{1} << 31U && last <= std::int64_t{1} << 62U;
     }},
    {"tiny", [](const Input& x) { return x.alpha >= 1e-300 && x.alpha <= 1e-30; }},
    {"subnormal", [](const Input& x) { return x.alpha < std::numeric_limits<double>::min(); }},
    {"huge", [](const Input& x) { return x.alpha >= 1e3; }},
    {"any double", [](const Input& x) { return std::isfinite(x.alpha); }},
    {"everyday", [](const Input& x) { return x.alpha >= 1e-6 && x.alpha <= 10; }}};

}  // namespace

TEST_CASE("Each family holds what it says, and cycles that take place", "[check]") {
  CHECK(families().size() == promises.size());
  for (const Family& family : families()) {
    INFO(family.name);
    const std::vector<Input> inputs = inputs_of(family, Quantity::velocities, draws);
    CHECK(inputs.size() >= 14);
    for (const Input& input : inputs) {
      CAPTURE(input.alpha, input.index);
      CHECK((input.alpha > 0 && promises.at(family.name)(input)));
      CHECK((input.index >= 0 && input.index <= last_of(input.alpha)));
    }
  }
}

TEST_CASE("Thresholds, zeros and far ends are among the inputs", "[check]") {
  const auto of = [](const std::string& name, Quantity quantity) {
    for (const Family& family : families())
      if (family.name == name) return inputs_of(family, quantity, draws);
    return std::vector<Input>();
  };
  std::set<double> ones;
  for (const Input& input : of("alpha = 1", Quantity::terminal)) ones.insert(input.alpha);
  CHECK(ones.size() == 7);
  CHECK(ones.count(1.0) == 1);
  int last = 0;
  std::int64_t largest = 0;
  for (const Input& input : of("magic neighbours", Quantity::velocities)) {
    last += input.index == last_of(input.alpha) ? 1 : 0;
    largest = std::max(largest, input.index);
  }
  CHECK(last > 20);
  CHECK(largest > std::int64_t{1} << 45U);
  CHECK(of("subnormal", Quantity::terminal).empty());
  CHECK(of("everyday", Quantity::ratios).size() > 30);
}

TEST_CASE("Random numbers are the same everywhere", "[exam]") {
  PortableRandom random(1);
  CHECK(random.whole(0, INT64_MAX - 1) == 2469588189546311528);
  CHECK(random.log_whole(1000) == 6);
  CHECK(random.whole(1, 6) == 1);
  CHECK(random.order(5) == std::vector<std::size_t>{0, 3, 2, 1, 4});
}
