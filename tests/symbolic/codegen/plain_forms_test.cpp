// Plain, exact and matrix forms as they are generated, against the law of one collision, applied
// again and again in rationals; each domain at its ends, from both sides.
#include <Eigen/Core>

#include "catch.hpp"
#include "codegen/exact.hpp"
#include "law_of_collision.hpp"
#include "magicmass/exact/exact.hpp"
#include "magicmass/plain/closed.hpp"
#include "magicmass/plain/matrices.hpp"
#include "magicmass/plain/product.hpp"
#include "magicmass/plain/restitution.hpp"
#include "magicmass/plain/tangent.hpp"

namespace {
using namespace magicmass::generated;
using cln::cl_RA;

/// a, b, c and c' after n cycles.
std::array<cl_RA, 4> after(const cl_RA& alpha, std::int64_t n) {
  auto m = law::equal_blocks(alpha);
  cl_RA c = 0;
  while (m.N < 2 * n) {
    m.collide();
    if (!m.A_next()) c = m.v[2];
  }
  return {m.v[0], m.v[1], c, m.v[2]};
}
double near(const cl_RA& x) { return cln::double_approx(x); }
template <class Number>
concept Taken = requires(Number x) {
  velocities_tangent(x, 1);
};
static_assert(Taken<double> && Taken<long double> && Taken<float> && !Taken<int>);
/// Ends of domains are others for float, and what is lost is more.
template <class Number>
Number end(double in_double, double in_float) {
  return Number(sizeof(Number) > 4 ? in_double : in_float);
}
template <class Number>
constexpr double off = sizeof(Number) > 4 ? 1e-14 : 0x1p29 * 1e-14;
template <class Number>
concept TakenExactly = requires(Number x) {
  velocities_exact(x, 1);
};
static_assert(TakenExactly<cl_RA> && !TakenExactly<double> && !TakenExactly<int>);
template <class Number>
void check_near(Number got, const cl_RA& wanted, double off) {
  CHECK_THAT(double(got), WithinAbs(near(wanted), off));
}
template <class Number, class Velocities>
void check_velocities(const Velocities& got, Number alpha, std::int64_t n, double share) {
  const std::array<cl_RA, 4> v = after(codegen::exact(double(alpha)), n);
  const double of_ball = share * std::sqrt(1 / double(alpha));
  check_near(got.a, v[0], share);
  check_near(got.b, v[1], share);
  check_near(got.c, v[2], of_ball);
  check_near(got.c_prime, v[3], of_ball);
}
/// At both ends of its domain f answers, one step beyond them it does not.
template <class Number, class Function>
void check_domain(Number low, Number high, const Function& f) {
  CHECK_NOTHROW(f(low));
  CHECK_THROWS_AS(f(std::nextafter(low, Number(-INFINITY))), std::domain_error);
  CHECK_NOTHROW(f(high));
  CHECK_THROWS_AS(f(std::nextafter(high, Number(INFINITY))), std::domain_error);
}
}  // namespace

TEST_CASE("plain terminal velocities and counts are those of the collisions") {
  for (const cl_RA& alpha : {cl_RA("1"), cl_RA("1/7"), cl_RA("1/100"), cl_RA("9/10"), cl_RA("5")}) {
    auto m = law::equal_blocks(alpha);
    while (m.approach() > 0) m.collide();
    const int N_A = (m.N + 1) / 2, N_B = m.N / 2;
    const auto check = [&](const auto& got) {
      CHECK((got.N_A == double(N_A) && got.N_B == double(N_B)));
      check_near(got.a_t, m.v[0], 1e-13);
      check_near(got.b_t, m.v[1], 1e-13);
      check_near(got.c_t, m.v[2], 1e-13);
      check_near(got.rho, m.v[1] * m.v[1], 1e-13);
    };
    check(terminal_closed<double>(near(alpha)));
    check(terminal_product<double>(near(alpha)));
    check(terminal_tangent<double>(near(alpha)));
  }
  CHECK_THROWS_AS(terminal_exact<cl_RA>(1, 0, 1), std::domain_error);
  CHECK_THROWS_WITH(velocities_exact<cl_RA>(1, -1), ContainsSubstring("n from 0 to 0; or alpha"));
}
TEMPLATE_TEST_CASE("plain forms hold at the ends that they state", "", double, long double, float) {
  const auto least = end<TestType>(0x1p-300, 0x1p-22), most = end<TestType>(0x1p300, 0x1p22),
             low = end<TestType>(0x1p-300, 0x1p-16), high = end<TestType>(0x1p20, 0x1p16);
  for (std::int64_t n : {0, 1, 2, 7}) {
    for (const TestType alpha : {low, TestType(0.125), TestType(1), high}) {
      const double lost = off<TestType> * (1 + double(alpha));  // by a rounded psi
      check_velocities(velocities_closed(alpha, n), alpha, n, lost);
      check_velocities(velocities_product(alpha, n), alpha, n, lost);
      check_velocities(velocities_tangent(alpha, n), alpha, n, off<TestType>);
    }
    for (const auto& v : {velocities_tangent(most, n).c, velocities_product(most, n).c})
      CHECK(std::isfinite(v));
  }
  check_domain(low, high, [](auto x) { return velocities_closed(x, 1); });
  check_domain(least, most, [](auto x) { return velocities_product(x, 1); });
  check_domain(least, most, [](auto x) { return velocities_tangent(x, 1); });
  check_domain(end<TestType>(0x1p-40, 0x1p-16), high, [](auto x) { return terminal_closed(x); });
  const auto least_end = end<TestType>(0x1p-100, 0x1p-22), most_end = end<TestType>(0x1p48, 0x1p22);
  for (const auto& heavy : {terminal_product(most_end).N_B, terminal_tangent(most_end).N_B})
    CHECK(heavy == 1);
  check_domain(least_end, most_end, [](auto x) { return terminal_product(x); });
  check_domain(least_end, most_end, [](auto x) { return terminal_tangent(x); });
  check_domain(low, end<TestType>(0x1p300, 0x1p16), [](auto x) { return angle_closed(x); });
  check_domain(least, most, [](auto x) { return angle_tangent(x); });
  const std::int64_t last = std::int64_t(1) << (sizeof(TestType) > 4 ? 50 : 16);
  CHECK_NOTHROW(velocities_closed(TestType(1), last));
  CHECK_THROWS_AS(velocities_closed(TestType(1), last + 1), std::domain_error);
  CHECK_THROWS_AS(velocities_closed(TestType(1), -1), std::domain_error);
  CHECK_THROWS_AS(velocities_closed(TestType(NAN), 1), std::domain_error);
  CHECK_THROWS_AS(velocities_tangent(TestType(INFINITY), 1), std::domain_error);
  CHECK_THAT(ratios_closed<TestType>(1).beta_, WithinRel(std::sqrt(2.0) - 1, off<TestType>));
  CHECK_THROWS_AS(ratios_closed<TestType>(0), std::domain_error);
  CHECK_THROWS_AS(ratios_closed<TestType>(last + 1), std::domain_error);
  for (const auto alpha_2 : {ratios_closed<TestType>(2).alpha_, ratios_product<TestType>(2).alpha_,
                             ratios_tangent<TestType>(2).alpha_})
    CHECK_THAT(double(alpha_2), WithinRel(std::sqrt(5.0) - 2, off<TestType>));
  const double x = 3.141592653589793 / 20002;  // 1/cos(x) - 1, where the closed form cancels
  const auto matcher = WithinRel(x * x * (0.5 + x * x * 5 / 24), off<TestType>);
  CHECK_THAT(double(ratios_product<TestType>(10000).beta_), matcher);
  CHECK_THAT(double(ratios_tangent<TestType>(10000).beta_), matcher);
  CHECK_THAT(double(ratios_closed<TestType>(10000).beta_), !matcher);
}
TEMPLATE_TEST_CASE("matrices turn the velocities, and Lambda is Gamma_B Gamma_A and R l_3 R^T", "",
                   double, long double, float) {
  using Rows = Eigen::Matrix<TestType, 3, 3, Eigen::RowMajor>;
  const auto matrix = [](const auto& rows) { return Rows(&rows[0][0]); };
  const auto least = end<TestType>(0x1p-300, 0x1p-22), most = end<TestType>(0x1p300, 0x1p22);
  for (const TestType alpha : {least, TestType(0.125), TestType(3), most}) {
    const Rows whole = matrix(Lambda(alpha)), frame = matrix(R(alpha));
    const Rows by_A_and_B = matrix(Gamma_B(alpha)) * matrix(Gamma_A(alpha));
    const Rows turn = matrix(lambda_3(angle_tangent(alpha).psi));
    CHECK((by_A_and_B - whole).norm() <= off<TestType>);
    CHECK((frame * turn * frame.transpose() - whole).norm() <= off<TestType>);
    const auto v = velocities_tangent(alpha, 1);
    const Eigen::Vector<TestType, 3> moved(v.a, v.b, std::sqrt(alpha) * v.c_prime);
    CHECK((whole.col(0) - moved).norm() <= off<TestType>);
  }
  check_domain(least, most, [](auto x) { return Lambda(x); });
  check_domain(least, most, [](auto x) { return R(x); });
  check_domain(end<TestType>(-0x1p50, -0x1p22), end<TestType>(0x1p50, 0x1p22),
               [](auto x) { return lambda_3(x); });
}

TEST_CASE("forms with restitution, whose values 10,000 scenes hold, answer in their domain alone") {
  for (const double e : {0.95, 0.04}) {
    const double q_e = near(shape_exact<cl_RA>(3, 0, codegen::exact(0.2), codegen::exact(e)).q_e);
    const auto angle = [&](double q) { return angle_restitution(3.0, 0.0, 0.2, e, q); };
    const auto collapse = [&](double q, double W) {
      return collapse_restitution(3.0, 0.0, 0.2, e, q, 1.0, W, 0.5, 2.0);
    };
    CHECK_THROWS_WITH(angle(0.0), "angle_restitution: allowed: what its comment says");
    CHECK_THROWS_AS(collapse(0.1, -0.25), std::domain_error);
    if (e < 0.5) {
      CHECK_NOTHROW(collapse(q_e, -0.25));
      CHECK_THROWS_WITH(collapse(q_e, -9), ContainsSubstring("end_speed between"));  // B runs away
      continue;
    }
    const auto of_angle = angle(q_e);
    const double h_e = of_angle.h_e, unit = of_angle.step_sine;
    const auto time = [&](std::int64_t j) {
      const auto [now, last] = sines_restitution(3.0, 0.0, 0.2, e, q_e, h_e, unit, j);
      return time_restitution(3.0, 0.0, 0.2, e, unit, j, now, last, 1.0, -0.25, 0.5, 2.0);
    };
    const double N = count_restitution(3.0, 0.0, 0.2, e, q_e, h_e, unit, 1.0, -0.25).N_any;
    CHECK_NOTHROW(time(std::int64_t(N) - 1));
    CHECK_THROWS_AS(time(std::int64_t(N)), std::domain_error);
  }
}
