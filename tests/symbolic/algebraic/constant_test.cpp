// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/constant.hpp"

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

using namespace magicmass::algebraic;
using GiNaC::cos;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;
using GiNaC::sin;
using GiNaC::sqrt;
using GiNaC::tan;

namespace {

ex sec(const ex& x) { return 1 / cos(x); }
ex cbrt(const ex& x) { return GiNaC::pow(x, numeric(1, 3)); }
ex root2() { return sqrt(ex(2)); }

}  // namespace

TEST_CASE("equal constants are proved equal", "[exam]") {
  const auto zero = GENERATE_COPY(Catch::Generators::table<const char*, ex>({
      {"sec(pi/5) - 1 = sqrt(5) - 2", sec(Pi / 5) - 1 - (sqrt(ex(5)) - 2)},
      {"sec(pi/8) - 1", sec(Pi / 8) - 1 - (sqrt(4 - 2 * root2()) - 1)},
      {"sec(pi/12) - 1", sec(Pi / 12) - 1 - (sqrt(ex(6)) - root2() - 1)},
      {"sum over the heptagon", cos(Pi / 7) + cos(3 * Pi / 7) + cos(5 * Pi / 7) - numeric(1, 2)},
      {"sec(pi/7) - 1", sec(Pi / 7) - 1 - tan(Pi / 7) * tan(Pi / 14)},
      {"nested", sqrt(5 + 2 * sqrt(ex(6))) - root2() - sqrt(ex(3))},
      {"cube root", cbrt(2 + sqrt(ex(5))) - (1 + sqrt(ex(5))) / 2},
  }));
  const Decision decision = sign_of(std::get<1>(zero));
  INFO(std::get<0>(zero) << ": " << decision.method);
  CHECK(decision.sign == 0);
}
