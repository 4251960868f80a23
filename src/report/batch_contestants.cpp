// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "magicmass/batch.hpp"
#include "report/contestants.hpp"
#include "report/input_columns.hpp"
#include "report/instruction_sets.hpp"

namespace magicmass::report {
namespace {

using ExpectedTime = std::function<double(const Input&)>;

/// What a batch function reads and writes.
struct Table {
  InputColumns in;
  std::array<std::vector<double>, 4> reals;
  std::array<std::vector<std::int64_t>, 2> counts;

  explicit Table(std::span<const Input> inputs) : in(inputs) {
    for (auto& column : reals) column.resize(inputs.size());
    for (auto& column : counts) column.resize(inputs.size());
  }
};

/// Inputs again and again: what a call costs that does no row is not what is asked. Beside slow rows it is nothing.
std::vector<Input> rows_of(std::span<const Input> inputs, const ExpectedTime& expected_ns) {
  constexpr double slow_ns = 1e3;
  const bool has_slow_rows =
      expected_ns && std::any_of(inputs.begin(), inputs.end(),
                                 [&](const Input& input) { return expected_ns(input) >= slow_ns; });
  const std::size_t least = has_slow_rows ? 0 : 512;
  std::vector<Input> rows;
  do rows.insert(rows.end(), inputs.begin(), inputs.end());
  while (rows.size() < least && !inputs.empty());
  return rows;
}

/// run(Table&, InstructionSet) fills the table; members(const Table&, long double*) reads its first row.
template <class Run, class Members>
Contestant on_arrays(const std::string& name, const std::string& quantity, InstructionSet set,
                     Run run, Members members, const ExpectedTime& expected_ns = {}) {
  Contestant one;
  one.name = name + suffix(set);
  one.quantity = quantity;
  one.form = name + ", " + to_text(set);
  one.precision = "double";
  one.can = [](const Input&) { return true; };
  one.expected_ns = expected_ns;
  one.evaluate = [=](const Input& input, long double* result) {
    Table table({&input, 1});
    run(table, set);
    members(table, result);
  };
  one.prepare = [=](std::span<const Input> inputs) {
    const std::vector<Input> rows = rows_of(inputs, expected_ns);
    const auto table = std::make_shared<Table>(rows);
    return Prepared{[=] { run(*table, set); }, static_cast<double>(rows.size())};
  };
  one.evaluate_all = [=](std::span<const Input> inputs) {
    Table table(inputs);
    run(table, set);
  };
  return one;
}

/// make(name, function, expected time): fast and accurate, as exact and where rows are left to them as slow as the tiers.
template <class Make, class Function>
std::vector<Contestant> both_tiers(const std::string& quantity, Make make, Function fast,
                                   Function accurate) {
  const std::vector<Contestant> tiers = tier_contestants(quantity);
  std::vector<Contestant> both = {make("batch_fast", fast, tiers[0].expected_ns),
                                  make("batch_accurate", accurate, tiers[1].expected_ns)};
  for (std::size_t i = 0; i < both.size(); ++i) both[i].ulp_bound = tiers[i].ulp_bound;
  return both;
}

std::vector<Contestant> velocities(const std::string& quantity, InstructionSet set) {
  const auto members = [](const Table& table, long double* result) {
    for (const auto& column : table.reals) *result++ = column[0];
  };
  const auto make = [&](const char* name, auto function, const ExpectedTime& expected_ns) {
    return on_arrays(
        name, quantity, set,
        [function](Table& t, InstructionSet with) {
          function(t.in.alpha, t.in.index, t.reals[0], t.reals[1], t.reals[2], t.reals[3], with);
        },
        members, expected_ns);
  };
  using Function =
      void (*)(std::span<const double>, std::span<const std::int64_t>, std::span<double>,
               std::span<double>, std::span<double>, std::span<double>, InstructionSet);
  return both_tiers(quantity, make, Function{fast::velocities}, Function{accurate::velocities});
}

std::vector<Contestant> terminal(const std::string& quantity, InstructionSet set) {
  const auto members = [](const Table& table, long double* result) {
    for (std::size_t i = 0; i < 3; ++i) *result++ = table.reals[i][0];
    for (const auto& column : table.counts) *result++ = static_cast<long double>(column[0]);
  };
  const auto make = [&](const char* name, auto function, const ExpectedTime& expected_ns) {
    return on_arrays(
        name, quantity, set,
        [function](Table& t, InstructionSet with) {
          function(t.in.alpha, t.counts[0], t.counts[1], t.reals[0], t.reals[1], t.reals[2], with);
        },
        members, expected_ns);
  };
  return both_tiers(quantity, make, fast::terminal, accurate::terminal);
}

std::vector<Contestant> counts(const std::string& quantity, InstructionSet set) {
  Contestant one = on_arrays(
      "batch_count", quantity, set,
      [](Table& t, InstructionSet with) {
        count_collisions(t.in.alpha, t.counts[0], t.counts[1], with);
      },
      [](const Table& table, long double* result) {
        for (const auto& column : table.counts) *result++ = static_cast<long double>(column[0]);
      },
      certified_contestants(quantity).front().expected_ns);
  one.ulp_bound = 0;
  return {one};
}

}  // namespace

std::vector<Contestant> batch_contestants(const std::string& quantity) {
  const auto with = quantity == "velocities"         ? velocities
                    : quantity == "elastic_terminal" ? terminal
                    : quantity == "counts"           ? counts
                                                     : nullptr;
  std::vector<Contestant> all;
  if (with == nullptr) return all;
  for (const InstructionSet set : available_instruction_sets())
    for (Contestant& one : with(quantity, set)) all.push_back(std::move(one));
  return all;
}

}  // namespace magicmass::report
