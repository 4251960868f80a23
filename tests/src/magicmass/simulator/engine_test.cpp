// The engine against conservation laws, and in a mirror.
#include "magicmass/simulator/engine.hpp"

#include <random>

#include <cln/rational.h>

#include "catch.hpp"

using namespace magicmass::simulator;
using cln::cl_RA;

namespace {

/// Of small fractions, so that collisions at one time are common.
template <class Scalar>
Line<Scalar> random_line(std::uint64_t seed, int below, const Scalar& e) {
  std::mt19937_64 random(seed);
  const auto fraction = [&](int least, int most, int parts) {
    const auto range = static_cast<std::uint64_t>((most - least) * parts + 1);
    return Scalar(least * parts + static_cast<int>(random() % range)) / Scalar(parts);
  };
  Line<Scalar> line;
  const std::size_t bodies = 1 + random() % 6;
  for (std::size_t i = 0; i < bodies; ++i) {
    line.masses.push_back(fraction(1, 3, 1));
    line.velocities.push_back(fraction(-2, 2, below));
    line.positions.push_back(fraction(0, below == 1 ? 2 : 6, below));
  }
  std::sort(line.positions.begin(), line.positions.end());
  if (random() % 2 == 0) line.left_wall = Scalar(-1);
  if (random() % 2 == 0) line.right_wall = Scalar(7);
  line.restitution = e;
  return line;
}

template <class Scalar>
std::vector<Collision<Scalar>> run(Engine<Scalar>& engine, int most) {
  std::vector<Collision<Scalar>> events;
  while (most-- > 0 && engine.next()) events.push_back(engine.step());
  while (engine.next() && *engine.next() == engine.now()) events.push_back(engine.step());
  return events;
}

/// Which law a list of collisions breaks, from the velocities that it tells alone; "" for none.
std::string broken_law(const Line<cl_RA>& line, const std::vector<Collision<cl_RA>>& events) {
  std::vector<cl_RA> v = line.velocities;
  const cl_RA e = line.restitution;
  const auto sum = [&](bool squares) {
    cl_RA total = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      total = total + line.masses[i] * v[i] * (squares ? v[i] : cl_RA(1));
    return total;
  };
  for (std::size_t i = 0; i < events.size();) {
    const std::size_t first = i;
    const cl_RA momentum = sum(false), energy = sum(true);
    bool has_wall = false;
    cl_RA closing = 0;
    for (; i < events.size() && events[i].time == events[first].time; ++i) {
      const std::size_t gap = events[i].gap;
      const bool has_left = gap > 0, has_right = gap < v.size();
      closing = (has_left ? v[gap - 1] : cl_RA(0)) - (has_right ? v[gap] : cl_RA(0));
      if (has_left) v[gap - 1] = events[i].v_left;
      if (has_right) v[gap] = events[i].v_right;
      has_wall = has_wall || !has_left || !has_right;
    }
    const bool is_alone = i == first + 1;
    if (first > 0 && events[first].time < events[first - 1].time) return "time";
    if (!has_wall && sum(false) != momentum) return "momentum";
    if (e == 1 ? sum(true) != energy : sum(true) > energy) return "energy";
    if (is_alone && !(0 < closing)) return "approach";
    if (is_alone && events[first].v_left - events[first].v_right != -e * closing)
      return "restitution";
  }
  return "";
}

/// Compares a line and its mirror image; returns how many gaps that share a body closed at once.
template <class Scalar>
std::int64_t compared_with_mirror(const Line<Scalar>& line) {
  const auto negated = [](const Scalar& x) { return Scalar(0) - x; };
  Engine<Scalar> engine(line);
  Engine<Scalar> mirror(mirrored(line, negated));
  auto events = run(engine, 20);
  auto images = run(mirror, 20);
  CHECK(engine.ties().near == mirror.ties().near);
  REQUIRE(events.size() == images.size());
  const std::size_t bodies = line.masses.size();
  for (std::size_t i = 0; i < bodies; ++i)
    CHECK(engine.bodies()[i].velocity == negated(mirror.bodies()[bodies - 1 - i].velocity));
  for (auto& image : images) image.gap = bodies - image.gap;
  const auto place = [](const auto& event) { return std::pair(event.time, event.gap); };
  std::ranges::stable_sort(events, {}, place);
  std::ranges::stable_sort(images, {}, place);
  std::int64_t at_once = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool has_next = i + 1 < events.size() && events[i].time == events[i + 1].time;
    at_once += has_next && events[i].gap + 1 == events[i + 1].gap ? 1 : 0;
    CHECK((events[i].gap == images[i].gap && events[i].time == images[i].time));
    CHECK(events[i].position == negated(images[i].position));
    CHECK(events[i].v_left == negated(images[i].v_right));
    CHECK(events[i].v_right == negated(images[i].v_left));
  }
  return at_once;
}

}  // namespace

TEST_CASE("momentum is kept, and energy goes as the restitution says", "[check]") {
  std::size_t all = 0, spoiled = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    INFO(seed);
    const auto line = random_line<cl_RA>(seed, 2, seed % 2 == 0 ? cl_RA(1) : cl_RA(2) / 3);
    Engine<cl_RA> engine(line);
    auto events = run(engine, 30);
    all += events.size();
    CHECK(broken_law(line, events).empty());
    for (auto& event : events) (event.gap > 0 ? event.v_left : event.v_right) += 1;
    spoiled += broken_law(line, events).empty() ? 0 : 1;
    for (std::size_t i = 1; i < line.masses.size(); ++i)
      CHECK_FALSE(engine.position(i, engine.now()) < engine.position(i - 1, engine.now()));
  }
  CHECK((all > 2000 && spoiled > 250));
}

TEST_CASE("a mirror shows the mirrored motion, whatever happens at once", "[check]") {
  std::int64_t simultaneous = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    INFO(seed);
    const double e = seed % 4 == 0 ? 0.5 : 1;
    simultaneous += compared_with_mirror(random_line(seed, 1, e == 1 ? cl_RA(1) : cl_RA(1) / 2));
    compared_with_mirror(random_line(seed, seed % 2 == 0 ? 1 : 97, e));
  }
  CHECK(simultaneous > 60);
}

TEST_CASE("100,000 equal masses hand the velocity on in order", "[exam]") {
  constexpr std::size_t bodies = 100'000;
  Line<double> line;
  line.masses.assign(bodies, 1);
  line.velocities.assign(bodies, 0);
  line.velocities[0] = 1;
  for (std::size_t i = 0; i < bodies; ++i) line.positions.push_back(static_cast<double>(i));
  Engine<double> engine(line);
  for (std::size_t gap = 1; gap < bodies; ++gap) {
    const auto event = engine.step();
    if (event.gap != gap || event.time != static_cast<double>(gap)) FAIL(gap);
  }
  CHECK_FALSE((engine.next() || engine.ties().near != 0 || engine.has_lost()));
  CHECK(engine.bodies().back().velocity == 1);
  Engine<double> slow(Line<double>{{1, 1}, {0, 1e300}, {5e-324, 0}, {}, {}});
  CHECK((!slow.next() && slow.has_lost()));
}

TEST_CASE("near ties are told at thresholds and not away from them", "[exam]") {
  const double magic_2 = 0.2360679774997897;  // sqrt(5) - 2, where one collision too many is seen
  for (const auto& [alpha, expected, near] : {std::tuple{1.0, 2, 0},
                                              {0.1, 7, 0},
                                              {0.24, 4, 0},
                                              {magic_2, 5, 2},
                                              {magic_2 + 2e-15, 4, 1},
                                              {magic_2 + 4e-15, 4, 0}}) {
    INFO(alpha);
    Engine<double> engine({{1, alpha, 1}, {0, 0, 1}, {1, 0, 0}, {}, {}});
    CHECK(run(engine, 9).size() == std::size_t(expected));
    CHECK((engine.ties().near == near && engine.errors().position < 1e-11));
  }
}

TEST_CASE("a line with a fault does not move", "[exam]") {
  using Limits = std::numeric_limits<double>;
  const auto with_mass = [](double mass) {
    return Line<double>{{1, mass}, {0, 1}, {1, 0}, {}, {}};
  };
  for (const double mass : {Limits::max(), Limits::denorm_min()})
    CHECK_NOTHROW(Engine<double>(with_mass(mass)));
  for (const double mass : {Limits::quiet_NaN(), Limits::infinity()})
    CHECK_THROWS_WITH(Engine<double>(with_mass(mass)),
                      "masses: that of body 2 is not finite; allowed: finite numbers");
  CHECK_THROWS_WITH(Engine<double>({{1, 1}, {0, 1}, {}, {}, {}}),
                    ContainsSubstring("a list of 0; allowed: as many"));
  for (const double wall : {Limits::quiet_NaN(), 1.0}) {
    CHECK_THROWS_WITH(Engine<double>({{1}, {0}, {-1}, wall, {}}), ContainsSubstring("left_wall"));
    CHECK_THROWS_WITH(Engine<double>({{1}, {2}, {-1}, {}, wall}), ContainsSubstring("right_wall"));
  }
  CHECK_NOTHROW(Engine<double>({{1}, {1}, {-1}, 1, 1}));
  CHECK_THROWS_AS(Engine<cl_RA>({{1, 0}, {0, 1}, {1, 0}, {}, {}}), std::invalid_argument);
}
