// Answers from theorems against the oracle and exact steps, which know the collision law alone.
// Minimal polynomials: roots by doubles beside them; no factor, since their degree is the field's.
#include "answers/motion.hpp"

#include <numeric>
#include <random>

#include "answers/commands.hpp"
#include "answers/derivation.hpp"
#include "catch.hpp"
#include "law_of_collision.hpp"
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/fast.hpp"
#include "magicmass/oracle/certain.hpp"

using namespace answers;
using cln::cl_RA;
namespace oracle = magicmass::oracle;

namespace {
oracle::MassRatio same(const notation::Alpha& alpha) {
  if (const auto* at = std::get_if<notation::Threshold>(&alpha))
    return at->is_magic ? oracle::magic(at->k) : oracle::deficient(at->k);
  return oracle::ratio(*fraction_of(alpha));
}
std::string shown(const cl_RA& exact) { return real_cell(cln::double_approx(exact)).text; }
/// A row of tier exact: counts or n, then numbers.
Row asked(Answer (*command)(const Request&), const std::string& alpha, const std::string& option,
          const std::string& value) {
  Request request;
  request.options = {{"alpha", alpha}, {option, value}, {"tier", "exact"}};
  return command(request).table.rows[0];
}
void check_fractions(const Row& row, std::size_t first, const std::vector<cl_RA>& expected) {
  for (std::size_t i = 0; i < 4; ++i) CHECK(row.at(first + i).text == kernel::digits(expected[i]));
}
cl_RA value(const Polynomial& p, double x) {
  cl_RA sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * balls::exact(x) + p[i];
  return sum;
}
bool changes_sign(const Polynomial& p, double x) {
  const cl_RA at = value(p, x);
  return value(p, std::nextafter(x, 0)) * at <= 0 || at * value(p, std::nextafter(x, 2)) <= 0;
}
}  // namespace

TEST_CASE("counts are the oracle's, at any size and beside thresholds") {
  for (const char* text :
       {"1", "2", "1e300", "0.5", "1/7", "0.12", "1e-9", "1e-60", "1e-300", "5e-324", "1/3",
        "0x1.1c7397cb68b7ep-18", "0x1.bc7fb47556f22p-29", "0x1.fffffffffffffp-1"}) {
    INFO(text);
    const notation::Alpha alpha = alpha_of(text);
    const LargeCounts counts = count_collisions(alpha);
    const oracle::Counts expected = oracle::count_collisions(*same(alpha).rational);
    CHECK((counts.N_A == expected.N_A && counts.N_B == expected.N_B));
  }
  CHECK_THROWS_AS(alpha_of("1e-19/3e7"), InvalidInput);
}

TEST_CASE("velocities are the doubles nearest to the oracle's") {
  const std::pair<const char*, int> rows[] = {
      {"1/7", 0},   {"1/7", 3},     {"0.12", 2},    {"1e-9", 30000},    {"5", 1},
      {"1", 1},     {"magic:3", 3}, {"magic:3", 2}, {"deficient:2", 3}, {"magic:1000", 700},
      {"1e-300", 5}};
  for (const auto& row : rows) {
    INFO(row.first << " " << row.second);
    const notation::Alpha alpha = alpha_of(row.first);
    const int n = row.second;
    const auto got = rounded([&] { return velocities(alpha, n); });
    const auto expected = oracle::certain(same(alpha), oracle::OfCycle(n), oracle::to_double());
    for (std::size_t i = 0; i < 4; ++i) CHECK(got[i].text == real_cell(expected[i]).text);
  }
}

TEST_CASE("what no digits can show is undecided, never a guess") {
  // a_2 = 0 at magic:2 by theorem; without it no precision tells 0.
  const notation::Alpha alpha = alpha_of("magic:2");
  CHECK(rounded([&] { return velocities(alpha, 2); }, 5)[0].text == "0");
  const auto close_to_0 = [&] { return Balls{velocities(alpha, 2)[1] - Ball(1)}; };
  CHECK_THROWS_AS(rounded(close_to_0, 5), Undecided);
}

TEST_CASE("tier exact is in fractions") {
  for (const auto& [alpha, e] : {std::pair{"1/7", "9/10"}, {"0.1", "0.75"}, {"3", "1/3"}}) {
    const cln::cl_RA mass = *fraction_of(alpha_of(alpha));
    auto steps = law::equal_blocks(mass, *fraction_of(alpha_of(e)));
    while (steps.approach() > 0) steps.collide();
    const auto& [a, b, c] = steps.v;
    const std::vector<cl_RA> values{a, b, c, b * b};
    check_fractions(asked(answers::terminal, alpha, "restitution", e), 4, values);
    const Trio trio = Trio::equal_blocks(value_of(mass), value_of(alpha_of(e)));
    const Row near = rounded([&] { return answers::terminal(trio, steps.N); });
    for (std::size_t i = 0; i < 4; ++i) CHECK(near[i].text == shown(values[i]));
  }
}
TEST_CASE("tier exact is the oracle's fractions") {
  for (const char* alpha : {"1/7", "0.1", "3", "1", "12/5001", "1/1000"}) {
    const cl_RA mass = *fraction_of(alpha_of(alpha));
    const oracle::Counts N = oracle::count_collisions(mass);
    const Row at_end = asked(answers::terminal, alpha, "restitution", "1");
    check_fractions(at_end, 4, oracle::AtEnd(N)(mass));
    for (const cln::cl_I& n : {cln::cl_I(0), cln::cl_I(1), N.N_B, N.N_A}) {
      CAPTURE(alpha, kernel::digits(n));
      const Row row = asked(answers::eval, alpha, "n", kernel::digits(n));
      check_fractions(row, 3, oracle::OfCycle(n)(mass));
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
    Trio::Start start{{value_of(1), value_of(ball)}, value_of(e)};
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
      CHECK_THAT(got[i], WithinRel(cln::double_approx(velocities[i].low()), 1e-13));
  }
  CHECK(ended > 150);
}
TEST_CASE("each ratio is a root of its polynomial, and no other one is") {
  for (int k = 1; k <= 200; ++k)
    for (const bool is_magic : {true, false}) {
      CAPTURE(k, is_magic);
      const Polynomial p = polynomial_of_ratio(k, is_magic);
      const magicmass::Ratios here = magicmass::accurate::ratios(k);
      const magicmass::Ratios next = magicmass::accurate::ratios(k + 1);
      CHECK(changes_sign(p, is_magic ? here.magic : here.deficient));
      CHECK_FALSE(changes_sign(p, is_magic ? here.deficient : here.magic));
      CHECK_FALSE(changes_sign(p, is_magic ? next.magic : next.deficient));
      std::size_t coprime = 0;
      for (int i = 1, m = 4 * k + (is_magic ? 2 : 4); i <= m; ++i) coprime += std::gcd(i, m) == 1;
      CHECK(2 * (p.size() - 1) == coprime);
    }
}
TEST_CASE("a proof that fails is counted, and said beside the counts") {
  const kernel::Theorems shown{kernel::assume(kernel::eq(1, 1))};
  const Answer answer = verified(shown, "no proof of a = b");
  CHECK(answer.check_failed);
  CHECK(answer.note == "verify: not proved: no proof of a = b");
  const Row& row = answer.table.rows.at(0);
  CHECK((row[0].text == "1" && row[1].text == "1" && row[2].text == "1"));
  CHECK_FALSE(verified(shown, "").check_failed);
}
