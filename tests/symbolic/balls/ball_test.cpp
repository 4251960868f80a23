// Balls hold what is exact, and roundings are given only where they are certain.
#include "balls/ball.hpp"

#include "catch.hpp"

using namespace balls;
using cln::cl_RA;

namespace {
/// And no number farther away.
bool holds(const Ball& ball, const cl_RA& value, const cl_RA& widest) {
  return ball.low() <= value && value <= ball.high() && ball.high() - ball.low() < widest;
}
cl_RA power_of_2(int n) { return cln::expt(cl_RA(2), n); }
}  // namespace

TEST_CASE("operations hold the exact result, narrowly") {
  Ball::bits = 100;
  const cl_RA tiny = power_of_2(-90);
  for (int p = -7; p <= 7; ++p)
    for (int q = 1; q <= 9; q += 2) {
      const cl_RA x = cl_RA(p) / q, y = cl_RA(q) / 7;
      for (const auto& [ball, exact] :
           {std::pair{Ball(x) + Ball(y), x + y}, std::pair{Ball(x) - Ball(y), x - y},
            std::pair{Ball(x) * Ball(y), x * y}, std::pair{Ball(x) / Ball(y), x / y}})
        CHECK(holds(ball, exact, tiny));
      // The root of 0 is known to half as many bits.
      CHECK(holds(sqrt(Ball(x * x)), cln::abs(x), tiny * 1000000));
    }
  CHECK_THROWS_AS(Ball(1) / (Ball(cl_RA(1) / 3) - Ball(cl_RA(1) / 3)), NotCertain);
  CHECK_THROWS_AS(sqrt(Ball(-1)), NotCertain);
}
TEST_CASE("roots of every order hold the exact one, narrowly, and none is taken at 0 or below") {
  Ball::bits = 300;
  for (const int n : {1, 2, 3, 7, 24, 999})
    for (const cl_RA& x : {cl_RA(2), cl_RA(1) / 3, power_of_2(-90), power_of_2(70) / 3}) {
      const Ball root = nth_root(Ball(x), n),
                 wide = nth_root(Ball(x) + (Ball(1) / 7 - Ball(1) / 7), n);
      CHECK(holds(power(root, n) / Ball(x), 1, power_of_2(-180)));
      CHECK((wide.low() <= root.high() && root.low() <= wide.high()));
    }
  CHECK(holds(nth_root(Ball(cl_RA(1) / 32768), 15), cl_RA(1) / 2, power_of_2(-250)));
  CHECK_THROWS_AS(nth_root(Ball(0), 3), NotCertain);
  CHECK_THROWS_AS(nth_root(Ball(-8), 3), NotCertain);
  CHECK_THROWS_AS(nth_root(Ball(1) / 7 - Ball(1) / 7, 3), NotCertain);
}
TEST_CASE("functions meet their identities") {
  Ball::bits = 200;
  const cl_RA tiny = power_of_2(-180);
  const Ball pi = Ball::pi();
  CHECK(*decimal(pi.low(), pi.high(), 40) == "3.141592653589793238462643383279502884197");
  for (int k = -20; k <= 20; ++k) {
    const Ball x = Ball(cl_RA(k) / 7);
    CHECK(holds(sin(x) * sin(x) + cos(x) * cos(x), 1, tiny));
    CHECK(holds(sin(atan(x)) - x * cos(atan(x)), 0, tiny));
  }
  CHECK(ceil(pi).low() == 4);
  CHECK(ceil(-pi).high() == -3);
  CHECK_THROWS_AS(ceil(sin(pi)), NotCertain);
}
TEST_CASE("nearest doubles and decimals, at their edges") {
  const cl_RA half_ulp = power_of_2(-53);
  CHECK(nearest_double(1 + half_ulp, 1 + half_ulp) == 1.0);  // a tie goes to even
  CHECK_FALSE(nearest_double(1 + half_ulp, 1 + half_ulp + half_ulp / 1000).has_value());
  const cl_RA least = power_of_2(-1074), beyond = power_of_2(1024);
  CHECK(nearest_double(least, least) == 0x1p-1074);
  CHECK_FALSE(nearest_double(beyond, beyond).has_value());
  CHECK(decimal(cl_RA(1) / 8, cl_RA(1) / 8, 2) == "0.12");
  CHECK(decimal(cl_RA(-9999) / 10000, cl_RA(-9999) / 10000, 3) == "-1.00");
  CHECK(decimal(123456, 123456, 6) == "1.23456e5");
  CHECK_FALSE(decimal(cl_RA(124) / 1000, cl_RA(126) / 1000, 2).has_value());
  CHECK_FALSE(decimal(cl_RA(-1) / 10, cl_RA(1) / 10, 2).has_value());
  CHECK(decimal(0, 0, 5) == "0");
}
TEST_CASE("surds are numbers of one field, whatever their roots") {
  const auto root = [](int n) { return Surd::sqrt(n); };
  const Surd sum = root(2) + root(3) - root(5);
  CHECK(sum.text() == "sqrt(2)+sqrt(3)-sqrt(5)");
  CHECK(sum / sum == 1);
  CHECK((Surd(1) / sum).text() == "1/4*sqrt(2)+1/6*sqrt(3)+1/12*sqrt(30)");
  CHECK((root(2) + root(3)) * (root(2) + root(3)) == Surd(5) + Surd(2) * root(6));
  CHECK(root(8) - Surd(2) * root(2) == 0);
  CHECK(root(2 * 1009 * 1009) == Surd(1009) * root(2));  // no square that is looked for
  const Surd odd = root(2 * 1009 * 1009) + root(3 * 1009) + root(1013 * 1009);
  CHECK(odd / odd == 1);
  const Surd less(cln::cl_RA(1) / cln::expt(cl_RA(10), 100));
  CHECK(sum - less < sum);
  CHECK_FALSE(sum < sum);
  CHECK((sum - less - sum).to_double() == -1e-100);
  Surd ten = 0;  // as fractions their products took minutes
  for (int p : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29}) ten = ten + root(p);
  const Surd tiny(1 / cln::expt(cl_RA(10), 40)), per_ten = Surd(1) / ten;
  CHECK(ten * per_ten == 1);
  CHECK((ten * (per_ten - tiny) < 1 && Surd(1) < ten * (per_ten + tiny)));
  CHECK_THROWS_WITH(root(2) / (root(6) - root(2) * root(3)), "a division by 0");
  CHECK_THROWS_WITH(Surd::sqrt(root(2)), "a square root in a square root");
  CHECK_THROWS_WITH(root(-2), "the square root of a negative number");
}
