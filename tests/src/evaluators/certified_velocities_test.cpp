// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/evaluators/certified_velocities.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/velocity_attempts.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "random_numbers.hpp"
#include "report/family.hpp"
#include "report/oracle.hpp"

using namespace magicmass;
using cln::cl_I;
using cln::cl_RA;

namespace {

using Members = std::array<double, 4>;

Members members(const generated::Velocities<double>& v) { return {v.a, v.b, v.c, v.c_prime}; }

Members one_by_one(double alpha, std::int64_t n) {
  return {certified_velocity(Velocity::a, alpha, n), certified_velocity(Velocity::b, alpha, n),
          certified_velocity(Velocity::c, alpha, n),
          certified_velocity(Velocity::c_prime, alpha, n)};
}

Members nearest(const reference::CycleVelocities<cl_RA>& v) {
  const auto rounded = [](const cl_RA& y) { return reference::nearest<double>(y); };
  return {rounded(v.a), rounded(v.b), rounded(v.c), rounded(v.c_prime)};
}

/// The oracle's, from fractions.
Members exactly(double alpha, std::int64_t n) {
  return nearest(reference::exact_velocities(reference::exact(alpha), cl_I(static_cast<long>(n))));
}

Members from(report::Oracle& oracle, const report::Input& input) {
  Members all{};
  const auto& values = oracle.at("velocities", input);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = values[i].nearest_double;
  return all;
}

/// Half way between two doubles.
bool is_tie(const cl_RA& y) {
  const auto near = reference::nearest<double>(y);
  const cl_RA away = 2 * y - reference::exact(near);
  return away != y && reference::exact(reference::nearest<double>(away)) == away;
}

cl_I odd_part(const cl_I& x) { return cln::ash(x, -static_cast<long>(cln::ord2(x))); }

}  // namespace

TEST_CASE("each member of each family of hard inputs is the double nearest to the exact value",
          "[check]") {
  report::Oracle oracle;
  for (const report::Family& family : report::families("velocities", 200)) {
    for (const report::Input& input : family.inputs) {
      INFO(family.name << ": alpha = " << to_text(MassRatio(input.alpha))
                       << ", n = " << input.index);
      const Members expected = from(oracle, input);
      REQUIRE(members(certified_velocities(input.alpha, input.index)) == expected);
      REQUIRE(one_by_one(input.alpha, input.index) == expected);
    }
  }
}

TEST_CASE("few words leave a rounding open or give the right one, and the loop goes on to more",
          "[check]") {
  report::Oracle oracle;
  int open = 0;
  int rash = 0;
  for (const report::Family& family : report::families("velocities", 60)) {
    for (const report::Input& input : family.inputs) {
      if (input.index == 0) continue;
      const auto n = static_cast<std::uint64_t>(input.index);
      const Members expected = from(oracle, input);
      INFO(family.name << ": alpha = " << to_text(MassRatio(input.alpha)) << ", n = " << n);
      const auto few = attempt_velocities<2>(input.alpha, n);
      const std::array attempted{few.a, few.b, few.c, few.c_prime};
      for (std::size_t i = 0; i < attempted.size(); ++i) {
        REQUIRE((!attempted[i] || *attempted[i] == expected[i]));
        open += attempted[i] ? 0 : 1;
      }
      const double looped = until_certain<2, 3, 5, 7, 23>("c", [&]<std::size_t Words>() {
        return attempt_velocity<Words>(generated::c_exact<NearInteger<Words>, std::uint64_t>,
                                       input.alpha, n);
      });
      REQUIRE(looped == expected[2]);
      // a bound made too small would be seen
      auto c = generated::c_exact(NearInteger<2>(input.alpha), n);
      c.rest.error *= 0x1p-30;
      const auto guess = rounded(c);
      rash += guess && *guess != expected[2] ? 1 : 0;
    }
  }
  CHECK(open > 100);
  CHECK(rash > 20);
}

TEST_CASE("where 1 + alpha is a power of two, velocities are exact or ties and rounded to even",
          "[exam]") {
  int ties = 0;
  for (int j = 1; j <= 53; ++j) {
    const double alpha = std::ldexp(1.0, j) - 1;
    for (std::int64_t n = 0; n <= 60; ++n) {
      INFO("alpha = 2^" << j << " - 1, n = " << n);
      const auto exact =
          reference::exact_velocities(reference::exact(alpha), cl_I(static_cast<long>(n)));
      for (const cl_RA& y : {exact.a, exact.b, exact.c, exact.c_prime}) ties += is_tie(y) ? 1 : 0;
      REQUIRE(members(certified_velocities(alpha, n)) == nearest(exact));
      REQUIRE(one_by_one(alpha, n) == nearest(exact));
    }
  }
  CHECK(ties > 5);
  CHECK(members(certified_velocities(1.0, std::int64_t{1} << 61U)) ==
        exactly(1.0, std::int64_t{1} << 61U));
}

TEST_CASE("for any other alpha an odd prime stays in the denominator of every velocity",
          "[check]") {
  testing::Generator generator(61);
  for (int i = 0; i < 300; ++i) {
    const double alpha = std::ldexp(static_cast<double>(testing::whole(generator, 1, 1000)),
                                    static_cast<int>(testing::whole(generator, -20, 5)));
    const auto n = static_cast<long>(testing::whole(generator, 1, 12));
    const cl_RA sum = 1 + reference::exact(alpha);
    const cl_I p = odd_part(cln::numerator(sum));
    const auto v = reference::exact_velocities(sum - 1, cl_I(n));
    for (const auto& [y, degree] : {std::pair{v.a, 2 * n - 1}, std::pair{v.b, 2 * n},
                                    std::pair{v.c, 2 * n - 1}, std::pair{v.c_prime, 2 * n}}) {
      if (y != 0) REQUIRE(odd_part(cln::denominator(y)) == cln::expt_pos(p, cl_I(degree)));
    }
  }
}

TEST_CASE("results below the normal range are rounded once", "[exam]") {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  for (const double alpha :
       {largest, std::nextafter(largest, 0.0), 0x1.8p1023, 0x1.9f4p1022, 1e308}) {
    CHECK(members(certified_velocities(alpha, 1)) == exactly(alpha, 1));
    CHECK(members(certified_velocities(alpha, 2)) == exactly(alpha, 2));
  }
  CHECK(std::fpclassify(certified_velocity(Velocity::c_prime, largest, 1)) == FP_SUBNORMAL);
  for (const double alpha : {smallest, 3 * smallest, 0x1.23p-1060, 1e-310}) {
    for (std::int64_t n = 1; n <= 5; ++n) {
      CHECK(members(certified_velocities(alpha, n)) == exactly(alpha, n));
    }
  }
}

TEST_CASE("as near to half way between two doubles as a velocity comes", "[exam]") {
  // b_3 = 24 alpha less about 100 alpha^2, and 24 alpha is half way
  const double alpha = 0x1.5acd9597016aap-968;
  CHECK_FALSE(attempt_velocities<8>(alpha, 3).b.has_value());
  CHECK(attempt_velocities<4>(alpha, 3).a.has_value());
  CHECK(members(certified_velocities(alpha, 3)) == exactly(alpha, 3));
  // c_n = 2 n less what alpha is too small to show
  const std::int64_t n = (std::int64_t{1} << 53U) + 1;
  CHECK(certified_velocity(Velocity::c, std::numeric_limits<double>::denorm_min(), n) == 0x1p54);
  CHECK(certified_velocity(Velocity::c, std::numeric_limits<double>::denorm_min(), n + 2) ==
        0x1p54 + 4);
}

TEST_CASE("the energy fraction is the double nearest to b_t squared", "[check]") {
  testing::Generator generator(62);
  for (int i = 0; i < 300; ++i) {
    const double alpha = i < 100 ? testing::log_uniform(generator, 1.0, 1e300)
                                 : testing::log_uniform(generator, 1e-37, 1.0);
    const Counts counts = count_collisions(alpha).value();
    const auto v =
        reference::velocities_within(MassRatio(alpha), cl_I(static_cast<long>(counts.N_B)), 400);
    INFO("alpha = " << to_text(MassRatio(alpha)));
    REQUIRE(certified_energy_fraction(alpha) == reference::nearest<double>(v.b * v.b));
  }
  int ties = 0;
  for (int j = 1; j <= 53; ++j) {
    const double alpha = std::ldexp(1.0, j) - 1;
    const cl_RA b = reference::exact_velocities(reference::exact(alpha), 1).b;
    ties += is_tie(b * b) ? 1 : 0;
    CHECK(certified_energy_fraction(alpha) == reference::nearest<double>(b * b));
  }
  CHECK(ties == 1);  // alpha = 2^27 - 1
  CHECK(certified_energy_fraction(1e-100) == 1.0);
}

TEST_CASE("what is no mass ratio or no cycle is refused", "[exam]") {
  CHECK_THROWS_WITH(certified_velocities(-0.1, 1),
                    "alpha must be a positive finite number, got -0.1");
  CHECK_THROWS_WITH(certified_velocity(Velocity::a, 0.1, -1), "n must be 0 or more, got -1");
  CHECK_THROWS_AS(certified_velocities(std::numeric_limits<double>::infinity(), 1), InvalidInput);
  CHECK_THROWS_AS(certified_velocities(std::numeric_limits<double>::quiet_NaN(), 1), InvalidInput);
  CHECK_THROWS_AS(certified_energy_fraction(0.0), InvalidInput);
  const auto never = []<std::size_t Words>() { return std::optional<double>(); };
  CHECK_THROWS_WITH((until_certain<2, 3>("this", never)), "this stays open at 192 bits");
}
