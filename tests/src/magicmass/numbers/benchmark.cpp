// SPDX-License-Identifier: GPL-2.0-or-later
// What a row costs beside one naive call, for each instruction set by itself and where counts are
// large. The report has the public calls at everyday mass ratios.
#include <cstdio>

#include "magicmass/numbers/kernels.hpp"
#include "report/naive.hpp"
#include "report/timing.hpp"
#include "src/magicmass/numbers/families.hpp"

namespace {
using namespace magicmass;

// No multiple of 512: else all columns would fall on the same places of the cache.
constexpr std::size_t rows = 3840;

struct Data : testing::Table {
  std::vector<double> alpha = std::vector<double>(rows);
  std::vector<std::int64_t> n = std::vector<std::int64_t>(rows);
  double sum = 0;  // keeps results alive

  Data(double low, double high) : Table(rows) {
    testing::Random random(1);
    for (std::size_t i = 0; i < rows; ++i) {
      alpha[i] = testing::log_uniform(random, low, high);
      n[i] = std::int64_t(testing::uniform(random) * (double(count_collisions(alpha[i])->N_A) + 1));
    }
  }
  void naive_velocities() {
    for (std::size_t i = 0; i < rows; ++i) {
      const Velocities v = report::naive::velocities(alpha[i], n[i]);
      sum += v.a + v.b + v.c + v.c_prime;
    }
  }
  void naive_terminal() {
    for (std::size_t i = 0; i < rows; ++i) {
      const Terminal t = report::naive::terminal(alpha[i]);
      sum += t.a_t + t.b_t + t.c_t + double(t.counts.N_A + t.counts.N_B);
    }
  }
};
/// Both of ours, which do all rows.
void compare(const char* name, Data& d, const auto& velocities, const auto& terminal) {
  const auto times = report::timed({{[&] { d.naive_velocities(); }, velocities, rows},
                                    {[&] { d.naive_terminal(); }, terminal, rows}},
                                   {.count = 99});
  for (const int k : {0, 1}) {
    const report::Times& t = times[std::size_t(k)];
    std::printf("%-20s %-10s %6.1f ns, times faster than naive: %.2f (%.2f to %.2f)\n", name,
                k == 0 ? "velocities" : "terminal", t.ns, 1 / t.ratio, 1 / t.ratio_high,
                1 / t.ratio_low);
  }
}
void everyday(const numbers::Kernels& table) {
  Data d(1e-4, 1);
  numbers::Open open;
  auto& o = d.values;
  constexpr std::size_t block = numbers::longest_block;
  for (const int tier : {0, 1}) {
    const auto velocities = [&] {
      for (std::size_t i = 0; i < rows; i += block)
        table.velocity_rows[tier](
            block, {&d.alpha[i], &d.n[i], &o[0][i], &o[1][i], &o[2][i], &o[3][i]}, open);
    };
    const auto terminal = [&] {
      for (std::size_t i = 0; i < rows; i += block)
        table.terminal_rows[tier](
            block,
            {&d.alpha[i], &d.counts[0][i], &d.counts[1][i], &o[4][i], &o[5][i], &o[6][i], &o[7][i]},
            open);
    };
    const std::string name = std::string(table.name) + (tier == 0 ? ", fast" : ", accurate");
    compare(name.c_str(), d, velocities, terminal);
  }
}
/// Arrays of accurate, and the rows that its kernels leave.
void far_range(double low, double high) {
  Data d(low, high);
  std::printf("alpha in %g..%g:\n", low, high);
  compare(
      "arrays of accurate", d, [&] { accurate::velocities(d.alpha, d.n, d.velocities()); },
      [&] { accurate::terminal(d.alpha, d.terminal()); });
  int open[2] = {0, 0};
  for (std::size_t i = 0; i < rows; ++i) {
    Velocities v;
    Terminal t;
    open[0] += !numbers::kernels().velocities[numbers::accurate](v, d.alpha[i], d.n[i]);
    open[1] += !numbers::kernels().terminal[numbers::accurate](t, d.alpha[i]);
  }
  std::printf("rows that need more %.2e, %.2e\n", open[0] / double(rows), open[1] / double(rows));
}
}  // namespace

int main() {
  for (const char* name : {"avx512", "avx2", "baseline"}) {
    if (const numbers::Kernels* table = numbers::kernels_named(name)) everyday(*table);
  }
  const double ends[] = {1, 1e-4, 1e-12, 1e-20, 1e-25, 1e-30, 5.9e-38};
  for (int k = 0; k < 6; ++k) far_range(ends[k + 1], ends[k]);
}
