// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/table_contestants.hpp"

#include <array>

#include <catch2/catch.hpp>

#include "magicmass/evaluators.hpp"

using namespace magicmass;
using namespace magicmass::report;

namespace {

generated::Velocities<double> constant(double alpha, std::int64_t n) {
  return {alpha, static_cast<double>(n), 3.0, 4.0};
}

// The generated table with one more row, as a new form in the derivation would add it.
constexpr std::array<generated::VelocityEvaluator<double>, 2> table{{
    generated::velocity_table<double>[0],
    { "velocities_new", "new", &constant, 7, 9 },
}};

}  // namespace

TEST_CASE("a row added to a table is a contestant, with no other edit", "[exam]") {
  const auto all = table_contestants<double, table>("velocities");
  REQUIRE(all.size() == 2);
  const Contestant& added = all[1];
  CHECK(added.name == "velocities_new");
  CHECK(added.form == "new");
  CHECK(added.quantity == "velocities");
  CHECK(added.precision == "double");
  CHECK(added.ulp_bound == 7);
  CHECK(added.eps_bound == 9);
  std::array<long double, 4> got{};
  added.evaluate({0.5, 2}, got.data());
  CHECK(got == std::array<long double, 4>{0.5L, 2, 3, 4});
}

TEST_CASE("functions of alpha alone and of k alone are called as they want", "[exam]") {
  std::array<long double, 4> got{};
  const auto angles = table_contestants<float, generated::angle_table<float>>("angle");
  angles.at(0).evaluate({1.0, 77}, got.data());
  CHECK(got[0] == static_cast<long double>(generated::angle_closed(1.0F)));
  const auto ratios = table_contestants<double, generated::ratio_table<double>>("ratios");
  ratios.at(0).evaluate({0.0, 5}, got.data());
  CHECK(got[0] == static_cast<long double>(generated::ratios_closed<double>(5).magic));
}

TEST_CASE("a chained evaluation gets its own input, whatever the last result was", "[exam]") {
  const Input input{0.25, 12};
  const generated::Ratios<double> last{std::numeric_limits<double>::quiet_NaN(), 1e300};
  const Input next = after(input, last, opaque_zero());
  CHECK(next.alpha == 0.25);
  CHECK(next.index == 12);
  // with other than zero it would not: the result does go in
  CHECK(after(input, last, ~std::uint64_t{0}).alpha != 0.25);
}
