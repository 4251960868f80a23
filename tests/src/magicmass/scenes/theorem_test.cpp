// What theorems say of a scene, against its motion collision by collision in rationals, by the laws
// of one collision alone; and against the motion in a mirror.
#include <cstdlib>
#include <random>

#include "law_of_collision.hpp"
#include "magicmass/scenes/trio.hpp"
#include "rows.hpp"
#include "runs.hpp"

using namespace magicmass::scenes;
using cln::cl_RA;

namespace {
using Line = law::ThreeBodies<cl_RA>;
using Step = magicmass::simulator::Collision<cl_RA>;
/// The first collisions, at most so many; the line is then as after them.
std::vector<Step> stepped(Line& line, int most) {
  std::vector<Step> rows;
  const auto& [A, B, C] = line.v;
  while (line.N < most && line.approach() > 0) {
    line.wait();
    const bool is_left = line.A_next();
    line.collide();
    rows.push_back({line.N, is_left ? std::size_t(1) : 2, line.time, line.place[2], is_left ? A : C,
                    is_left ? C : B});
  }
  return rows;
}
std::string text_of(const Line& line) {
  const bool has_wall = line.per_B == 0;
  const auto of = [&](const cl_RA& A, const cl_RA& C, const cl_RA& B) {
    return has_wall ? list({quoted(A), quoted(C)}) : list({quoted(A), quoted(C), quoted(B)});
  };
  const auto& [A, B, C] = line.place;
  return (has_wall ? "kind = 'wall'\nright_wall = " + quoted(B) : "kind = 'three-body'") +
         "\nmasses = " + of(line.A_mass, line.ball, has_wall ? 0 : 1 / line.per_B) +
         "positions = " + of(A, C, B) + "velocities = " + of(line.v[0], line.v[2], line.v[1]) +
         "restitution = " + quoted(line.e) + "\n";
}
std::mt19937_64 draws(41);
cl_RA fraction(int from, int to, int below) {
  return cl_RA(from + int(draws() % std::uint64_t(to - from + 1))) / below;
}
/// With another ball or block, kappa is 1, or next to it; with another B, it runs away so fast that
/// after some collision the ball and what it would meet next move on side by side.
void at_border(Line& line, bool is_exact) {
  const cl_RA K = (1 + line.e) * (1 + line.e) / (4 * line.e), near = cl_RA(1) / 1'000'000'007;
  const cl_RA share = line.per_B == 0 ? cl_RA(1) : fraction(1, 5, 6);
  line.ball = line.A_mass * (K - 1) * share;
  if (line.per_B != 0) line.per_B = (K / (1 + line.ball / line.A_mass) - 1) / line.ball;
  if (!is_exact) line.ball = line.ball * (1 + fraction(-3, 3, 1) * near);
  const cl_RA V = line.v[0] - line.v[2], n = fraction(1, 99, 1);
  const cl_RA per_V = (n + 1) / n * (1 + line.e) * line.A_mass / 2 / (line.A_mass + line.ball);
  if (line.per_B != 0 && draws() % 2 == 0) line.v[1] = line.v[2] + V * per_V;
}
/// Faster between A and the ball.
void meet_at_once(Line& line) {
  const cl_RA V = line.v[0] - line.v[2], W = V * fraction(1, 7, 8), t = fraction(0, 3, 3);
  line.v = {V + W, 0, W};
  line.place = {0, (V + W) * t, V * t};
}
Line random_line() {
  const bool has_wall = draws() % 3 == 0;
  const cl_RA e = draws() % 2 == 0 ? cl_RA(1) : fraction(1, 40, 40);
  const cl_RA drift = has_wall ? cl_RA(0) : fraction(-6, 6, 4);
  const cl_RA start = fraction(-8, 8, 4), free = fraction(0, 4, 3), L = fraction(0, 9, 7);
  const cl_RA V = fraction(1, 12, 4);
  // From V d_B / d_A on the ball meets B first, or all three meet at once.
  const cl_RA most = L * (free == 0 ? cl_RA(3) : V / free);
  const cl_RA W = draws() % 2 == 0 ? cl_RA(0) : fraction(-20, 9, 10) * most;
  const cl_RA per_B = has_wall ? cl_RA(0) : 1 / fraction(1, 40, 6);
  const cl_RA A = fraction(1, 40, 6), ball = fraction(1, 24, draws() % 4 == 0 ? 400 : 12);
  const cl_RA ball_place = start + free;
  Line line{
      A, per_B, ball, e, {drift + W + V, drift, drift + W}, {start, ball_place + L, ball_place}};
  if (e < 1 && draws() % 4 == 0) at_border(line, draws() % 3 != 0);
  if (draws() % 8 == 0) meet_at_once(line);
  return line;
}
bool holds(const Ball& ball, const cl_RA& x) {
  const cl_RA width = ball.high() - ball.low(), most = cln::expt(cl_RA(2), -100);
  return ball.low() <= x && x <= ball.high() && width < most * (1 + cln::abs(x));
}
/// What the theorem says of the first collisions, and of the velocities after all of them.
void compare(const Trios& trio, const std::vector<Step>& rows, const Line& after) {
  Ball::bits = 320;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    INFO(j);
    const Trio::Collision c = trio.collision(std::int64_t(j));
    REQUIRE(c.gap == rows[j].gap);
    REQUIRE((holds(c.time, rows[j].time) && holds(c.position, rows[j].position)));
    REQUIRE((holds(c.v_left, rows[j].v_left) && holds(c.v_right, rows[j].v_right)));
  }
  const std::vector<Ball> v = trio.velocities(std::int64_t(rows.size()));
  for (std::size_t k = 0; k < v.size(); ++k) REQUIRE(holds(v[k], after.v[(2 * k) % 3]));  // A, C, B
}
/// A collapse lies between what its first collisions leave open. A becomes slower with each one, B
/// faster. Each wait is a part of the one before that soon hardly changes, so that those that are
/// left are about `rest`. How far the limits are apart.
cl_RA compare_end(const Trios& trio, const std::vector<Step>& rows, Line line) {
  const auto time = [&](std::size_t before_last) {
    return rows.at(rows.size() - before_last).time;
  };
  const cl_RA wait = time(1) - time(2), part = wait == 0 ? cl_RA(0) : wait / (time(2) - time(3));
  const cl_RA rest = wait * part / (1 - part);
  Ball::bits = 1024;
  const Trio::Collision end = trio.collapse();
  const auto between = [](const cl_RA& low, const Ball& x, const cl_RA& high) {
    REQUIRE((low <= x.high() && x.low() <= high));
    return high - low;
  };
  const auto& [A, B, C] = line.v;
  const cl_RA of_time = between(line.time, end.time, line.time + 3 * rest);
  const cl_RA of_place = between(line.place[0] + std::min(cl_RA(0), 3 * B * rest), end.position,
                                 line.place[1] + std::max(cl_RA(0), 3 * A * rest));
  const cl_RA of_velocity = between(B, end.v_left, A);
  const cl_RA M_A = line.per_B * line.A_mass, M_C = line.per_B * line.ball;
  REQUIRE(holds(end.v_left, (M_A * A + B + M_C * C) / (M_A + 1 + M_C)));
  return std::max({of_time, of_place, of_velocity});
}
/// Of a collapse the first three collisions are told, and then those whose times differ.
void check_told(const std::vector<Numbers>& told, const std::vector<Step>& rows) {
  REQUIRE(told.size() >= 3);
  for (std::size_t j = 0; j < std::min(told.size(), rows.size()); ++j)
    REQUIRE((told[j] == numbers(rows[j]) && (j < 3 || told[j - 1][1] < told[j][1])));
  if (told.size() < rows.size()) REQUIRE(number(rows[told.size()].time) == told.back()[1]);
}
/// A collision at the time `until` belongs to the run.
void check_until(Scene scene, const std::vector<Step>& rows) {
  const cl_RA last = rows.at(draws() % rows.size()).time;
  if (rows.front().time == rows.back().time) return;
  scene.until = Value{"", Surd(last)};
  const Result result = run(scene);
  REQUIRE(result.plan.model == "theorem");
  const auto is_by = [&](const Step& row) { return row.time <= last; };
  REQUIRE(result.events == std::ranges::count_if(rows, is_by));
  check_mirrored(result, run(mirrored(scene)));
}
struct Seen {
  int few = 0, many = 0, collapsed = 0, narrow = 0, fled = 0;
};
/// All that theorems say of it.
void check(Line line, bool is_long, Seen& seen) {
  const std::string text = text_of(line);
  INFO(text);
  const Scene scene = scene_of(text);
  const Result result = run(scene);
  check_mirrored(result, run(mirrored(scene)));
  REQUIRE(result.plan.model == "theorem");
  const bool is_collapse = result.status == Status::collapse;
  const std::size_t most = !is_collapse || is_long ? 120 : 30;
  if (!is_collapse && result.events > 110) return;
  const std::vector<Step> rows = stepped(line, int(most) + line.N);
  const Trios trio = *Trios::of(scene);
  compare(trio, rows, line);
  if (is_long && !rows.empty()) check_until(scene, rows);
  Scene limited = scene;
  limited.max_events = std::int64_t(most);
  std::size_t n = 0;
  stream(limited, {"events", true, ""}, [&](const Row& row) {
    const Step& step = rows.at(n++);
    const auto is = [](const Number& x, const cl_RA& y) { return std::get<Surd>(x) == y; };
    REQUIRE((row.gap == step.gap && is(row.time, step.time) && is(row.position, step.position)));
    REQUIRE((is(row.v_left, step.v_left) && is(row.v_right, step.v_right)));
  });
  REQUIRE(n == rows.size());
  if (is_collapse) {
    ++seen.collapsed;
    REQUIRE((!trio.count() && rows.size() == most));
    const bool is_narrow = compare_end(trio, rows, line) < cln::expt(cl_RA(2), -20);
    seen.narrow += is_narrow ? 1 : 0;
    if (is_narrow && is_long) check_told(numbers_of(scene), rows);
    return;
  }
  ++(result.plan.is_exact ? seen.few : seen.many);
  seen.fled += trio.alone()->shape().q_e <= 0 ? 1 : 0;
  REQUIRE(result.status == Status::complete);
  REQUIRE((result.events == std::int64_t(rows.size()) && trio.count() == result.events));
  for (std::size_t k = 0; k < result.terminal.size(); ++k)
    REQUIRE(number(result.terminal[k]) == number(line.v[(2 * k) % 3]));  // A, C, B
  if (result.plan.is_exact) return;
  const std::vector<Numbers> told = numbers_of(scene);
  for (std::size_t j = 0; j < rows.size(); ++j) REQUIRE(told.at(j) == numbers(rows[j]));
}
}  // namespace

TEST_CASE("Random scenes by theorem, collision by collision, and in a mirror", "[check]") {
  const int scenes = std::getenv("MAGICMASS_LONG") == nullptr ? 1'000 : 10'000;
  Seen seen;
  for (int i = 0; seen.few + seen.many + seen.collapsed < scenes; ++i)
    check(random_line(), i % 20 == 0, seen);
  CHECK((seen.few > scenes / 10 * 7 && seen.many > scenes / 200));
  CHECK((seen.collapsed > scenes / 10 && seen.narrow > scenes / 200 && seen.fled > scenes / 200));
}

TEST_CASE("A ball that hits the wall before it meets the block", "[check]") {
  int once = 0;
  Seen seen;
  for (int i = 0; i < 1000; ++i) {
    const cl_RA e = draws() % 2 == 0 ? cl_RA(1) : fraction(1, 40, 40);
    const cl_RA x = fraction(-8, 8, 4), wall = x + fraction(0, 6, 7), W = fraction(1, 12, 4);
    const cl_RA ball = fraction(1, 24, draws() % 4 == 0 ? 4000 : 12), d_A = fraction(1, 9, 4);
    const cl_RA V = fraction(-12, 8, 8) * (wall == x ? cl_RA(3) : W * d_A / (wall - x));
    Line line{fraction(1, 40, 6), 0, ball, e, {W + V, 0, W}, {x - d_A, wall, x}};
    line.N = 1;  // so B is next
    if (V * (wall - x) >= W * d_A) continue;
    const auto trio = Trios::of(scene_of(text_of(line)));
    if (!trio) {
      ++once;
      REQUIRE(stepped(line, 121).size() < 121);
      continue;
    }
    check(line, i % 10 == 0, seen);
    const cl_RA early = (wall - x) / W / 2;
    REQUIRE(holds(trio->places(ball_of(Surd(early)), 0)[1], x + early * W));
    REQUIRE(holds(trio->velocities(0)[0], line.v[0]));
  }
  CHECK((seen.few > 300 && seen.many > 10 && seen.collapsed > 100 && once > 10));
}

TEST_CASE("plans, their reasons, and how many collisions, as in a mirror", "[exam]") {
  for (const auto& row : rows_of("src/magicmass/scenes/plans.tsv", 4)) {
    std::string text = row[0];
    std::ranges::replace(text, ';', '\n');
    INFO(text);
    const Result result = result_of(text), image = run(mirrored(scene_of(text)));
    CHECK(image.counts == std::vector(result.counts.rbegin(), result.counts.rend()));
    CHECK(image.plan.reason == result.plan.reason);
    CHECK(result.plan.model == row[1]);
    CHECK(std::to_string(result.events) == row[2]);
    CHECK_FALSE(result.is_undecided);
    CHECK_THAT(result.plan.reason, Catch::Matchers::StartsWith(row[3]));
  }
}

TEST_CASE("V and L are units, whatever numbers they are", "[check]") {
  for (const std::string masses :
       {"alpha = 'magic:3'\n", "alpha = '1/7'\nrestitution = '7/8'\n", "alpha = '1/9999'\n",
        "alpha = 1\nrestitution = '7/100'\n", "alpha = '1/90'\nrestitution = 'magic:3'\n"})
    for (const auto& [V, L] :
         {std::pair{"'sqrt(3)'", "'sqrt(2)'"}, {"'magic:5'", "'deficient:3'"}}) {
      INFO(masses << V << L);
      const std::string keys = "V = " + std::string(V) + "\nL = " + L + "\n";
      const Scene scene = scene_of(masses + keys);
      const double v = scene.V.to_double(), l = scene.L.to_double();
      const Result result = run(scene), unit = result_of(masses);
      CHECK_FALSE(result.is_undecided);
      check_mirrored(result, run(mirrored(scene)));
      CHECK((result.status == unit.status && result.counts == unit.counts));
      for (std::size_t i = 0; i < 3; ++i)
        CHECK_THAT(number(result.terminal[i]), WithinRel(v * number(unit.terminal[i]), 1e-15));
      const std::vector<Numbers> rows = numbers_of(scene), of_unit = numbers_of(scene_of(masses));
      for (std::size_t i = 0; i < std::min(rows.size(), of_unit.size()); ++i) {
        CHECK_THAT(rows[i][1], WithinRel(l / v * of_unit[i][1], 1e-14));
        CHECK_THAT(rows[i][2], WithinRel(l * of_unit[i][2], 1e-14));
        CHECK_THAT(rows[i][4], WithinRel(v * of_unit[i][4], 1e-14));
      }
    }
}
