// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/certified_encounters.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>
#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/errors.hpp"
#include "magicmass/evaluators/encounter_attempts.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "random_numbers.hpp"
#include "report/family.hpp"
#include "report/oracle.hpp"

using namespace magicmass;
using cln::cl_I;
using cln::cl_RA;

namespace {

bool is_power_of_two(const cl_I& x) { return cln::power2p(x) != 0; }

}  // namespace

TEST_CASE("each time and distance of the hard families is the double nearest to the exact value",
          "[check]") {
  report::Oracle oracle;
  int open = 0;
  int rash = 0;
  for (const report::Family& family : report::families("encounters", 100)) {
    for (const report::Input& input : family.inputs) {
      INFO(family.name << ": alpha = " << to_text(MassRatio(input.alpha))
                       << ", j = " << input.index);
      const auto& exact = oracle.at("encounters", input);
      const double t = exact[0].nearest_double;
      const double s = exact[1].nearest_double;
      const auto got = certified_encounters(input.alpha, input.index);
      REQUIRE(got.t == t);
      REQUIRE(got.s == s);
      if (input.index == 0) continue;
      const auto j = static_cast<std::uint64_t>(input.index);
      const auto few = attempt_encounters<2>(input.alpha, j);
      REQUIRE((!few || (few->t == t && few->s == s)));
      open += few ? 0 : 1;
      const auto looped = until_certain<2, 3, 5, 23>(
          "a time or distance",
          [&]<std::size_t Words>() { return attempt_encounters<Words>(input.alpha, j); });
      REQUIRE((looped.t == t && looped.s == s));
      // a bound made too small would be seen
      auto distance = generated::s_exact(NearInteger<2>(input.alpha), j);
      distance.rest.error *= 0x1p-40;
      const auto guess = rounded(distance);
      rash += guess && *guess != s ? 1 : 0;
    }
  }
  CHECK(open > 100);
  CHECK(rash > 5);
}

TEST_CASE("(1 + alpha)/2 is exact, a tie or close to one", "[check]") {
  testing::Generator generator(71);
  const auto half_sum = [](double alpha) {
    return reference::nearest<double>((1 + reference::exact(alpha)) / 2);
  };
  std::vector<double> hard{0x1p-53,
                           0x1p-54,
                           3 * 0x1p-53,
                           0x1.8p-52,
                           0x1p53 + 2,
                           0x1p54 + 4,
                           1.0,
                           3.0,
                           0x1p-1074,
                           std::numeric_limits<double>::max(),
                           0x1.fffffffffffffp0,
                           0x1.0000000000001p-53};
  for (int i = 0; i < 500; ++i) {
    hard.push_back(std::ldexp(static_cast<double>(testing::whole(generator, 1, 1 << 12) * 2 + 1),
                              static_cast<int>(testing::whole(generator, -70, 60))));
  }
  for (const double alpha : hard) {
    INFO("alpha = " << to_text(MassRatio(alpha)));
    const auto got = certified_encounters(alpha, 1);
    CHECK(got.t == half_sum(alpha));
    CHECK(got.s == half_sum(alpha));
  }
  CHECK(half_sum(0x1p-53) == 0.5);
  CHECK(half_sum(3 * 0x1p-53) == 0.5 + 0x1p-52);
}

TEST_CASE("beyond j = 1 no time and no distance is a binary fraction", "[check]") {
  testing::Generator generator(72);
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const auto m = static_cast<unsigned>(testing::whole(generator, 1, 12));
    const auto two_m = std::int64_t{1} << m;
    const cl_RA alpha =
        cl_RA(static_cast<long>(testing::whole(generator, 0, two_m / 2 - 1) * 2 + 1)) /
        cl_I(static_cast<long>(two_m));
    const auto run = record_three_body<cl_RA>(alpha, cl_RA(1), cl_RA(1), 12);
    for (std::size_t j = 2; j < run.events.size(); ++j) {
      const auto& event = run.events[j];
      REQUIRE_FALSE(is_power_of_two(cln::denominator(event.time)));
      REQUIRE_FALSE(is_power_of_two(cln::denominator(event.positions.b - event.positions.a)));
      ++seen;
    }
  }
  CHECK(seen > 500);
}

TEST_CASE("a collision that does not take place is refused", "[exam]") {
  CHECK_THROWS_WITH(certified_encounters(0.1, 7),
                    "j must be below the number of collisions, 7, got 7");
  CHECK_THROWS_WITH(certified_encounters(0.1, -1), "j must be 0 or more, got -1");
  CHECK_THROWS_AS(certified_encounters(-1.0, 0), InvalidInput);
  CHECK(certified_encounters(1e-100, std::int64_t{1} << 40U).t > 0);
}
