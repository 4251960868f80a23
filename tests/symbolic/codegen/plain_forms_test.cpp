// SPDX-License-Identifier: GPL-2.0-or-later
// Plain, exact and matrix forms as they are generated, against the law of one collision, applied
// again and again in rationals; each domain at its ends, from both sides.
#include <cmath>
#include <limits>
#include <stdexcept>

#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>

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

/// By the law alone: V = L = 1.
template <class Number>
law::ThreeBodies<Number> bodies(Number A_mass, Number per_B, Number ball, Number e) {
  return {A_mass, per_B, ball, e, {1, 0, 0}, {0, 1, 0}};
}
/// a, b, c and c' after n cycles.
std::array<cl_RA, 4> after(const cl_RA& alpha, std::int64_t n) {
  law::ThreeBodies<cl_RA> m = bodies<cl_RA>(1, 1, alpha, 1);
  cl_RA c = 0;
  while (m.N < 2 * n) {
    m.collide();
    if (!m.A_next()) c = m.v[2];
  }
  return {m.v[0], m.v[1], c, m.v[2]};
}
double near(const cl_RA& x) { return cln::double_approx(x); }
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

TEST_CASE("exact velocities are those of the collisions, for any n") {
  for (const cl_RA& alpha : {cl_RA("1"), cl_RA("1/7"), cl_RA("22/7"), cl_RA("1/1000003")}) {
    for (int n = 0; n <= 40; ++n) {
      const auto v = velocities_exact<cl_RA>(alpha, n);
      CHECK(std::array{v.a, v.b, v.c, v.c_prime} == after(alpha, n));
    }
  }
}
TEST_CASE("exact terminal velocities, from the counts") {
  for (const cl_RA& alpha : {cl_RA("1"), cl_RA("1/7"), cl_RA("1/100"), cl_RA("9/10"), cl_RA("5")}) {
    law::ThreeBodies<cl_RA> m = bodies<cl_RA>(1, 1, alpha, 1);
    while (m.approach() > 0) m.collide();
    const int N_A = (m.N + 1) / 2, N_B = m.N / 2;
    const auto [a, b, ball] = m.v;
    const auto v = terminal_exact<cl_RA>(alpha, N_A, N_B);
    CHECK((v.a_t == a && v.b_t == b && v.c_t == ball && v.rho == b * b));
    const auto closed = terminal_closed<double>(near(alpha));
    const auto tangent = terminal_tangent<double>(near(alpha));
    CHECK((closed.N_A == double(N_A) && closed.N_B == double(N_B)));
    CHECK((tangent.N_A == double(N_A) && tangent.N_B == double(N_B)));
    check_near(closed.b_t, b, 1e-13);
    check_near(tangent.a_t, a, 1e-14);
    check_near(tangent.c_t, ball, 1e-13);
    check_near(tangent.rho, b * b, 1e-14);
  }
  CHECK_THROWS_AS(terminal_exact<cl_RA>(1, 0, 1), std::domain_error);
  CHECK_THROWS_AS(velocities_exact<cl_RA>(1, -1), std::domain_error);
}
TEMPLATE_TEST_CASE("plain velocities hold at the ends of what they state", "", double,
                   long double) {
  const TestType least = TestType(0x1p-300), most = TestType(0x1p300);
  for (std::int64_t n : {0, 1, 2, 7}) {
    for (const TestType alpha : {least, TestType(0.125), TestType(1), TestType(0x1p20)}) {
      const double lost = 1 + double(alpha);  // what a rounded psi loses
      check_velocities(velocities_closed(alpha, n), alpha, n, 1e-14 * lost);
      check_velocities(velocities_product(alpha, n), alpha, n, 1e-14 * lost);
      check_velocities(velocities_tangent(alpha, n), alpha, n, 1e-14);
    }
    for (const auto& v : {velocities_tangent(most, n).c, velocities_product(most, n).c})
      CHECK(std::isfinite(v));
  }
  check_domain(least, TestType(0x1p20), [](auto x) { return velocities_closed(x, 1); });
  check_domain(least, most, [](auto x) { return velocities_product(x, 1); });
  check_domain(least, most, [](auto x) { return velocities_tangent(x, 1); });
  check_domain<TestType>(0x1p-40, 0x1p20, [](auto x) { return terminal_closed(x); });
  check_domain<TestType>(0x1p-100, 0x1p100, [](auto x) { return terminal_tangent(x); });
  check_domain(least, most, [](auto x) { return angle_closed(x); });
  check_domain(least, most, [](auto x) { return angle_tangent(x); });
  const std::int64_t last = std::int64_t(1) << 50;
  CHECK_NOTHROW(velocities_closed(TestType(1), last));
  CHECK_THROWS_AS(velocities_closed(TestType(1), last + 1), std::domain_error);
  CHECK_THROWS_AS(velocities_closed(TestType(1), -1), std::domain_error);
  CHECK_THROWS_AS(velocities_closed(std::numeric_limits<TestType>::quiet_NaN(), 1),
                  std::domain_error);
  CHECK_THROWS_AS(velocities_tangent(std::numeric_limits<TestType>::infinity(), 1),
                  std::domain_error);
  CHECK_NOTHROW(magic_closed<TestType>(1));
  CHECK_THROWS_AS(magic_closed<TestType>(0), std::domain_error);
  CHECK_THROWS_AS(deficient_closed<TestType>(0), std::domain_error);
  CHECK_THAT(double(magic_closed<TestType>(2).alpha_), WithinRel(std::sqrt(5.0) - 2, 0x1p-50));
  CHECK_THAT(double(deficient_closed<TestType>(1).beta_), WithinRel(std::sqrt(2.0) - 1, 0x1p-50));
}
TEMPLATE_TEST_CASE("matrices turn the velocities, and Lambda is Gamma_B Gamma_A and R l_3 R^T", "",
                   double, long double) {
  using Rows = std::array<std::array<TestType, 3>, 3>;
  const auto times = [](const Rows& x, const Rows& y) {
    Rows r{};
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t k = 0; k < 3; ++k) r[i / 3][i % 3] += x[i / 3][k] * y[k][i % 3];
    return r;
  };
  const auto is_near = [](const Rows& x, const Rows& y) {
    double off = 0;
    for (std::size_t i = 0; i < 9; ++i)
      off = std::max(off, std::fabs(double(x[i / 3][i % 3] - y[i / 3][i % 3])));
    return off < 1e-14;
  };
  for (const TestType alpha :
       {TestType(0x1p-300), TestType(0.125), TestType(3), TestType(0x1p300)}) {
    const Rows whole = Lambda(alpha);
    CHECK(is_near(whole, times(Gamma_B(alpha), Gamma_A(alpha))));
    Rows turned{};
    for (std::size_t i = 0; i < 9; ++i) turned[i / 3][i % 3] = R(alpha)[i % 3][i / 3];
    const TestType psi = angle_closed(alpha).psi;
    CHECK(is_near(whole, times(R(alpha), times(lambda_3(psi), turned))));
    const auto v = velocities_tangent(alpha, 1);
    CHECK_THAT(double(whole[0][0]), WithinAbs(double(v.a), 1e-14));
    CHECK_THAT(double(whole[1][0]), WithinAbs(double(v.b), 1e-14));
    CHECK_THAT(double(whole[2][0]), WithinAbs(double(std::sqrt(alpha) * v.c_prime), 1e-14));
  }
  check_domain<TestType>(0x1p-300, 0x1p300, [](auto x) { return Lambda(x); });
  check_domain<TestType>(0x1p-300, 0x1p300, [](auto x) { return R(x); });
  check_domain<TestType>(-0x1p50, 0x1p50, [](auto x) { return lambda_3(x); });
}

TEST_CASE("three bodies with restitution, and a wall, move as their laws say") {
  constexpr double near_enough = 1e-11;
  for (auto m : {bodies<double>(1, 1, 0.1, 1), bodies<double>(2, 0.3, 0.25, 0.9),
                 bodies<double>(1, 0, 0.01, 1), bodies<double>(3, 0, 0.2, 0.95),
                 bodies<double>(0.5, 4, 0.02, 0.98)}) {
    const double q_e = shape_exact(m.A_mass, m.per_B, m.ball, m.e).q_e;
    const double h_e = angle_restitution(m.A_mass, m.per_B, m.ball, m.e, q_e).h_e;
    const double V = 1, W = -0.25, d_A = 0.5, d_B = 2;
    m.v = {V + W, 0, W};
    m.place = {-d_A - d_B, 0, -d_B};
    const auto form = [&](const auto& of, auto... more) {
      return of(m.A_mass, m.per_B, m.ball, m.e, q_e, h_e, V, W, more...);
    };
    const double N = form(count_restitution<double>).N_any;
    double power = 1;
    int j = 0;
    for (; m.approach() > 0; ++j, power *= std::sqrt(m.e)) {
      INFO("collision " << j << ", wall: " << (m.per_B == 0));
      m.wait();
      const double turn = j % 2 == 0 ? 1 : -1, near = near_enough * (1 + m.time);
      const double moment = form(time_restitution<double>, d_A, d_B, j).moment;
      CHECK(std::fabs(moment - m.time) <= near);
      const auto at = form(at_restitution<double>, d_A, d_B, moment, j, turn, power);
      CHECK(std::fabs(at.A_at - m.place[0]) <= near);
      CHECK(std::fabs(at.B_at - m.place[1]) <= near);
      CHECK(std::fabs(at.C_at - m.place[2]) <= 10 * near);
      m.collide();
      const auto after = form(at_restitution<double>, 0.0, 0.0, 1.0, j, turn, power);
      CHECK(std::fabs(after.A_at - m.v[0]) <= near_enough);
      CHECK(std::fabs(after.B_at - m.v[1]) <= near_enough);
      CHECK(std::fabs(after.C_at - m.v[2]) <= 10 * near_enough);
    }
    CHECK(N == j);
    CHECK_THROWS_AS(form(time_restitution<double>, d_A, d_B, j), std::domain_error);
    CHECK_THROWS_AS(angle_restitution(m.A_mass, m.per_B, m.ball, m.e, 0.0), std::domain_error);
  }
}

TEST_CASE("the time of a collapse is what the times of collisions come to") {
  for (auto m : {bodies<double>(1, 1, 1, 0.05), bodies<double>(2, 0, 0.5, 0.04)}) {
    const double q_e = shape_exact(m.A_mass, m.per_B, m.ball, m.e).q_e;
    const double V = 1, W = -0.1, d_A = 0.5, d_B = 2;
    m.v = {V + W, 0, W};
    m.place = {-d_A - d_B, 0, -d_B};
    for (int j = 0; j < 30; ++j) {
      m.wait();
      m.collide();
    }
    const auto at = [&](double q, double speed) {
      return collapse_restitution(m.A_mass, m.per_B, m.ball, m.e, q, V, speed, d_A, d_B);
    };
    CHECK(std::fabs(at(q_e, W).t_any - m.time) <= 1e-8);
    CHECK(std::fabs(at(q_e, W).x_any - m.place[2]) <= 1e-8);
    CHECK(std::fabs(at(q_e, W).v_any - m.v[2]) <= m.v[0] - m.v[1]);
    CHECK_THROWS_AS(at(0.1, W), std::domain_error);
    CHECK_THROWS_AS(at(q_e, -9), std::domain_error);  // B runs away
  }
}
