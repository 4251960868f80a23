// Millions of rows of accurate arrays, half everyday, half from the hard families, fixed seed, then
// rational alpha up to cycle 64: by the oracle nothing is misrounded, and no count is wrong.
#include <map>

#include "src/magicmass/numbers/families.hpp"
#include "src/magicmass/numbers/tiers.hpp"

namespace {
using namespace magicmass;
using namespace magicmass::testing;

constexpr std::size_t block = 4096;

struct Tally {
  long rows = 0, misrounded = 0, wrong_counts = 0;
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
void check(const Row& row, const Velocities& v, const Terminal& t, Tally& tally) {
  ++tally.rows;
  const bool is_start = row.n == 0;
  if (v != (is_start ? Velocities{1, 0, 0, 0} : velocities_by_oracle(row.alpha, row.n))) {
    ++tally.misrounded;
    complain(row, "velocities");
  }
  const bool is_countable = row.alpha > 1e-39;  // the oracle takes long below
  const std::optional<Counts> counts = is_countable ? counts_by_oracle(row.alpha) : std::nullopt;
  const Terminal exact_t = counts ? terminal_by_oracle(row.alpha, *counts) : Terminal{{-1, -1}};
  if (t.counts != exact_t.counts) {
    ++tally.wrong_counts;
    complain(row, "counts");
  } else if (t.counts.N_A >= 0 && t != exact_t) {
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
        check({&family, alpha, n}, accurate::velocities(alpha, n), t, tally);
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
      check(rows[i], table.velocities(i), table.terminal(i), tallies[rows[i].family->name]);
  }
  Tally all;
  for (const auto& [name, t] : tallies) {
    std::printf("%-30s %9ld rows, %ld misrounded, %ld wrong counts\n", name.c_str(), t.rows,
                t.misrounded, t.wrong_counts);
    all.rows += t.rows;
    all.misrounded += t.misrounded;
    all.wrong_counts += t.wrong_counts;
  }
  std::printf("%ld rows, %ld misrounded, %ld wrong counts\n", all.rows, all.misrounded,
              all.wrong_counts);
  return all.misrounded == 0 && all.wrong_counts == 0 ? 0 : 1;
}
