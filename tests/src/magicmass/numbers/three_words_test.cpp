// Each operation of three words against MPFR's with 400 bits, edges among the operands.

#include "catch.hpp"
#include "magicmass/numbers/mpfr_float.hpp"
#include "src/magicmass/numbers/families.hpp"
#if defined(__SIZEOF_INT128__)
#include "magicmass/numbers/three_words.hpp"

using magicmass::numbers::MpfrFloat;
using magicmass::numbers::ThreeWords;
using namespace magicmass::testing;

namespace {
/// Four doubles hold 192 bits.
MpfrFloat exactly(ThreeWords x) {
  MpfrFloat sum = 0.0;
  for (int part = 0; part < 4; ++part) {
    const double high = rounded(x);
    sum = sum + MpfrFloat(high);
    x = x - ThreeWords(high);
  }
  return sum;
}
/// log2 of the relative error.
double off(const ThreeWords& got, const MpfrFloat& wanted) {
  const MpfrFloat difference = exactly(got) - wanted;
  if (exponent(wanted) == -MpfrFloat::bits - MpfrFloat::spare)
    return rounded(difference) == 0.0 ? -400 : 0;
  return double(std::log2(MpfrFloat::magnitude_of(difference / wanted)));
}
/// Numbers of up to 160 bits, runs of zeros and ones among them.
ThreeWords some(Random& random) {
  ThreeWords x = 0.0;
  for (int part = 0; part < 3; ++part) {
    const int size = std::uniform_int_distribution(-60, 60)(random) - 50 * part;
    const double high = std::uniform_int_distribution(0, 2)(random) - 1.0;
    x = x + ThreeWords(std::ldexp(part == 0 ? 1.0 + log_uniform(random, 1e-15, 1) : high, size));
  }
  return std::uniform_int_distribution(0, 1)(random) == 0 ? x : -x;
}
struct Bits {
  Bits() { MpfrFloat::bits = 400; }
  ~Bits() { MpfrFloat::bits = 182; }
};
}  // namespace

TEST_CASE("three words lose no more than they say") {
  const Bits more;
  Random random(61);
  for (int row = 0; row < 20000; ++row) {
    const ThreeWords x = some(random);
    const ThreeWords near = x + scaled(x, std::ldexp(1.0, -row % 191));
    const ThreeWords y = row % 2 == 0 ? some(random) : -near;
    const MpfrFloat a = exactly(x), b = exactly(y);
    REQUIRE(off(x, a) < -300);
    REQUIRE(off(x + y, a + b) <= -191);
    REQUIRE(off(x - y, a - b) <= -191);
    REQUIRE(off(x * y, a * b) <= -191);
    REQUIRE(off(x / y, a / b) <= -187);
    REQUIRE(off(reciprocal_root(magnitude(x)), reciprocal_root(magnitude(a))) <= -187);
    REQUIRE(is_above(x, y) == is_above(a, b));
    REQUIRE(rounded(x) == rounded(a));
    REQUIRE(exponent(x) == exponent(a));
    const MpfrFloat whole = exactly(ThreeWords::nearest(x));
    REQUIRE(rounded(whole - MpfrFloat::nearest(whole)) == 0.0);
    REQUIRE(std::fabs(rounded(whole - a)) <= 0.5);
    REQUIRE(ThreeWords::to_whole(x) == MpfrFloat::to_whole(whole));
  }
  CHECK(off(ThreeWords::pi(), MpfrFloat::pi()) <= -191);
  CHECK(off(ThreeWords::inverse(63), MpfrFloat::inverse(63)) <= -187);
  CHECK(off(ThreeWords::inverse(64), MpfrFloat::inverse(64)) <= -187);
  CHECK(ThreeWords::to_whole(0x1p63) == INT64_MAX);
  CHECK(ThreeWords::to_whole(-0x1p63) == INT64_MIN);
  CHECK(ThreeWords::to_whole(ThreeWords::whole(INT64_MIN)) == INT64_MIN);
  CHECK(rounded(ThreeWords(1.0) - ThreeWords(1.0)) == 0.0);
}
TEST_CASE("a rounding is in doubt just where the error reaches the middle of two doubles") {
  const double unit = 0x1p-182;
  for (const double ulps : {0.5, 1000.5, -0.25}) {
    const ThreeWords middle = ThreeWords(1.0) + scaled(ThreeWords(ulps), 0x1p-52);
    for (const double away : {0x1p-100, -0x1p-110}) {
      const ThreeWords x = middle + ThreeWords(away);
      const double reach = std::fabs(away) / unit;
      CHECK(rounding_test(x, reach * 1.1).doubt == 1.0);
      CHECK(rounding_test(x, reach * 0.9).doubt == 0.0);
      CHECK(rounding_test(x, reach * 0.9).value == rounded(x));
    }
    CHECK(rounding_test(middle, 0.0).doubt == 1.0);
  }
  CHECK(rounding_test(ThreeWords(1.0), 0x1p80).doubt == 0.0);
  CHECK(rounding_test(ThreeWords(0.0), 0.0).doubt == 1.0);
}
#endif
