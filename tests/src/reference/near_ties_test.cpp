// SPDX-License-Identifier: GPL-2.0-or-later
// Decisions of doubles against exact ones: none is wrong without a mark before it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/line_motion.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using cln::cl_RA;

namespace {

/// Gaps in the order in which they closed.
struct Sequence {
  std::vector<std::size_t> gaps;
  bool ended = false;
};

template <class Scalar>
Sequence closed(LineMotion<Scalar>& motion, std::int64_t most) {
  Sequence sequence;
  while (motion.next() && motion.events() < most) sequence.gaps.push_back(motion.step().gap);
  sequence.ended = !motion.next();
  return sequence;
}

/// Number of the first event of `doubles` that is another one in truth. Contacts without a common body may change
/// places, so only the order within each two gaps side by side is compared.
std::optional<std::int64_t> first_wrong(const Sequence& doubles, const Sequence& exact,
                                        std::size_t bodies) {
  std::optional<std::int64_t> wrong;
  const auto found = [&](std::size_t number) {
    const auto n = static_cast<std::int64_t>(number);
    wrong = wrong ? std::min(*wrong, n) : n;
  };
  for (std::size_t gap = 0; gap < bodies; ++gap) {
    std::vector<std::size_t> there;
    for (const std::size_t g : exact.gaps)
      if (g == gap || g == gap + 1) there.push_back(g);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < doubles.gaps.size(); ++i) {
      const std::size_t g = doubles.gaps[i];
      if (g != gap && g != gap + 1) continue;
      if (seen < there.size() ? there[seen] != g : exact.ended) found(i + 1);
      ++seen;
    }
    if (doubles.ended && exact.ended && seen < there.size()) found(doubles.gaps.size() + 1);
  }
  return wrong;
}

struct Outcome {
  int wrong = 0;
  int marked = 0;
  int unmarked_and_wrong = 0;
};

void judge(const Line<double>& line, Outcome& outcome) {
  LineMotion<double> rounded(line);
  LineMotion<cl_RA> truth(converted<cl_RA>(line, [](double x) { return reference::exact(x); }));
  const Sequence got = closed(rounded, 40);
  const auto wrong = first_wrong(got, closed(truth, 40), line.bodies());
  const Ties& ties = rounded.ties();
  outcome.wrong += wrong ? 1 : 0;
  outcome.marked += ties.near > 0 ? 1 : 0;
  if (wrong && !(ties.near > 0 && ties.first_near < *wrong)) ++outcome.unmarked_and_wrong;
}

Line<double> generic(testing::Generator& generator, double e) {
  Line<double> line;
  for (std::size_t i = 0; i < 4; ++i) {
    line.masses.push_back(testing::log_uniform(generator, 0.1, 10.0));
    line.positions.push_back(static_cast<double>(i) + testing::log_uniform(generator, 0.1, 0.9));
    line.velocities.push_back(testing::log_uniform(generator, 0.1, 3.0) *
                              (generator() % 2 == 0 ? 1.0 : -1.0));
  }
  line.left_wall = -0.5;
  line.right_wall = 4.5;
  line.restitution = e;
  return line;
}

/// Three bodies that all but meet at once, apart by `off`.
Line<double> all_but_tied(testing::Generator& generator, double off) {
  const double u = testing::log_uniform(generator, 0.5, 2.0);
  const double w = testing::log_uniform(generator, 0.5, 2.0);
  Line<double> line{{}, {-u, off, w}, {u, 0.0, -w}, -5.0, 5.0};
  for (int i = 0; i < 3; ++i) line.masses.push_back(testing::log_uniform(generator, 0.1, 10.0));
  return line;
}

}  // namespace

TEST_CASE("a decision of doubles that is wrong is marked before it", "[check]") {
  testing::Generator generator(91);
  Outcome everyday, tied;
  for (int i = 0; i < 200; ++i) judge(generic(generator, i % 2 == 0 ? 1.0 : 0.9), everyday);
  for (int i = 0; i < 400; ++i) {
    const double size = testing::log_uniform(generator, 1e-18, 1e-12);
    judge(all_but_tied(generator, i % 2 == 0 ? size : -size), tied);
  }
  CAPTURE(everyday.wrong, everyday.marked, tied.wrong, tied.marked);
  CHECK(everyday.unmarked_and_wrong == 0);
  CHECK(tied.unmarked_and_wrong == 0);
  CHECK(tied.wrong > 0);        // there was something to mark
  CHECK(everyday.marked == 0);  // and nothing else is
  CHECK(tied.marked > tied.wrong);
}

namespace {

/// Masses of any size next to each other, equal ones among them, and bodies that touch.
Line<double> harsh(testing::Generator& generator) {
  Line<double> line;
  const std::size_t bodies = 2 + generator() % 5;
  for (std::size_t i = 0; i < bodies; ++i) {
    const bool same = i > 0 && generator() % 3 == 0;
    line.masses.push_back(same ? line.masses.back() : testing::log_uniform(generator, 1e-9, 1e9));
    line.positions.push_back(
        static_cast<double>(i) +
        (generator() % 4 == 0 ? 0.0 : testing::log_uniform(generator, 0.01, 0.99)));
    line.velocities.push_back(generator() % 3 == 0 ? 0.0
                                                   : testing::log_uniform(generator, 1e-3, 1e3) *
                                                         (generator() % 2 == 0 ? 1.0 : -1.0));
  }
  if (generator() % 2 == 0) line.left_wall = -0.5;
  if (generator() % 2 == 0) line.right_wall = static_cast<double>(bodies);
  line.restitution = generator() % 2 == 0 ? 1.0 : testing::log_uniform(generator, 0.3, 1.0);
  return line;
}

double off(double got, const cl_RA& want) {
  return reference::nearest<double>(cln::abs(reference::exact(got) - want));
}

}  // namespace

TEST_CASE("masses, speeds and restitutions of any size: no wrong decision without a mark",
          "[check]") {
  testing::Generator generator(92);
  Outcome outcome;
  for (int i = 0; i < 300; ++i) judge(harsh(generator), outcome);
  CAPTURE(outcome.wrong, outcome.marked);
  CHECK(outcome.unmarked_and_wrong == 0);
}

TEST_CASE("the margin bounds the true error, and is not a thousand times as large", "[check]") {
  testing::Generator generator(93);
  int tight = 0, compared = 0;
  for (int i = 0; i < 200; ++i) {
    const Line<double> line = i % 2 == 0 ? harsh(generator) : generic(generator, 1.0);
    LineMotion<double> rounded(line);
    LineMotion<cl_RA> truth(converted<cl_RA>(line, [](double x) { return reference::exact(x); }));
    for (int j = 0; j < 30 && rounded.next() && truth.next(); ++j) {
      if (rounded.step().gap != truth.step().gap || rounded.ties().near > 0) break;
      double velocities = 0.0, positions = 0.0;
      const double time = std::max(rounded.now(), reference::nearest<double>(truth.now()));
      for (std::size_t b = 0; b < line.bodies(); ++b) {
        const double m = line.masses[b];
        const double dv = off(rounded.body(b).velocity, truth.body(b).velocity);
        // Where both are at the later of the two times, followed back or on by their own velocities.
        const auto& body = rounded.body(b);
        const cl_RA here = reference::exact(body.position) +
                           reference::exact(body.velocity) *
                               (reference::exact(time) - reference::exact(body.since));
        const double dx =
            reference::nearest<double>(cln::abs(here - truth.position(b, reference::exact(time))));
        velocities += m * dv * dv;
        positions += m * dx * dx;
      }
      REQUIRE(std::sqrt(velocities) <= rounded.margin().of_velocities());
      REQUIRE(std::sqrt(positions) <= rounded.margin().of_positions(time) * 1.01 + 1e-300);
      if (i % 2 == 1 && j == 29) {
        ++compared;
        tight += rounded.margin().of_velocities() <= 1000 * std::sqrt(velocities) ? 1 : 0;
      }
    }
  }
  CAPTURE(tight, compared);
  CHECK(compared > 50);
  CHECK(tight > compared / 2);
}

TEST_CASE("a busy chain of a thousand blocks runs 100,000 events without a mark", "[check]") {
  testing::Generator generator(94);
  Line<double> line;
  for (std::size_t i = 0; i < 1999; ++i) {
    line.masses.push_back(i % 2 == 0 ? 1.0 : 0.3);
    line.positions.push_back(static_cast<double>(i) + testing::log_uniform(generator, 0.1, 0.9));
    line.velocities.push_back(testing::log_uniform(generator, 0.1, 1.0) *
                              (generator() % 2 == 0 ? 1.0 : -1.0));
  }
  line.left_wall = -1.0;
  line.right_wall = 2000.0;
  LineMotion<double> motion(line);
  for (int i = 0; i < 100000; ++i) motion.step();
  CHECK(motion.ties().near <= 1);
}

TEST_CASE("a sequence with another order side by side is seen to be wrong", "[exam]") {
  CHECK(first_wrong({{1, 2, 1}, true}, {{1, 2, 1}, true}, 3) == std::nullopt);
  CHECK(first_wrong({{1, 3, 2}, true}, {{3, 1, 2}, true}, 4) == std::nullopt);
  CHECK(first_wrong({{1, 2, 1}, true}, {{2, 1, 2}, true}, 3) == 1);
  CHECK(first_wrong({{1, 2}, true}, {{1, 2, 1}, true}, 3) == 3);
}
