// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include <catch2/catch.hpp>

#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "report/family.hpp"
#include "report/last_collision.hpp"
#include "report/quantities.hpp"

using namespace magicmass;
using namespace magicmass::report;

namespace {

constexpr std::size_t size = 300;

Family family(const std::string& quantity, const std::string& name) {
  for (Family& one : families(quantity, size))
    if (one.name == name) return one;
  FAIL("no family " << name << " of " << quantity);
  return {};
}

bool same(const Input& x, const Input& y) { return x.alpha == y.alpha && x.index == y.index; }

// FNV-1a over the bits of all inputs
std::uint64_t fingerprint(const std::string& quantity) {
  std::uint64_t hash = 14695981039346656037U;
  const auto mix = [&](std::uint64_t word) { hash = (hash ^ word) * 1099511628211U; };
  for (const Family& one : families(quantity, size))
    for (const Input& input : one.inputs) {
      mix(std::bit_cast<std::uint64_t>(input.alpha));
      mix(static_cast<std::uint64_t>(input.index));
    }
  return hash;
}

template <class Holds>
bool all(const Family& one, const Holds& holds) {
  return !one.inputs.empty() && std::all_of(one.inputs.begin(), one.inputs.end(), holds);
}

}  // namespace

TEST_CASE("every input of every family has a meaning", "[exam]") {
  for (const Quantity& quantity : quantities())
    for (const Family& one : families(quantity.name, size)) {
      INFO(quantity.name << ": " << one.name);
      CHECK(one.quantity == quantity.name);
      CHECK_FALSE(one.description.empty());
      CHECK(one.inputs.size() <= size);
      CHECK(all(one, [&](const Input& input) {
        if (quantity.name == "ratios") return input.index >= 1;
        const LastCollision last = last_collision(input.alpha);
        return input.alpha > 0 && std::isfinite(input.alpha) && input.index >= 0 &&
               input.index <= (quantity.name == "velocities" ? last.N_A : last.total() - 1);
      }));
    }
}

TEST_CASE("the inputs are the same everywhere and every time", "[exam]") {
  CHECK(fingerprint("velocities") == 2229436274764428030U);
  CHECK(fingerprint("encounters") == 1235944326750957539U);
  CHECK(fingerprint("counts") == 14312078033334174138U);
  CHECK(fingerprint("ratios") == 8006915403283866323U);
}

TEST_CASE("an unknown quantity is refused", "[exam]") {
  CHECK_THROWS_WITH(families("volume", 3), Catch::Contains("volume"));
}

TEST_CASE("neighbours bracket their threshold", "[exam]") {
  const Family magic = family("counts", "magic neighbours");
  const Family deficient = family("counts", "deficient neighbours");
  const auto brackets = [](const Family& one, bool is_magic) {
    for (std::size_t first = 0; first + 7 <= one.inputs.size(); first += 7) {
      const auto at = [&](std::size_t i) { return one.inputs[first + i].alpha; };
      for (std::size_t i = 1; i < 7; ++i)
        if (at(i) != std::nextafter(at(i - 1), HUGE_VAL)) return false;
      // k from the count on the safe side, the upper one
      const LastCollision above = last_collision(at(6));
      const std::int64_t k = is_magic ? above.N_A : above.N_B;
      const cln::cl_RA threshold = is_magic ? reference::ratio_within(Magic{k}, 300)
                                            : reference::ratio_within(Deficient{k}, 300);
      if (threshold < reference::exact(at(2)) || reference::exact(at(4)) < threshold) return false;
      const LastCollision below = last_collision(at(0));
      if ((is_magic ? below.N_A : below.N_B) != k + 1) return false;
    }
    return true;
  };
  CHECK(brackets(magic, true));
  CHECK(brackets(deficient, false));
  CHECK_FALSE(brackets(deficient, true));
}

TEST_CASE("each family holds what it is named for", "[exam]") {
  const std::string v = "velocities";
  const double least = std::numeric_limits<double>::min();
  CHECK(all(family(v, "subnormal alpha"), [&](const Input& x) { return x.alpha <= least; }));
  CHECK(all(family(v, "tiny alpha"),
            [](const Input& x) { return x.alpha >= 1e-300 && x.alpha <= 1e-30; }));
  CHECK(all(family(v, "n above 2^32"), [](const Input& x) { return x.index >= 1LL << 32; }));
  CHECK(all(family(v, "N near 2^53"), [](const Input& x) {
    const double n = static_cast<double>(last_collision(x.alpha).N_A);
    return n > 0x1p52 && n < 0x1p54;
  }));
  CHECK(all(family(v, "zeros"), [](const Input& x) {
    // a_n changes its sign within an ulp or two of alpha: n = k
    const LastCollision above = last_collision(x.alpha * (1 + 0x1p-50));
    return x.index == above.N_A;
  }));
  CHECK(all(family(v, "first and last"), [](const Input& x) {
    const std::int64_t last = last_collision(x.alpha).N_A;
    return x.index <= 1 || x.index >= last - 1;
  }));
  const auto has = [&](const std::string& name, const Input& wanted) {
    const Family one = family(v, name);
    return std::any_of(one.inputs.begin(), one.inputs.end(),
                       [&](const Input& x) { return same(x, wanted); });
  };
  CHECK(has("huge alpha", {std::numeric_limits<double>::max(), 0}));
  CHECK(has("alpha = 1", {1.0, 1}));
  CHECK(has("alpha = 1", {1.0, 0}));
  CHECK(has("subnormal alpha", {std::numeric_limits<double>::denorm_min(), 9}));
  const Family closest = family("counts", "closest thresholds");
  for (const double x : {0x1.1c7397cb68b7ep-18, 0x1.bc7fb47556f22p-29})
    CHECK(std::any_of(closest.inputs.begin(), closest.inputs.end(),
                      [&](const Input& input) { return input.alpha == x; }));
}
