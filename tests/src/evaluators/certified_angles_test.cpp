// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/certified_angles.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/evaluators/angle_attempts.hpp"
#include "magicmass/reference/ratios.hpp"
#include "random_numbers.hpp"
#include "report/family.hpp"
#include "report/oracle.hpp"

using namespace magicmass;

TEST_CASE("psi is the double nearest to the exact value on every family", "[check]") {
  report::Oracle oracle;
  int open = 0;
  int rash = 0;
  for (const report::Family& family : report::families("angle", 60)) {
    for (const report::Input& input : family.inputs) {
      INFO(family.name << ": alpha = " << to_text(MassRatio(input.alpha)));
      const double psi = oracle.at("angle", input)[0].nearest_double;
      REQUIRE(certified_angle(input.alpha) == psi);
      // less known than two words hold leaves some open, and the loop goes on to more words
      const auto narrowed = [&]<std::size_t Words>() {
        auto angle = generated::angle_product(NearInteger<Words>(input.alpha)).together();
        angle.error *= Words == 2 ? 0x1p55 : 1.0;
        const auto rounded_angle = nearest_double(angle);
        open += rounded_angle ? 0 : 1;
        return rounded_angle;
      };
      REQUIRE(until_certain<2, 3, 23>("psi", narrowed) == psi);
      // without its last bits, and a bound that does not know of that, it would be seen
      auto angle = generated::angle_product(NearInteger<2>(input.alpha)).together();
      angle.words[0] = 0;
      angle.words[1] &= ~std::uint64_t{0} << 14U;
      const auto guess = nearest_double(angle);
      rash += guess && *guess != psi ? 1 : 0;
    }
  }
  CHECK(open > 10);
  CHECK(rash > 10);
}

TEST_CASE("magic and deficient ratios are the doubles nearest to the exact values", "[check]") {
  int open = 0;
  const auto agree = [&](std::int64_t k) {
    INFO("k = " << k);
    const auto magic = reference::nearest_ratio<double>(Magic{k});
    const auto deficient = reference::nearest_ratio<double>(Deficient{k});
    REQUIRE(certified_magic(k) == magic);
    REQUIRE(certified_deficient(k) == deficient);
    const auto few = attempt_magic<2>(k);
    REQUIRE((!few || *few == magic));
    open += few ? 0 : 1;
    const auto looped = [&]<std::size_t Words>() { return attempt_deficient<Words>(k); };
    REQUIRE(until_certain<2, 3, 23>("a ratio", looped) == deficient);
  };
  for (const report::Family& family : report::families("ratios", 100)) {
    for (const report::Input& input : family.inputs) agree(input.index);
  }
  agree(std::numeric_limits<std::int64_t>::max());
  agree((std::int64_t{1} << 62U) + 12345);
  CHECK(open > 0);
  CHECK(certified_magic(1) == 1.0);
  CHECK(certified_ratios(7).magic == certified_magic(7));
  CHECK(certified_ratios(7).deficient == certified_deficient(7));
}

TEST_CASE("the ends of the doubles have an angle, too", "[exam]") {
  CHECK(certified_angle(std::numeric_limits<double>::max()) == 0x1.921fb54442d18p+1);  // pi
  const double smallest = std::numeric_limits<double>::denorm_min();
  CHECK(certified_angle(smallest) == std::sqrt(8.0) * 0x1p-537);  // 2 sqrt(2 alpha)
}

TEST_CASE("no angle without a mass ratio, no ratio without an index", "[exam]") {
  CHECK_THROWS_WITH(certified_angle(-0.1), "alpha must be a positive finite number, got -0.1");
  CHECK_THROWS_WITH(certified_magic(0), "k must be 1 or more, got 0");
  CHECK_THROWS_AS(certified_deficient(-1), InvalidInput);
  CHECK_THROWS_AS(certified_ratios(0), InvalidInput);
}
