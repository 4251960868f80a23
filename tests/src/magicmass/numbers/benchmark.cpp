// What results cost beside one naive call that shares its trigonometry: least time of five runs,
// and the least and largest ratio of the runs, in each of which both are timed side by side.
#include <chrono>

#include "report/naive.hpp"
#include "src/magicmass/numbers/families.hpp"
#include "src/magicmass/numbers/tiers.hpp"

namespace {
using namespace magicmass;

// No multiple of 512: else all columns would fall on the same places of the cache.
constexpr std::size_t rows = 3840;
constexpr int passes = 200;

/// The paper's formulas typed in, V = 1: the baseline, wrong near thresholds; shares trigonometry.
[[gnu::noinline]] Velocities naive_velocities(double alpha, std::int64_t n) {
  const double psi = 2 * std::atan(std::sqrt(alpha * (2 + alpha)));
  const double V = 1 / (2 + alpha);
  const double r = std::sqrt(2 * (1 + alpha) / alpha);
  const auto k = double(n);
  return {V * (1 + (1 + alpha) * std::cos(k * psi)),
          V * (1 - (1 + alpha) * std::cos((k + 0.5) * psi)),
          V * (1 + r * std::sin((k - 0.25) * psi)), V * (1 - r * std::sin((k + 0.25) * psi))};
}
[[gnu::noinline]] Terminal naive_terminal(double alpha) { return report::naive::terminal(alpha); }

struct Data : testing::Table {
  double sum = 0;  // keeps results alive

  Data(double low, double high) : Table(rows) {
    testing::Random random(1);
    for (std::size_t i = 0; i < rows; ++i) {
      alpha[i] = testing::log_uniform(random, low, high);
      n[i] = std::int64_t(testing::uniform(random) * (double(count_collisions(alpha[i])->N_A) + 1));
    }
  }
};
/// One pass of single velocities, or of terminal ones.
template <class F>
auto singly(Data& d, F of) {
  return [&d, of] {
    for (std::size_t i = 0; i < rows; ++i)
      if constexpr (requires { of(0.5, std::int64_t{1}); }) {
        const Velocities v = of(d.alpha[i], d.n[i]);
        d.sum += v.a + v.b + v.c + v.c_prime;
      } else {
        const std::optional<Terminal> t = of(d.alpha[i]);
        d.sum += t->a_t + t->b_t + t->c_t + double(t->counts.N_A + t->counts.N_B);
      }
  };
}
template <class F>
double nanoseconds(F pass) {
  const auto start = std::chrono::steady_clock::now();
  pass();
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  return time.count() / double(rows);
}
/// `speed` is printed where more is better, else the share of naive's time.
template <class Naive, class Ours>
void compare(const std::string& name, Naive naive, Ours ours, bool is_speed) {
  double least[2] = {1e30, 1e30};
  double ratio[2] = {1e30, 0};
  for (int run = 0; run < 5; ++run) {
    double of_run[2] = {1e30, 1e30};
    for (int pass = 0; pass < passes; ++pass) {
      of_run[0] = std::min(of_run[0], nanoseconds(naive));
      of_run[1] = std::min(of_run[1], nanoseconds(ours));
    }
    for (int k : {0, 1}) least[k] = std::min(least[k], of_run[k]);
    const double r = is_speed ? of_run[0] / of_run[1] : of_run[1] / of_run[0];
    ratio[0] = std::min(ratio[0], r);
    ratio[1] = std::max(ratio[1], r);
  }
  const double r = is_speed ? least[0] / least[1] : least[1] / least[0];
  std::printf("%-34s %6.1f ns, naive %5.1f ns: %s %.2f (%.2f to %.2f)\n", name.c_str(), least[1],
              least[0], is_speed ? "times faster" : "of its time", r, ratio[0], ratio[1]);
}
void everyday(const numbers::Kernels& table) {
  Data d(1e-4, 1);
  const auto v = singly(d, naive_velocities);
  const auto t = singly(d, naive_terminal);
  std::printf("alpha log-uniform in 1e-4..1, %s\n", table.name);
  numbers::Open open;
  for (const int tier : {0, 1}) {
    const std::string of_tier = "rows of " + testing::tiers[tier].name;
    const auto each_block = [](const auto& run) {
      return [run] {
        for (std::size_t i = 0; i < rows; i += numbers::longest_block) run(i);
      };
    };
    compare(of_tier + " velocities", v, each_block([&, tier](std::size_t i) {
              table.velocity_rows[tier](numbers::longest_block, d.velocities_from(i), open);
            }),
            true);
    compare(of_tier + " terminal", t, each_block([&, tier](std::size_t i) {
              table.terminal_rows[tier](numbers::longest_block, d.terminal_from(i), open);
            }),
            true);
  }
}
void public_calls() {
  Data d(1e-4, 1);
  const auto v = singly(d, naive_velocities);
  const auto t = singly(d, naive_terminal);
  std::printf("alpha log-uniform in 1e-4..1, public calls, %s\n", numbers::kernels().name);
  compare("naive itself", v, v, false);
  for (const testing::Calls& tier : testing::tiers) {
    compare(tier.name + " velocities", v, singly(d, tier.velocities), false);
    compare(tier.name + " terminal", t, singly(d, tier.terminal), false);
  }
  for (const testing::Calls& tier : testing::tiers) {
    const auto of_v = [&] { tier.velocity_rows(d.alpha, d.n, d.velocities()); };
    const auto of_t = [&] { tier.terminal_rows(d.alpha, d.terminal()); };
    compare("arrays of " + tier.name + " velocities", v, of_v, true);
    compare("arrays of " + tier.name + " terminal", t, of_t, true);
  }
  if (d.sum == 1) std::puts("");
}
/// Time of arrays of terminal velocities where counts are large, and rows that Accurate leaves.
void far_ranges() {
  const double ends[] = {1, 1e-4, 1e-12, 1e-20, 1e-25, 1e-30, 5.9e-38};
  for (int k = 0; k < 6; ++k) {
    Data d(ends[k + 1], ends[k]);
    double least = 1e30, of_velocities = 1e30;
    for (int run = 0; run < 3; ++run) {
      least = std::min(least, nanoseconds([&] { accurate::terminal(d.alpha, d.terminal()); }));
      of_velocities = std::min(
          of_velocities, nanoseconds([&] { accurate::velocities(d.alpha, d.n, d.velocities()); }));
    }
    int open[2] = {0, 0};
    for (std::size_t i = 0; i < rows; ++i) {
      Velocities v;
      Terminal t;
      open[0] += !numbers::kernels().velocities[numbers::accurate](v, d.alpha[i], d.n[i]);
      open[1] += !numbers::kernels().terminal[numbers::accurate](t, d.alpha[i]);
    }
    std::printf(
        "alpha in %g..%g: arrays of accurate velocities %.1f ns a row, terminal %.1f ns; "
        "rows that need more %.2e, %.2e\n",
        ends[k + 1], ends[k], of_velocities, least, open[0] / double(rows), open[1] / double(rows));
  }
}
}  // namespace

int main() {
  public_calls();
  const auto all = testing::all_kernels();
  for (std::size_t i = all.size(); i-- > 0;) everyday(*all[i]);
  far_ranges();
}
