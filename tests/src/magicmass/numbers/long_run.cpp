// Millions of rows of accurate arrays, half everyday, half from the hard families, fixed seed:
// nothing misrounded, no wrong count. Rows go to certified formulas in balls, and to the
// oracle where these are not certain, for alpha > 2^10, and for one row in a thousand anyhow. Then
// rational alpha up to cycle 64, all by the oracle.
// The formulas are the paper's sums of sines and cosines, typed in.
// The product's evaluators are products of other angles. nullopt: not certain, ask the oracle.
#include <map>

#include "balls/ball.hpp"
#include "src/magicmass/numbers/families.hpp"
#include "src/magicmass/numbers/tiers.hpp"

namespace {
using namespace magicmass;
using namespace magicmass::testing;
using balls::Ball;

/// Results are as small as alpha^(3/2) against terms as large as alpha^(-1/2).
double with_bits_for(double alpha) {
  Ball::bits = 160 - 2 * std::min(0, std::ilogb(alpha));
  return alpha;
}
/// h = psi/2 and what the four velocities share.
struct Formulas {
  explicit Formulas(double x) : alpha(with_bits_for(x)) {}
  Ball a(std::int64_t n) const { return V * (1 + (alpha + 1) * cos(2 * n * h)); }
  Ball b(std::int64_t n) const { return V * (1 - (alpha + 1) * cos((2 * n + 1) * h)); }
  Ball c(std::int64_t n) const { return V * (1 + per_half * sin((2 * n - half) * h)); }
  Ball c_prime(std::int64_t n) const { return V * (1 - per_half * sin((2 * n + half) * h)); }
  Ball alpha, half = cln::cl_RA(1) / 2, h = atan(sqrt(alpha * (alpha + 2)));
  Ball V = 1 / (alpha + 2), per_half = 1 / sin(h / 2);
};
double rounded(const Ball& x) {
  const auto value = balls::nearest_double(x.low(), x.high());
  return value ? *value : throw balls::NotCertain("between two doubles");
}

/// alpha <= 2^10, 1 <= n <= N_A.
std::optional<Velocities> velocities_by_formulas(double alpha, std::int64_t n) try {
  const Formulas f(alpha);
  return Velocities{rounded(f.a(n)), rounded(f.b(n)), rounded(f.c(n)), rounded(f.c_prime(n))};
} catch (const balls::NotCertain&) {
  return std::nullopt;
}
/// alpha <= 2^10, N_A + N_B < 2^63.
std::optional<Terminal> terminal_by_formulas(double alpha) try {
  const Formulas f(alpha);
  const std::int64_t N = cln::cl_I_to_long(cln::numerator(ceil(Ball::pi() / f.h).low())) - 1;
  const Counts counts{N / 2 + N % 2, N / 2};
  const Ball b = f.b(counts.N_B), c = N % 2 == 1 ? f.c(counts.N_A) : f.c_prime(counts.N_B);
  return Terminal{counts, rounded(f.a(counts.N_A)), rounded(b), rounded(c), rounded(b * b)};
} catch (const balls::NotCertain&) {
  return std::nullopt;
}

constexpr double formulas_up_to = 0x1p10;
constexpr double countable_from = 5.9e-38;
constexpr std::size_t block = 4096;

struct Tally {
  long rows = 0, by_oracle = 0, misrounded = 0, wrong_counts = 0;
};
struct Row {
  const Family* family;
  double alpha;
  std::int64_t n;
};
void complain(const Row& row, const char* what) {
  std::printf("%s: %s at alpha = %s, n = %lld\n", row.family->name.c_str(), what,
              in_hex(row.alpha).c_str(), static_cast<long long>(row.n));
}
void check(const Row& row, const Velocities& v, const Terminal& t, bool is_sample, Tally& tally) {
  ++tally.rows;
  const bool has_formulas = row.alpha <= formulas_up_to;
  std::optional<Velocities> exact_v;
  if (row.n == 0) exact_v = Velocities{1, 0, 0, 0};
  if (!exact_v && has_formulas && !is_sample) exact_v = velocities_by_formulas(row.alpha, row.n);
  if (!exact_v) {
    ++tally.by_oracle;
    exact_v = velocities_by_oracle(row.alpha, row.n);
  }
  if (v != *exact_v) {
    ++tally.misrounded;
    complain(row, "velocities");
  }
  if (row.alpha < 1e-39) {
    if (t.counts != Counts{-1, -1}) ++tally.wrong_counts;
    return;
  }
  std::optional<Terminal> exact_t;
  if (has_formulas && row.alpha > countable_from && !is_sample)
    exact_t = terminal_by_formulas(row.alpha);
  if (!exact_t) {
    const std::optional<Counts> counts = counts_by_oracle(row.alpha);
    exact_t = counts ? terminal_by_oracle(row.alpha, *counts) : Terminal{{-1, -1}};
  }
  if (t.counts != exact_t->counts) {
    ++tally.wrong_counts;
    complain(row, "counts");
  } else if (t.counts.N_A >= 0 && t != *exact_t) {
    ++tally.misrounded;
    complain(row, "terminal velocities");
  }
}
/// Rational alpha up to cycle 64: all p/2^k, p and 2^k up to 4096.
Tally all_rationals() {
  const Family family{"rationals", nullptr};
  Tally tally;
  for (int k = 0; k <= 12; ++k)
    for (int p = 1; p <= 4096; p += k == 0 ? 1 : 2) {
      const double alpha = std::ldexp(double(p), -k);
      const Terminal t = *accurate::terminal(alpha);
      for (std::int64_t n = 0; n <= std::min(t.counts.N_A, std::int64_t{64}); ++n)
        check({&family, alpha, n}, accurate::velocities(alpha, n), t, true, tally);
    }
  return tally;
}
}  // namespace

int main(int count, char** arguments) {
  const long wanted = count > 1 ? std::atol(arguments[1]) : 5'000'000;
  Random random(20261125);
  std::map<std::string, Tally> tallies{{"rationals", all_rationals()}};
  std::vector<Row> rows(block);
  Table table(block);
  for (long done = 0; done < wanted; done += block) {
    for (std::size_t i = 0; i < block; ++i) {
      const bool is_everyday = random() % 2 == 0;
      const Family& family = families[is_everyday ? 0 : 1 + random() % (families.size() - 1)];
      table.alpha[i] = family.alpha(random);
      table.n[i] = some_cycle(random, table.alpha[i]);
      rows[i] = {&family, table.alpha[i], table.n[i]};
    }
    table.fill(tiers[numbers::accurate]);
    for (std::size_t i = 0; i < block; ++i)
      check(rows[i], table.velocities(i), table.terminal(i), random() % 1000 == 0,
            tallies[rows[i].family->name]);
  }
  Tally all;
  for (const auto& [name, t] : tallies) {
    std::printf("%-30s %9ld rows, %7ld by the oracle, %ld misrounded, %ld wrong counts\n",
                name.c_str(), t.rows, t.by_oracle, t.misrounded, t.wrong_counts);
    all.rows += t.rows;
    all.misrounded += t.misrounded;
    all.wrong_counts += t.wrong_counts;
  }
  std::printf("%ld rows, %ld misrounded, %ld wrong counts\n", all.rows, all.misrounded,
              all.wrong_counts);
  return all.misrounded == 0 && all.wrong_counts == 0 ? 0 : 1;
}
