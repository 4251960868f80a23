// The rules of the error analysis one by one, on programs made by hand: their guards, and bounds
// beside the sum of what the table says of each step: a term that is dropped is missing there.
#include "codegen/errors.hpp"

#include "catch.hpp"
#include "codegen/emit.hpp"

namespace {
using codegen::NumberType;
using codegen::Op;
constexpr double u = 0x1p-53;
const NumberType slow{u, &codegen::tiers()[2]};

struct Made : codegen::Builder {
  int alpha = input("alpha", false, {1, 1.00001});
  int square = product(alpha, alpha);
  Made() : Builder(codegen::Numbers::doubles) {}
  int plus(int x, double y) { return sum(x, constant(codegen::exact(y))); }
  /// x^(2^k): with each square the low part is twice as loose.
  int squared(int x, int k) { return k == 0 ? x : squared(product(x, x), k - 1); }
  double bound(int node, const NumberType& t = slow,
               codegen::Result::Kind kind = codegen::Result::real) {
    program.results = {{kind, "result", node}};
    codegen::Plan plan;
    const codegen::Form f = codegen::analyse(program, t, plan).outputs.at(0);
    return codegen::Absorber(program, plan).bounded(f);
  }
  double most(int node) const { return (*this)[node].range.size(); }
};
void check_is(double bound, double sum_of_steps) {
  CHECK(bound >= sum_of_steps);
  CHECK(bound < sum_of_steps * (1 + 0x1p-11));  // 13 bits are printed
}
}  // namespace

TEST_CASE("what is too far off for its range to be used, or has too loose a low part, is refused") {
  Made of;
  const int x = of.plus(of.square, -1);
  of.narrow(x, {-0x1p-75, 0x1p-75});
  CHECK_NOTHROW(of.bound(x));
  of.narrow(x, {-0x1p-85, 0x1p-85});
  CHECK_THROWS_WITH(of.bound(x), ContainsSubstring("too far off for its range"));
  Made loose;
  CHECK_NOTHROW(loose.bound(loose.squared(loose.alpha, 13)));
  CHECK_THROWS_WITH(loose.bound(loose.squared(loose.alpha, 14)), ContainsSubstring("is loose"));
}
TEST_CASE("ranges move outward but where nothing rounds: powers of two, and sums that are 0") {
  Made of;
  const codegen::Interval off = of[of.plus(of.alpha, 0x1p-60)].range;
  CHECK(off.low < 1 + 0x1p-60);
  CHECK(off.high > 1.00001);
  const codegen::Interval twice = of[of.scaled(of.alpha, -2)].range;
  CHECK(twice.low == -2.00002);
  CHECK(twice.high == -2);
  CHECK(of[of.plus(of.scaled(of.alpha, -1), 1)].range.high == 0);
  CHECK(of[of.plus(of.scaled(of.alpha, -1), 1)].range.low < -0.00001);
}
TEST_CASE("M1: a low part that may be large ends in a sum, which allows for it") {
  Made of;
  const int cosine = of.unary(Op::cosine, of.square);
  CHECK_THROWS_WITH(of.bound(cosine), ContainsSubstring("may be large"));
  Made other = of;
  const int product = other.product(cosine, of.square);
  CHECK_THROWS_WITH(other.bound(product), ContainsSubstring("may be large"));
  const int sum = of.plus(cosine, -0.125);
  const NumberType::SineCosine f = slow.sine_cosine(slow.product(0).loose);
  const NumberType::Cancelling c = slow.cancelling_sum(f.cosine.loose, 0);
  const double angle = (slow.product(0).loss + f.angle) * of.most(of.square);
  check_is(of.bound(sum), angle * std::sin(of.most(of.square)) + f.absolute + 3 * u * f.spill +
                              (f.cosine.loss + c.of_x + c.of_result) * of.most(cosine) +
                              c.of_result / 8 + slow.rounding_test(c.loose) * of.most(sum));
  const int sine = of.unary(Op::sine, of.square);
  const double share = slow.product(0).loss + f.angle + f.sine.loss;
  check_is(of.bound(sine), (share + slow.rounding_test(f.sine.loose)) * of.most(sine));
}
TEST_CASE("a constant's own loss counts, as does a divisor's error where the rest has no share") {
  Made of;
  check_is(of.bound(of.constant(cln::cl_RA(1) / 3)), (0x1p-108 + slow.rounding_test(u)) / 3);
  const int y = of.squared(of.alpha, 10);
  const int x = of.plus(of.square, -1);  // from 0 on
  const double low = 1023 * u;
  const double of_y = of.bound(y) / of.most(y) - slow.rounding_test(low);
  const double of_x = of.bound(x) - slow.rounding_test(2 * u) * of.most(x);
  const codegen::Loss loss = slow.quotient(2 * u, low);
  const int q = of.quotient(x, y);
  check_is(of.bound(q), of_x + (of_y + loss.loss + slow.rounding_test(loss.loose)) * of.most(q));
}
TEST_CASE("M2, M4: roundings of the bound itself, and of the test, are allowed for") {
  Made of;
  const int x = of.plus(of.alpha, 1);
  for (const auto kind : {codegen::Result::real, codegen::Result::sign})
    CHECK(of.bound(x, {u, nullptr}, kind) > 2 * u * of.most(x) * (1 + 0x1p-13));
}
TEST_CASE("L: a multiple of pi is right in both of its parts") {
  Made of;
  const double high = codegen::nearest(3 * codegen::pi());
  const double low = codegen::nearest(3 * codegen::pi() - codegen::exact(high));
  CHECK_THAT(codegen::as_number(of.program, of.constant(3, true)),
             ContainsSubstring(codegen::hex(high) + ", " + codegen::hex(low)));
}
