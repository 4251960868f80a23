// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/eigen.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/accurate.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/simulator/velocity_stepping.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

// Allocations are counted, to see that no array is copied: the linker puts this in place of malloc (--wrap), which Eigen
// calls itself.
namespace {
std::size_t allocations = 0;
}
extern "C" {
void* __real_malloc(std::size_t size);
void* __wrap_malloc(std::size_t size) {
  ++allocations;
  return __real_malloc(size);
}
}

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Many alphas with the last n of each.
struct Inputs {
  Eigen::ArrayXd alpha;
  Eigen::Array<std::int64_t, Eigen::Dynamic, 1> n;
};
Inputs inputs(int size) {
  testing::Generator generator(3);
  Inputs all{Eigen::ArrayXd(size), Eigen::Array<std::int64_t, Eigen::Dynamic, 1>(size)};
  for (int i = 0; i < size; ++i) {
    all.alpha(i) = testing::log_uniform(generator, 1e-6, 10);
    all.n(i) = testing::whole(generator, 0, count_collisions(all.alpha(i))->N_B);
  }
  return all;
}

}  // namespace

TEST_CASE("V_n is Lambda V_(n-1), of length 1, and its components are the paper's", "[check]") {
  testing::Generator generator(5);
  for (int i = 0; i < 300; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-6, 100);
    const std::int64_t last = count_collisions(alpha)->N_B;
    const std::int64_t n = testing::whole(generator, 1, last);
    INFO("alpha = " << alpha << ", n = " << n);
    const Eigen::Vector3d V = V_n(alpha, n), before = V_n(alpha, n - 1);
    CHECK((V - Lambda(alpha) * before).cwiseAbs().maxCoeff() <= 30 * eps);
    CHECK(std::fabs(V.norm() - 1) <= 20 * eps);
    const auto exact = accurate::velocities(alpha, n);
    const Eigen::Vector3d expected(exact.a, exact.b, std::sqrt(alpha) * exact.c_prime);
    CHECK((V - expected).cwiseAbs().maxCoeff() <= 11 * eps);
  }
  CHECK(V_n(0.12, 0) == Eigen::Vector3d(1, 0, 0));
}

TEST_CASE("the simulator's velocities are V_n's", "[check]") {
  const double alpha = 0.003;
  step_velocities(alpha, 1.0, 1000, [&](const VelocityEvent<double>& event) {
    if (event.body != Body::B) return;
    const Eigen::Vector3d seen(event.after.a, event.after.b, std::sqrt(alpha) * event.after.c);
    CHECK((V_n(alpha, event.n) - seen).cwiseAbs().maxCoeff() <= 1e-13);
  });
}

TEST_CASE("R is a rotation that turns Lambda into one about the third axis", "[check]") {
  testing::Generator generator(6);
  for (int i = 0; i < 300; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-9, 1e9);
    INFO("alpha = " << alpha);
    const Eigen::Matrix3d turn = R(alpha), cycle = Lambda(alpha);
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    CHECK((turn.transpose() * turn - one).cwiseAbs().maxCoeff() <= 12 * eps);
    CHECK((cycle.transpose() * cycle - one).cwiseAbs().maxCoeff() <= 12 * eps);
    CHECK((cycle * turn.col(2) - turn.col(2)).cwiseAbs().maxCoeff() <= 12 * eps);
    const double psi = accurate::angle(alpha);
    Eigen::Matrix3d about_third = one;
    about_third.topLeftCorner<2, 2>() << std::cos(psi), -std::sin(psi), std::sin(psi),
        std::cos(psi);
    CHECK((turn.transpose() * cycle * turn - about_third).cwiseAbs().maxCoeff() <= 24 * eps);
  }
  CHECK((Lambda(0.2).transpose() - Lambda(0.2)).norm() > 0.1);  // the order of rows can be wrong
}

TEST_CASE("entries keep their bounds in float, against double", "[check]") {
  testing::Generator generator(7);
  constexpr double in_float = std::numeric_limits<float>::epsilon();
  double worst = 0, worst_V = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto alpha = static_cast<float>(testing::log_uniform(generator, 1e-6, 1e6));
    const auto wide = static_cast<double>(alpha);
    worst = std::max(worst, (Lambda(alpha).cast<double>() - Lambda(wide)).cwiseAbs().maxCoeff());
    worst = std::max(worst, (R(alpha).cast<double>() - R(wide)).cwiseAbs().maxCoeff());
    const std::int64_t n = testing::whole(generator, 0, count_collisions(wide)->N_B);
    worst_V =
        std::max(worst_V, (V_n(alpha, n).cast<double>() - V_n(wide, n)).cwiseAbs().maxCoeff());
  }
  CHECK(worst <= 4 * in_float);
  CHECK(worst_V <= 10 * in_float);
  CHECK(worst_V > 0.5 * in_float);
}

TEST_CASE("arrays, maps and columns go to the kernels without a copy", "[exam]") {
  const Inputs in = inputs(1000);
  const Eigen::Index size = in.alpha.size();
  std::vector<double> memory(static_cast<std::size_t>(size));
  Eigen::Map<Eigen::ArrayXd> a(memory.data(), size);
  Eigen::MatrixXd rest(size, 3);
  CHECK(eigen::column<double>(in.alpha).data() == in.alpha.data());
  CHECK(eigen::column<double>(a).data() == memory.data());
  CHECK(eigen::column<double>(rest.col(1)).data() == rest.data() + size);
  const Eigen::Ref<const Eigen::ArrayXd> alpha = in.alpha;
  CHECK(eigen::column<double>(alpha).data() == in.alpha.data());
  const std::size_t before = allocations;
  fast::velocities(alpha, in.n, a, rest.col(0), rest.col(1), rest.col(2));
  CHECK(allocations == before);
  const Eigen::ArrayXd copied = a + 1;
  CHECK(allocations > before);  // and the counting works

  const auto one = fast::velocities(in.alpha(7), in.n(7));
  CHECK(a(7) == Approx(one.a).epsilon(1e-14));
  Eigen::ArrayXd b(size), c(size), c_prime(size);
  accurate::velocities(alpha, in.n, a, b, c, c_prime);
  CHECK(a(7) == accurate::velocities(in.alpha(7), in.n(7)).a);
}

TEST_CASE("every batch function takes arrays", "[exam]") {
  const Inputs in = inputs(50);
  Eigen::Array<std::int64_t, Eigen::Dynamic, 1> N_A(50), N_B(50);
  Eigen::ArrayXd a(50), b(50), c(50), d(50);
  count_collisions(in.alpha, N_A, N_B);
  CHECK(N_A(3) == count_collisions(in.alpha(3))->N_A);
  for (const auto terminal : {0, 1}) {
    if (terminal == 0) fast::terminal(in.alpha, N_A, N_B, a, b, c);
    if (terminal == 1) accurate::terminal(in.alpha, N_A, N_B, a, b, c);
    CHECK(b(4) == Approx(accurate::terminal(in.alpha(4))->b_t));
  }
  velocity_stream(1e-5, 2, a, b, c, d);
  CHECK(d(0) == Approx(accurate::velocities(1e-5, 2).c_prime));
  for (const auto at_n : {0, 1}) {
    if (at_n == 0) fast::velocities(in.alpha, 1, a, b, c, d);
    if (at_n == 1) accurate::velocities(in.alpha, 1, a, b, c, d);
    CHECK(b(4) == Approx(accurate::velocities(in.alpha(4), 1).b));
  }
  fast::transmission(in.alpha, 1.0, a);
  CHECK(a(4) == Approx(accurate::terminal(in.alpha(4))->rho));
  fast::ratios(1, a, b);
  accurate::ratios(1, c, d);
  CHECK(c(2) == accurate::ratios(3).magic);
  CHECK(b(2) == Approx(d(2)));
}

TEST_CASE("sizes that differ, overlaps and strides are refused", "[exam]") {
  const Inputs in = inputs(8);
  Eigen::ArrayXd a(8), b(8), c(8), d(8), shorter(7);
  CHECK_THROWS_WITH(fast::velocities(in.alpha, in.n, a, b, c, shorter),
                    Catch::Contains("c_prime has 7 elements and alpha has 8"));
  CHECK_THROWS_WITH(fast::velocities(in.alpha, in.n, a, b, c, c), Catch::Contains("overlap"));
  Eigen::ArrayXd wide(16);
  Eigen::Map<Eigen::ArrayXd, 0, Eigen::InnerStride<>> every_other(wide.data(), 8,
                                                                  Eigen::InnerStride<>(2));
  CHECK_THROWS_WITH(fast::velocities(in.alpha, in.n, a, b, c, every_other),
                    Catch::Contains("their stride is 2"));
  STATIC_REQUIRE(eigen::WritableDoubles<Eigen::ArrayXd&>);
  STATIC_REQUIRE(eigen::WritableDoubles<Eigen::Ref<Eigen::ArrayXd>>);
  STATIC_REQUIRE_FALSE(eigen::WritableDoubles<const Eigen::ArrayXd&>);
  STATIC_REQUIRE_FALSE(eigen::Doubles<Eigen::ArrayXXd>);
  STATIC_REQUIRE_FALSE(eigen::Doubles<decltype(a + b)>);  // has no memory
  STATIC_REQUIRE_FALSE(eigen::Doubles<Eigen::ArrayXf>);
}
