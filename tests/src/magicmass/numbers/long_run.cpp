// Millions of rows of accurate arrays, half everyday, half from the hard families, fixed seed:
// nothing misrounded, no wrong count. Rows go to certified formulas on CLN's floats, and to the
// oracle where these are not certain, for alpha > 2^10, and for one row in a thousand anyhow. Then
// rational alpha up to cycle 64, all by the oracle.
// The formulas are the paper's sums of sines and cosines, typed in, with a bound of their error.
// The product's evaluators are products of other angles. nullopt: not certain, ask the oracle.
#include <map>

#include <cln/real.h>

#include "src/magicmass/numbers/families.hpp"
#include "src/magicmass/numbers/tiers.hpp"

namespace {
using namespace magicmass;
using namespace magicmass::testing;

/// h = psi/2 and what the four velocities share.
class Formulas {
public:
  using Real = cln::cl_R;
  /// Results are as small as alpha^(3/2) against terms as large as alpha^(-1/2).
  explicit Formulas(double x)
      : precision(160 - 2 * std::min(0, std::ilogb(x))),
        alpha(cln::cl_float(oracle::exact(x), format())),
        h(cln::atan(cln::sqrt(alpha * (alpha + 2)))),
        V(1 / (alpha + 2)),
        per_half(1 / cln::sin(h / 2)),
        // Angles up to 4 pi, each within some units of 2^-precision; 1 + alpha <= 2^11.
        error(cln::scale_float(cln::cl_float(per_half + 4096), 8 - precision)) {}
  cln::float_format_t format() const { return cln::float_format_t(precision); }
  Real a(const Real& n) const { return V * (1 + (alpha + 1) * cln::cos(2 * n * h)); }
  Real b(const Real& n) const { return V * (1 - (alpha + 1) * cln::cos((2 * n + 1) * h)); }
  Real c(const Real& n) const { return V * (1 + per_half * cln::sin((2 * n - half) * h)); }
  Real c_prime(const Real& n) const { return V * (1 - per_half * cln::sin((2 * n + half) * h)); }
  /// x rounded; `is_certain` is cleared where the error might change it.
  double rounded(const Real& x, const Real& off) {
    const double low = oracle::nearest(cln::rational(x - off));
    is_certain = is_certain && low == oracle::nearest(cln::rational(x + off));
    return low;
  }
  double rounded(const Real& x) { return rounded(x, error); }

  int precision;  // first: the others are made with it
  Real half = cln::cl_RA(1) / 2;
  Real alpha, h, V, per_half, error;
  bool is_certain = true;
};

/// alpha <= 2^10, 1 <= n <= N_A.
std::optional<Velocities> velocities_by_formulas(double alpha, std::int64_t n) {
  Formulas f(alpha);
  const Velocities v{f.rounded(f.a(n)), f.rounded(f.b(n)), f.rounded(f.c(n)),
                     f.rounded(f.c_prime(n))};
  return f.is_certain ? std::optional(v) : std::nullopt;
}
/// alpha <= 2^10, N_A + N_B < 2^63.
std::optional<Terminal> terminal_by_formulas(double alpha) {
  Formulas f(alpha);
  const Formulas::Real last = cln::pi(f.format()) / f.h;  // N = ceil(pi/h) - 1
  const Formulas::Real off = cln::scale_float(cln::cl_float(last), 4 - f.precision);
  const cln::cl_I most = cln::ceiling1(last - off) - 1;
  if (cln::ceiling1(last + off) - 1 != most) return std::nullopt;
  const std::int64_t N = cln::cl_I_to_long(most);
  const Counts counts{N / 2 + N % 2, N / 2};
  const Formulas::Real b = f.b(counts.N_B);
  const Terminal t{counts, f.rounded(f.a(counts.N_A)), f.rounded(b),
                   f.rounded(N % 2 == 1 ? f.c(counts.N_A) : f.c_prime(counts.N_B)),
                   f.rounded(b * b, f.error * 3)};
  return f.is_certain ? std::optional(t) : std::nullopt;
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
