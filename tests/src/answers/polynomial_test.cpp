// SPDX-License-Identifier: GPL-2.0-or-later
// Minimal polynomials: their roots by doubles next to them, and their degree, that of the field,
// so that they have no factor.
#include <numeric>

#include "answers/motion.hpp"
#include "catch.hpp"
#include "magicmass/numbers/accurate.hpp"

using answers::Polynomial;

namespace {

cln::cl_RA value(const Polynomial& p, double x) {
  cln::cl_RA sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * balls::exact(x) + p[i];
  return sum;
}
bool changes_sign(const Polynomial& p, double x) {
  const cln::cl_RA at = value(p, x);
  return value(p, std::nextafter(x, 0)) * at <= 0 || at * value(p, std::nextafter(x, 2)) <= 0;
}
int coprime_to(int m) {
  int count = 0;
  for (int i = 1; i <= m; ++i) count += std::gcd(i, m) == 1 ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("each ratio is a root of its polynomial, and no other one is") {
  for (int k = 1; k <= 200; ++k) {
    for (const bool is_magic : {true, false}) {
      CAPTURE(k, is_magic);
      const Polynomial p = answers::polynomial_of_ratio(k, is_magic);
      const magicmass::Ratios here = magicmass::accurate::ratios(k);
      const magicmass::Ratios next = magicmass::accurate::ratios(k + 1);
      CHECK(changes_sign(p, is_magic ? here.magic : here.deficient));
      CHECK_FALSE(changes_sign(p, is_magic ? here.deficient : here.magic));
      CHECK_FALSE(changes_sign(p, is_magic ? next.magic : next.deficient));
      CHECK(2 * (p.size() - 1) == std::size_t(coprime_to(is_magic ? 4 * k + 2 : 4 * k + 4)));
    }
  }
}
