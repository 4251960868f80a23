// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "magicmass/batch.hpp"
#include "report/contestants.hpp"
#include "report/input_columns.hpp"
#include "report/instruction_sets.hpp"

namespace magicmass::report {
namespace {

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

/// Inputs again and again: what a call costs that does no row is not what is asked.
std::vector<Input> rows_of(std::span<const Input> inputs) {
  constexpr std::size_t least = 512;
  std::vector<Input> rows;
  do rows.insert(rows.end(), inputs.begin(), inputs.end());
  while (rows.size() < least && !inputs.empty());
  return rows;
}

/// run(Table&, InstructionSet) fills the table; members(const Table&, long double*) reads its first row.
template <class Run, class Members>
Contestant on_arrays(const std::string& name, const std::string& quantity, InstructionSet set,
                     Run run, Members members) {
  Contestant one;
  one.name = name + suffix(set);
  one.quantity = quantity;
  one.form = name + ", " + to_text(set);
  one.precision = "double";
  one.can = [](const Input&) { return true; };
  one.evaluate = [=](const Input& input, long double* result) {
    Table table({&input, 1});
    run(table, set);
    members(table, result);
  };
  one.prepare = [=](std::span<const Input> inputs) {
    const std::vector<Input> rows = rows_of(inputs);
    const auto table = std::make_shared<Table>(rows);
    return Prepared{[=] { run(*table, set); }, static_cast<double>(rows.size())};
  };
  one.evaluate_all = [=](std::span<const Input> inputs) {
    Table table(inputs);
    run(table, set);
  };
  return one;
}

/// fast and accurate, with the bounds of the tiers and their time where a batch is left to them.
std::vector<Contestant> as_slow_as_one_by_one(std::vector<Contestant> both) {
  const std::vector<Contestant> tiers = tier_contestants(both.front().quantity);
  for (std::size_t i = 0; i < both.size(); ++i) {
    both[i].ulp_bound = tiers[i].ulp_bound;
    both[i].expected_ns = tiers[i].expected_ns;
  }
  return both;
}

std::vector<Contestant> velocities(const std::string& quantity, InstructionSet set) {
  const auto members = [](const Table& table, long double* result) {
    for (const auto& column : table.reals) *result++ = column[0];
  };
  const auto make = [&](const char* name, auto function) {
    return on_arrays(
        name, quantity, set,
        [function](Table& t, InstructionSet with) {
          function(t.in.alpha, t.in.index, t.reals[0], t.reals[1], t.reals[2], t.reals[3], with);
        },
        members);
  };
  using Function =
      void (*)(std::span<const double>, std::span<const std::int64_t>, std::span<double>,
               std::span<double>, std::span<double>, std::span<double>, InstructionSet);
  return as_slow_as_one_by_one({make("batch_fast", Function{fast::velocities}),
                                make("batch_accurate", Function{accurate::velocities})});
}

std::vector<Contestant> terminal(const std::string& quantity, InstructionSet set) {
  const auto members = [](const Table& table, long double* result) {
    for (std::size_t i = 0; i < 3; ++i) *result++ = table.reals[i][0];
    for (const auto& column : table.counts) *result++ = static_cast<long double>(column[0]);
  };
  const auto make = [&](const char* name, auto function) {
    return on_arrays(
        name, quantity, set,
        [function](Table& t, InstructionSet with) {
          function(t.in.alpha, t.counts[0], t.counts[1], t.reals[0], t.reals[1], t.reals[2], with);
        },
        members);
  };
  return as_slow_as_one_by_one(
      {make("batch_fast", fast::terminal), make("batch_accurate", accurate::terminal)});
}

std::vector<Contestant> counts(const std::string& quantity, InstructionSet set) {
  Contestant one = on_arrays(
      "batch_count", quantity, set,
      [](Table& t, InstructionSet with) {
        count_collisions(t.in.alpha, t.counts[0], t.counts[1], with);
      },
      [](const Table& table, long double* result) {
        for (const auto& column : table.counts) *result++ = static_cast<long double>(column[0]);
      });
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
