// SPDX-License-Identifier: GPL-2.0-or-later
// Terminal velocities with restitution against exact steps by the law of one collision.
#include <cmath>
#include <random>

#include "answers/errors.hpp"
#include "answers/motion.hpp"
#include "answers/velocities.hpp"
#include "catch.hpp"
#include "kernel/expr.hpp"
#include "law_of_collision.hpp"
#include "magicmass/numbers/fast.hpp"

using namespace answers;
using cln::cl_RA;

namespace {
/// Blocks of mass 1, a ball of mass alpha, B at 1 from A and C.
law::ThreeBodies<cl_RA> bodies(const cl_RA& alpha, const cl_RA& e) {
  return {1, 1, alpha, e, {1, 0, 0}, {0, 1, 0}};
}
std::string shown(const cl_RA& exact) { return real_cell(cln::double_approx(exact)).text; }
Row asked(const std::string& alpha, const std::string& e, const std::string& tier = "accurate") {
  Request request;
  request.options = {{"alpha", alpha}, {"restitution", e}, {"tier", tier}};
  const Table table = answers::terminal(request).table;
  CHECK(table.columns == terminal_columns(request));
  return table.rows[0];
}
}  // namespace

TEST_CASE("collisions that never end come to an end in time") {
  for (const auto& [alpha, e] : {std::pair{"1/10", "1/20"}, {"2/2", "1/20"}, {"1/4", "1/4"}}) {
    const Row row = asked(alpha, e);
    const double end = std::stod(row[8].text);
    auto steps = bodies(std::get<cl_RA>(alpha_of(alpha)), std::get<cl_RA>(alpha_of(e)));
    for (int i = 0; i < 60; ++i) {
      steps.collide();
      steps.wait();
    }
    INFO(alpha << " " << e);
    CHECK(cln::double_approx(steps.time) <= end);
    CHECK(cln::double_approx(steps.time) > end * 0.95);
  }
}
TEST_CASE("tier exact is in fractions") {
  for (const auto& [alpha, e] : {std::pair{"1/7", "9/10"}, {"0.1", "0.75"}, {"3", "1/3"}}) {
    const cln::cl_RA mass = *fraction_of(alpha_of(alpha));
    auto steps = bodies(mass, *fraction_of(alpha_of(e)));
    while (steps.approach() > 0) steps.collide();
    const auto& [a, b, c] = steps.v;
    const Row row = asked(alpha, e, "exact");
    const cl_RA values[]{a, b, c, b * b};
    const Trio trio = Trio::equal_blocks(value_of(mass), *fraction_of(alpha_of(e)));
    const Row near = rounded([&] { return answers::terminal(trio, steps.N); });
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(row[4 + i].text == kernel::digits(values[i]));
      CHECK(near[i].text == shown(values[i]));
    }
  }
}
TEST_CASE("any masses, a wall, many collisions: the evaluator says what scenes say") {
  std::mt19937_64 random(30);
  const auto number = [&] { return double(random() >> 11) * 0x1p-53; };
  int ended = 0;
  for (int row = 0; row < 200; ++row) {
    const bool is_wall = row % 3 == 0;
    const double ball = std::exp2(-30 * number()),
                 per_B = std::exp2(std::floor(30 * number() - 15));
    const double e = row % 2 == 0 ? 1 : 1 - std::exp2(-30 * number());
    Trio::Start start{{value_of(1), value_of(ball)}, magicmass::scenes::Quadratic(e)};
    if (!is_wall) start.masses.push_back(value_of(1 / per_B));
    const Trio trio = Trio::of(start).value();
    const auto N = trio.count();
    const auto t = magicmass::fast::terminal({ball, is_wall ? 0 : per_B}, e);
    INFO("ball " << ball << ", 1/B " << per_B << ", wall " << is_wall << ", e " << e);
    REQUIRE(t.has_value() == N.has_value());
    if (!N) continue;
    ++ended;
    REQUIRE(t->counts == magicmass::Counts{(*N + 1) / 2, *N / 2});
    const double got[] = {t->a_t, t->c_t, t->b_t};
    const auto velocities = trio.velocities(trio.shape(), *N);
    for (std::size_t i = 0; i < velocities.size(); ++i)
      CHECK_THAT(got[i],
                 Catch::Matchers::WithinRel(cln::double_approx(velocities[i].low()), 1e-13));
  }
  CHECK(ended > 150);
}
