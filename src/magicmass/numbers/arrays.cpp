// SPDX-License-Identifier: MIT
// Arrays: by blocks through this processor's kernels; rows left open climb the ladder of singles.
#include <algorithm>
#include <initializer_list>
#include <limits>
#include <tuple>

#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/numbers/fast.hpp"
#include "magicmass/numbers/ladder.hpp"

namespace magicmass {
namespace numbers {
namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void check_size(const char* name, std::size_t rows, std::size_t size) {
  if (rows == size) return;
  throw InvalidInput(std::string(name) + " has " + std::to_string(rows) + " rows, alpha has " +
                     std::to_string(size));
}
struct Column {
  const char* name;
  std::size_t rows;
  std::uintptr_t begin, end;
  template <class T>
  Column(const char* of, std::span<T> c)
      : name(of),
        rows(c.size()),
        begin(c.empty() ? 0 : std::uintptr_t(c.data())),  // an empty one is nowhere
        end(begin + c.size_bytes()) {}
};
/// Alpha first. Rows that are left open are read again: by then they would be written over.
void check_columns(std::initializer_list<Column> columns) {
  for (const Column* c = columns.begin(); c != columns.end(); ++c) {
    if (c->rows != 0) check_size(c->name, c->rows, columns.begin()->rows);
    for (const Column* before = columns.begin(); before != c; ++before)
      if (c->begin < before->end && before->begin < c->end)
        throw InvalidInput(std::string(c->name) + " overlaps " + before->name);
  }
}
/// Where a block of a column goes: unwanted ones to memory of the loop.
template <class T>
T* at(std::span<T> column, std::size_t row, T* unwanted) {
  return column.empty() ? unwanted : column.data() + row;
}
/// What rows from one on are goes through the kernel; each that it leaves open is settled.
void by_block(std::size_t size, auto kernel, auto rows_from, auto settle) {
  Open open;
  for (std::size_t row = 0; row < size; row += longest_block) {
    const auto rows = rows_from(row);
    const std::size_t left = kernel(std::min(longest_block, size - row), rows, open);
    for (std::size_t k = 0; k < left; ++k) settle(rows, open[k]);
  }
}
void velocity_columns(Tier tier, std::span<const double> alpha, std::span<const std::int64_t> n,
                      const VelocityColumns& to) {
  check_arithmetic();
  check_size("n", n.size(), alpha.size());
  check_columns(
      {{"alpha", alpha}, {"n", n}, {"a", to.a}, {"b", to.b}, {"c", to.c}, {"c_prime", to.c_prime}});
  double unwanted[longest_block];
  const auto rows_from = [&](std::size_t row) {
    return VelocityRows{alpha.data() + row,      n.data() + row,
                        at(to.a, row, unwanted), at(to.b, row, unwanted),
                        at(to.c, row, unwanted), at(to.c_prime, row, unwanted)};
  };
  const auto settle = [&](const VelocityRows& rows, std::size_t i) {
    const auto v =
        velocities(tier, rows.alpha[i], rows.n[i]).value_or(Velocities{nan, nan, nan, nan});
    std::tie(rows.a[i], rows.b[i], rows.c[i], rows.c_prime[i]) = std::tie(v.a, v.b, v.c, v.c_prime);
  };
  by_block(alpha.size(), kernels().velocity_rows[tier], rows_from, settle);
}
void terminal_columns(Tier tier, std::span<const double> alpha, const TerminalColumns& to) {
  check_arithmetic();
  check_columns({{"alpha", alpha},
                 {"N_A", to.N_A},
                 {"N_B", to.N_B},
                 {"a_t", to.a_t},
                 {"b_t", to.b_t},
                 {"c_t", to.c_t},
                 {"rho", to.rho}});
  double unwanted[longest_block];
  std::int64_t unwanted_counts[longest_block];
  const auto rows_from = [&](std::size_t row) {
    return TerminalRows{alpha.data() + row,
                        at(to.N_A, row, unwanted_counts),
                        at(to.N_B, row, unwanted_counts),
                        at(to.a_t, row, unwanted),
                        at(to.b_t, row, unwanted),
                        at(to.c_t, row, unwanted),
                        at(to.rho, row, unwanted)};
  };
  const auto settle = [&](const TerminalRows& rows, std::size_t i) {
    const auto t = terminal(tier, rows.alpha[i]).value_or(Terminal{{-1, -1}, nan, nan, nan, nan});
    std::tie(rows.N_A[i], rows.N_B[i]) = std::tie(t.counts.N_A, t.counts.N_B);
    std::tie(rows.a_t[i], rows.b_t[i], rows.c_t[i], rows.rho[i]) =
        std::tie(t.a_t, t.b_t, t.c_t, t.rho);
  };
  by_block(alpha.size(), kernels().terminal_rows[tier], rows_from, settle);
}
}  // namespace
}  // namespace numbers

void accurate::velocities(std::span<const double> alpha, std::span<const std::int64_t> n,
                          const VelocityColumns& columns) {
  numbers::velocity_columns(numbers::accurate, alpha, n, columns);
}
void fast::velocities(std::span<const double> alpha, std::span<const std::int64_t> n,
                      const VelocityColumns& columns) {
  numbers::velocity_columns(numbers::fast, alpha, n, columns);
}
void accurate::terminal(std::span<const double> alpha, const TerminalColumns& columns) {
  numbers::terminal_columns(numbers::accurate, alpha, columns);
}
void fast::terminal(std::span<const double> alpha, const TerminalColumns& columns) {
  numbers::terminal_columns(numbers::fast, alpha, columns);
}
void count_collisions(std::span<const double> alpha, std::span<std::int64_t> N_A,
                      std::span<std::int64_t> N_B) {
  numbers::terminal_columns(numbers::fast, alpha, {N_A, N_B});
}
}  // namespace magicmass
