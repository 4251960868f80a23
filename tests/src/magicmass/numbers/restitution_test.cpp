// Terminal velocities with restitution against the law of a collision, in rationals.

#include <cln/real.h>

#include "law_of_collision.hpp"
#include "magicmass/numbers/fast.hpp"
#include "rows.hpp"
#include "src/magicmass/numbers/families.hpp"

using namespace magicmass;
using namespace magicmass::testing;
using cln::cl_RA;

namespace {
using Row = std::array<double, 3>;    // M_C, 1/M_B, e; of A with mass 1
using Inputs = std::array<cl_RA, 3>;  // the same
using Values = std::array<cl_RA, 4>;  // a, b, c, rho
/// Until none takes place, or `most` have: how many.
std::pair<int, Values> motion(const Inputs& in, int most) {
  const auto& [ball, per_B, e] = in;
  law::ThreeBodies<cl_RA> bodies{1, per_B, ball, e, {1, 0, 0}, {0, 1, 0}};
  while (bodies.N < most && bodies.approach() > 0) bodies.collide();
  const auto& [a, b, c] = bodies.v;
  return {bodies.N, {a, b, c, per_B == 0 ? cl_RA(0) : b * b / per_B}};
}
double size(const cl_RA& x) { return std::fabs(cln::double_approx(x)); }
std::optional<Terminal> terminal(const Row& row) {
  const auto& [ball, per_B, e] = row;
  return per_B == 1 ? fast::terminal(ball, e) : fast::terminal({ball, per_B}, e);
}
Inputs exact(const Row& row) {
  return {oracle::exact(row[0]), oracle::exact(row[1]), oracle::exact(row[2])};
}
/// The largest error in envelopes, or -1 where counts differ.
double envelopes(const Row& row) {
  const std::optional<Terminal> got = terminal(row);
  const Inputs in = exact(row);
  const auto& [collisions, values] = motion(in, 120);
  if (!got) return collisions == 120 ? 0 : -1;
  const auto [N_A, N_B] = got->counts;
  if (N_A + N_B != collisions || N_A - N_B != collisions % 2) return -1;
  std::array<double, 4> moved{};  // by each input, times 2^60
  for (std::size_t input = 0; input < 3; ++input) {
    if (row[1] == 1 && input == 1) continue;
    Inputs more = in;
    more[input] = in[input] * (1 + oracle::exact(0x1p-60));
    const Values beside = motion(more, collisions).second;
    for (std::size_t i = 0; i < 4; ++i) moved[i] += size(beside[i] - values[i]) * 0x1p60;
  }
  const double numbers[] = {got->a_t, got->b_t, got->c_t, got->rho};
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double off = size(values[i] - oracle::exact(numbers[i])), value = size(values[i]);
    const double ulp = value == 0 ? 0 : std::ldexp(1.0, std::ilogb(value) - 52);
    const double at_wall = row[1] == 0 && i % 2 == 0 ? 0x1p-192 : 0;  // B's are 0
    const double envelope = std::fmax(
        at_wall, value == 0 ? moved[i] * 0x1p-53 : ulp * std::fmax(0.5, moved[i] / (2 * value)));
    worst = std::fmax(worst, off == 0 ? 0 : off / envelope);
  }
  return worst;
}
/// How many take place is exact, by the angle h alone: none where it has no cosine.
void check_count(const Row& row) {
  INFO("ball " << row[0] << " per_B " << row[1] << " e " << row[2]);
  const auto& [x, w, y] = exact(row);
  const cl_RA square = cln::square(1 + y) / (4 * y * (1 + x) * (1 + w * x));  // of the cosine
  const std::optional<Terminal> got = terminal(row);
  REQUIRE(got.has_value() == (square < 1));
  if (!got) return;
  const cln::float_format_t digits = cln::float_format(100);
  const cln::cl_R h = cln::atan(cln::sqrt(cln::cl_float(square, digits)),
                                cln::sqrt(cln::cl_float(1 - square, digits)));
  CHECK(got->counts.N_A + got->counts.N_B == cln::ceiling1(cln::pi(digits) / h) - 1);
}
/// Of a motion and of those beside it.
double worst_of(const Row& row) {
  const auto& [ball, per_B, e] = row;
  double worst = 0;
  for (const double m : {std::nextafter(ball, 0.0), ball, std::nextafter(ball, 1e308)}) {
    const double here = envelopes({m, per_B, e});
    INFO("ball " << m << " per_B " << per_B << " e " << e << ": " << here);
    CHECK(here >= 0);
    CHECK(here <= 4);
    worst = std::fmax(worst, here);
  }
  return worst;
}
Row equal_blocks(Random& random, int i) {
  const double e = i % 3 == 0 ? 1 - std::ldexp(uniform(random), -i % 50) : uniform(random);
  const double collapse = (1 - e) * (1 - e) / (4 * e);  // alpha (2 + alpha) there
  const double from = std::fmax(std::sqrt(1 + collapse) - 1, 0.003);
  return {from * (1.01 + 5 * uniform(random)), 1, e};
}
/// And a wall: a few to 100 collisions, (1 + m)(1 + w m) above (1 + e)^2/(4 e).
Row any_masses(Random& random, int i) {
  const double per_B = i % 4 == 0 ? 0 : std::exp2(60 * uniform(random) - 30);
  const double e = i % 3 == 0 ? 1 : i % 3 == 1 ? 1 - uniform(random) / 8 : uniform(random);
  const double least = (1 + e) * (1 + e) / (4 * e) + 0.003 + uniform(random);
  double ball = 0x1p-30;
  while ((1 + ball) * (1 + per_B * ball) < least) ball *= 1.5;
  return {ball, per_B, e};
}
/// With little restitution: e is 0.3/most to 0.9/most, a few collisions.
Row heavy_balls(Random& random, int i) {
  const double ball = std::exp2(188 * uniform(random));
  const double per_B = i % 3 == 0 ? 1 : i % 3 == 1 ? 0 : uniform(random);
  return {ball, per_B, (0.3 + 0.6 * uniform(random)) / ((1 + ball) * (1 + per_B * ball))};
}
}  // namespace

TEST_CASE("with restitution errors are at most 4 envelopes, and counts exact") {
  for (const auto& [rows, some] : {std::pair<int, Row (*)(Random&, int)>{150, equal_blocks},
                                   {300, any_masses},
                                   {60, heavy_balls}}) {
    Random random(20);
    double worst = 0;
    for (int i = 0; i < rows; ++i) worst = std::fmax(worst, worst_of(some(random, i)));
    CHECK(worst > 0.5);
  }
}

void check_collapse(const Masses& masses, double e, int& collapses) {
  INFO("ball " << masses.ball << " per_B " << masses.per_B << " e " << e);
  const cl_RA y = oracle::exact(e), ball = 1 + oracle::exact(masses.ball);
  const cl_RA w = oracle::exact(masses.per_B), kept = 1 + w * (ball - 1), all = 1 + w * ball;
  const std::optional<Collapse> got = accurate::collapse(masses, e);
  REQUIRE(got.has_value() == (4 * y * ball * kept <= cln::square(1 + y)));
  if (!got) return;
  ++collapses;
  CHECK(got->v == oracle::nearest(w / all));
  CHECK(got->rho == oracle::nearest(w / (all * all)));
  for (const double to : {0.0, 1e308}) {  // halfway; left of the lesser root, at it, or beyond it
    const cl_RA t = (oracle::exact(got->t) + oracle::exact(std::nextafter(got->t, to))) / 2;
    const cl_RA off = y * kept * t * t + ball - (1 + y) * t;
    const bool is_even = std::bit_cast<std::uint64_t>(got->t) % 2 == 0;
    const bool is_left =
        2 * y * kept * t <= 1 + y && off >= 0 && !(off == 0 && is_even == (to > 0));
    CHECK(is_left == (to == 0));
  }
}

TEST_CASE("whether collisions never end is exact, and what they come to correctly rounded") {
  Random random(21);
  int collapses = 0;
  for (int i = 0; i < 6000; ++i) {
    const double part = std::exp2(-40 * uniform(random)), e = i % 3 == 0 ? 1 - part : part;
    const double square = (1 - e) * (1 - e) / (4 * e), by = std::exp2(-55 * uniform(random));
    const double w = std::array{1.0, 0.0, std::exp2(80 * uniform(random) - 40)}[std::size_t(i % 3)];
    const double root = std::sqrt(std::pow((1 + w) / 2, 2) + w * square);
    const double ball = square / ((1 + w) / 2 + root) * (i % 2 == 0 ? 1 + by : 1 - by);
    check_collapse({ball, w}, e, collapses);
  }
  CHECK(collapses > 2500);
  for (const double e : {0.5, 0.75}) {  // a wall, t halfway between 1 and the next double
    const double t = 0x1p-53, ball = t * (1 - e - e * t);
    check_collapse({ball, 0}, e, collapses);
    CHECK(accurate::collapse({ball, 0}, e)->t == 1);
    CHECK(accurate::collapse({std::nextafter(ball, 1), 0}, e)->t > 1);
  }
  for (const auto& [m, w, e, t] : {std::array{0.25, 1.0, 0.25, 2.0}, {0.125, 0, 0.5, 1.5}})
    CHECK(accurate::collapse(Masses{m, w}, e)->t == t);  // just where collapse begins
  CHECK_THROWS_WITH(accurate::collapse({0x1.0000000000002p-104, 0}, 0x1.ffffffffffffcp-1),
                    ContainsSubstring("still open"));
}

TEST_CASE("whole angles, collapse, digits of pi and refusals are as in restitution.tsv") {
  for (const auto& text : rows_of("src/magicmass/numbers/restitution.tsv", 4)) {
    const Row row{std::stod(text[0]), std::stod(text[1]), std::strtod(text[2].c_str(), nullptr)};
    INFO(text[0] << ", " << text[1] << ", " << text[2]);
    if (text[3] == "motion")
      worst_of(row);
    else if (text[3] == "count")
      check_count(row);
    else
      CHECK_THROWS_WITH(terminal(row), ContainsSubstring(text[3]));
  }
}

TEST_CASE("what comes to rest or loses nothing has just these numbers") {
  const Terminal wall = fast::terminal({0x1p-40, 0}, 1).value();
  CHECK((wall.b_t == 0 && wall.rho == 0));
  const double alpha = 0x1.fffffe8000008p-3;
  const Terminal t = fast::terminal(alpha, 0x1.0000008000001p-2).value();
  CHECK(t.counts.N_A > 500000000000);  // nothing is left to part with
  for (const double velocity : {t.a_t, t.b_t, t.c_t})
    CHECK_THAT(velocity, WithinRel(1 / (2 + alpha), 1e-15));
  for (const double same : {0x1p-1074, 1e-30, 0.3, 1.0, 1e300})
    CHECK(fast::terminal(same, 1.0) == fast::terminal(same));
}
