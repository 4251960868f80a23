// SPDX-License-Identifier: GPL-2.0-or-later
// Terminal velocities with restitution against the law of a collision, in rationals.
#include <array>
#include <cmath>

#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include "catch.hpp"
#include "law_of_collision.hpp"
#include "magicmass/numbers/fast.hpp"
#include "magicmass/oracle/rational.hpp"
#include "src/magicmass/numbers/families.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;

namespace {
using Values = std::array<cl_RA, 4>;  // a, b, c, rho
struct Motion {
  int collisions;
  Values values;
};
/// Until none takes place, or `most` have; of A with mass 1.
Motion motion(const cl_RA& ball, const cl_RA& per_B, const cl_RA& e, int most) {
  law::ThreeBodies<cl_RA> bodies{1, per_B, ball, e, {1, 0, 0}, {0, 1, 0}};
  while (bodies.N < most && bodies.approach() > 0) bodies.collide();
  const auto& [a, b, c] = bodies.v;
  return {bodies.N, {a, b, c, per_B == 0 ? cl_RA(0) : b * b / per_B}};
}
double size(const cl_RA& x) { return std::fabs(cln::double_approx(x)); }
/// The largest error in envelopes, or -1 where counts differ.
double envelopes(const Masses& masses, double e, int most = 120) {
  const bool is_equal = masses.per_B == 1;
  const std::optional<Terminal> got =
      is_equal ? fast::terminal(masses.ball, e) : fast::terminal(masses, e);
  const cl_RA x = oracle::exact(masses.ball), w = oracle::exact(masses.per_B), y = oracle::exact(e),
              more = 1 + oracle::exact(0x1p-60);
  const Motion m = motion(x, w, y, most);
  if (!got) return m.collisions == most ? 0 : -1;
  const auto [N_A, N_B] = got->counts;
  if (N_A + N_B != m.collisions || N_A - N_B != m.collisions % 2) return -1;
  const Values moved_by[] = {motion(x * more, w, y, m.collisions).values,
                             motion(x, w, y * more, m.collisions).values,
                             motion(x, is_equal ? w : w * more, y, m.collisions).values};
  const double numbers[] = {got->a_t, got->b_t, got->c_t, got->rho};
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const cl_RA& exact = m.values[i];
    const double off = size(exact - oracle::exact(numbers[i])), value = size(exact);
    double moved = 0;
    for (const Values& values : moved_by) moved += size(values[i] - exact) * 0x1p60;
    const double ulp = value == 0 ? 0 : std::ldexp(1.0, std::ilogb(value) - 52);
    const double at_wall = masses.per_B == 0 ? 0x1p-192 : 0;
    const double envelope = std::fmax(
        at_wall, value == 0 ? moved * 0x1p-53 : ulp * std::fmax(0.5, moved / (2 * value)));
    worst = std::fmax(worst, off == 0 ? 0 : off / envelope);
  }
  return worst;
}
/// How many take place, by the angle h alone.
std::int64_t by_angle(const Masses& masses, double e) {
  const cln::cl_R y = cln::cl_float(oracle::exact(e), cln::float_format(100));
  const cl_RA x = oracle::exact(masses.ball), w = oracle::exact(masses.per_B);
  const cln::cl_R cosine = (1 + y) / (2 * cln::sqrt(y * (1 + x) * (1 + w * x)));
  const cln::cl_R h = cln::atan(cosine, cln::sqrt(1 - cosine * cosine));
  return cln::cl_I_to_long(cln::ceiling1(cln::pi(cln::float_format(100)) / h) - 1);
}
double worst_of(double ball, double e, double per_B = 1) {
  double worst = 0;
  for (const double m : {std::nextafter(ball, 0.0), ball, std::nextafter(ball, 1e308)}) {
    const double here = envelopes({m, per_B}, e);
    INFO("ball " << m << " per_B " << per_B << " e " << e << ": " << here);
    CHECK(here >= 0);
    CHECK(here <= 4);
    worst = std::fmax(worst, here);
  }
  return worst;
}
}  // namespace

TEST_CASE("with restitution errors are at most 4 envelopes, and counts exact") {
  Random random(20);
  const auto number = [&] { return uniform(random); };
  double worst = 0;
  for (int i = 0; i < 150; ++i) {
    const double e = i % 3 == 0 ? 1 - std::ldexp(number(), -i % 50) : number();
    const double collapse = (1 - e) * (1 - e) / (4 * e);  // alpha (2 + alpha) there
    const double from = std::fmax(std::sqrt(1 + collapse) - 1, 0.003);
    worst = std::fmax(worst, worst_of(from * (1.01 + 5 * number()), e));
  }
  CHECK(worst > 0.5);
}

TEST_CASE("so they are for any masses, and for a wall") {
  Random random(26);
  const auto number = [&] { return uniform(random); };
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const double per_B = i % 4 == 0 ? 0 : std::exp2(60 * number() - 30);
    const double e = i % 3 == 0 ? 1 : i % 3 == 1 ? 1 - number() / 8 : number();
    // a few to 100 collisions: (1 + m)(1 + w m) above (1 + e)^2/(4 e)
    double ball = 0x1p-30;
    while ((1 + ball) * (1 + per_B * ball) < (1 + e) * (1 + e) / (4 * e) + 0.003 + number())
      ball *= 1.5;
    worst = std::fmax(worst, worst_of(ball, e, per_B));
  }
  CHECK(worst > 0.5);
}

TEST_CASE("heavy balls with little restitution keep their small velocities") {
  Random random(28);
  const auto number = [&] { return uniform(random); };
  for (int i = 0; i < 60; ++i) {
    const double ball = std::exp2(188 * number()), per_B = i % 3 == 0   ? 1
                                                           : i % 3 == 1 ? 0
                                                                        : number();
    const double most = (1 + ball) * (1 + per_B * ball);  // e is 0.3/most to 0.9/most: a few
    worst_of(ball, (0.3 + 0.6 * number()) / most, per_B);
  }
  CHECK_THROWS_AS(fast::terminal(0x1.7c1d50e81b3d9p+473, 0x1.17bc129cc883ap-948), Undecided);
}

TEST_CASE("whole angles, collapse and the digits of pi are exact, for any masses and a wall") {
  using Row = std::array<double, 3>;  // ball, e, per_B; pi/6, pi/3, pi/4 and others beside
  for (const auto& [ball, e, per_B] :
       {Row{0.5, 0.5, 0}, {3, 1, 0}, {1, 1, 0}, {0.5, 0.5, 1}, {1.25, 0.125, 1}, {1.5, 0.25, 1}})
    worst_of(ball, e, per_B);
  CHECK(fast::terminal({0.5, 0}, 0.5).value().counts == Counts{3, 2});
  CHECK(fast::terminal({1, 0}, 1).value().counts == Counts{2, 1});
  CHECK(fast::terminal(0.5, 0.5).value().counts == Counts{2, 1});
  CHECK(fast::terminal({3, 0x1p130}, 1).value().counts == Counts{1, 1});
  CHECK_FALSE(fast::terminal({0.125, 0}, 0.5));  // kappa is 1
  CHECK(fast::terminal({std::nextafter(0.125, 1), 0}, 0.5));
  CHECK_FALSE(fast::terminal(0.25, 0.25));
  CHECK_FALSE(fast::terminal(1.0, 0.07));
  CHECK(fast::terminal(1.0, 0.072));
  CHECK_FALSE(fast::terminal(0x1p-1074, 0.999));
  const Terminal wall = fast::terminal({0x1p-40, 0}, 1).value();
  CHECK(wall.counts.N_A + wall.counts.N_B == by_angle({0x1p-40, 0}, 1));
  CHECK((wall.b_t == 0 && wall.rho == 0));
  CHECK(fast::terminal({1e-16, 0}, 1).value().counts == Counts{157079633, 157079632});  // 314159265
  for (const auto& [masses, e, says] :
       {std::tuple{Masses{0x1p-250, 0x1p250}, 1.0, "of masses so unequal"},
        {{0x1p191, 0}, 0x1p-192, "of masses so unequal"},
        {{0x1p-150, 0}, 1.0, "or above 2^62 collisions"}})
    CHECK_THROWS_WITH(fast::terminal(masses, e), ContainsSubstring(says));
  for (const double per_B : {-1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_WITH(fast::terminal({0.3, per_B}, 1),
                      Catch::Matchers::StartsWith("per_B must be finite and not negative, got "));
}

TEST_CASE("counts change where they do, collapse begins where it does") {
  for (const double e : {0.3, 0.9, 0x1p-301})  // pi/3 and collapse, and the doubles around them
    for (const double factor : {1.0, 2.0}) {
      const double near = (1 + e) / (factor * std::sqrt(e)) - 1;
      for (const double alpha : {near * (1 - 1e-15), near, near * (1 + 1e-15)}) {
        INFO("alpha " << alpha << " e " << e);
        const double d = factor * factor;
        const cln::cl_RA x = 1 + oracle::exact(alpha), y = oracle::exact(e);
        const bool above = oracle::exact(d) * y * x * x > (1 + y) * (1 + y);
        if (factor == 1) CHECK((fast::terminal(alpha, e).value().counts == Counts{1, 1}) == above);
        const std::optional<Terminal> got = fast::terminal(alpha, e);
        CHECK(got.has_value() == (factor == 1 || above));
        if (got) CHECK(got->counts.N_A + got->counts.N_B == by_angle({alpha}, e));
      }
    }
}

TEST_CASE("close to collapse counts are exact, or refused") {
  const double e = 0x1.0000008000001p-2;  // (1 + 2^-26)^2/4: collapse is 2^-76 below this alpha
  const double alpha = (0x1p26 - 3 + 0x1p-24) / 0x1p28;
  const Terminal t = fast::terminal(alpha, e).value();
  CHECK(t.counts.N_A + t.counts.N_B == by_angle({alpha}, e));
  CHECK(t.counts.N_A > 500000000000);
  for (const double velocity : {t.a_t, t.b_t, t.c_t})  // nothing is left to part with
    CHECK_THAT(velocity, Catch::Matchers::WithinRel(1 / (2 + alpha), 1e-15));
  CHECK_FALSE(fast::terminal(std::nextafter(alpha, 0.0), e));
  CHECK_THROWS_AS(fast::terminal(0x1.0000000000001p-109, 1 - 0x1p-53), Undecided);
}

TEST_CASE("e = 1 loses nothing, and other e are refused") {
  for (const double alpha : {0x1p-1074, 1e-30, 0.3, 1.0, 1e300})
    CHECK(fast::terminal(alpha, 1.0) == fast::terminal(alpha));
  for (const double e : {0.0, -1.0, 1.0000000000000002, std::nan("")})
    CHECK_THROWS_WITH(fast::terminal(0.3, e),
                      Catch::Matchers::StartsWith("e must be above 0 and at most 1, got "));
  CHECK_THROWS_WITH(fast::terminal(0.3, 1.0000000000000002),
                    Catch::Matchers::EndsWith("got 1.0000000000000002"));
  CHECK_THROWS_WITH(fast::terminal(-1e-9), Catch::Matchers::EndsWith("got -1e-09"));
  CHECK_THROWS_AS(fast::terminal(0.0, 0.5), InvalidInput);
  CHECK(fast::terminal(1e308, 0x1p-1074).value().counts == Counts{1, 1});
}
