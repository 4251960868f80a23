// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/ratios.hpp"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_RA;

TEST_CASE("Table II of the paper: eighteen entries are rounded, magic k = 6 and 8 are cut off",
          "[exam]") {
  // k = 1 .. 10, as printed
  const std::vector<long> magic = {1000000, 236068, 109916, 64178, 42217,
                                   29927,   22341,  17321,  13827, 11295};
  const std::vector<long> deficient = {414214, 154701, 82392, 51462, 35276,
                                       25717,  19591,  15427, 12465, 10283};
  for (int k = 1; k <= 10; ++k) {
    const auto index = static_cast<std::size_t>(k - 1);
    const cl_RA magic_millionths = ratio_within(Magic{k}, 60) * 1000000;
    const cl_RA deficient_millionths = ratio_within(Deficient{k}, 60) * 1000000;
    CHECK((k == 6 || k == 8 ? cln::floor1(magic_millionths) : cln::round1(magic_millionths)) ==
          magic[index]);
    CHECK(cln::round1(deficient_millionths) == deficient[index]);
  }
  CHECK(ratio_digits(Magic{6}, 8) ==
        "0.029927831");  // 0.029928 to six decimals, the paper has 0.029927
  CHECK(ratio_digits(Magic{8}, 8) ==
        "0.017321838");  // 0.017322 to six decimals, the paper has 0.017321
}

TEST_CASE("known closed forms to fifty digits", "[exam]") {
  CHECK(ratio_digits(Magic{1}, 5) == "1.0000");
  CHECK(ratio_digits(Magic{2}, 50) ==
        "0.23606797749978969640917366873127623544061835961153");  // sqrt(5) - 2
  CHECK(ratio_digits(Deficient{1}, 50) ==
        "0.41421356237309504880168872420969807856967187537695");  // sqrt(2) - 1
  CHECK(nearest_ratio<double>(Magic{2}) == 0.23606797749978969641);
  CHECK(nearest_ratio<float>(Deficient{1}) == 0.41421356237309504880F);
  CHECK(nearest_ratio<long double>(Magic{2}) == 0.23606797749978969641L);
}

TEST_CASE("a ratio of any index", "[exam]") {
  const auto largest = std::numeric_limits<std::int64_t>::max();
  CHECK(ratio_digits(Magic{largest}, 10) == "1.450208027e-38");
  CHECK(nearest_ratio<double>(Magic{largest}) == Approx(1.450208027e-38).epsilon(1e-9));
  CHECK_THROWS_AS(ratio_digits(Magic{0}, 10), InvalidInput);
  CHECK_THROWS_AS(nearest_ratio<double>(Deficient{0}), InvalidInput);
  CHECK_THROWS_AS(ratio_digits(Magic{3}, 0), InvalidInput);
}

TEST_CASE("the ratios are where the collision count changes", "[check]") {
  // a hair below alpha_k: N_A is k + 1, a hair above: k; the same with beta_k and N_B
  for (int k = 1; k <= 300; k += k < 20 ? 1 : 37) {
    const cl_RA hair = cl_RA(1) / cln::expt_pos(cln::cl_I(10), cln::cl_I(30));
    const cl_RA magic = ratio_within(Magic{k}, 200);
    const cl_RA deficient = ratio_within(Deficient{k}, 200);
    CHECK(count_collisions(magic - hair).N_A == k + 1);
    CHECK(count_collisions(magic + hair).N_A == k);
    CHECK(count_collisions(deficient - hair).N_B == k + 1);
    CHECK(count_collisions(deficient + hair).N_B == k);
  }
}
