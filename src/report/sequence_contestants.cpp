// SPDX-License-Identifier: GPL-2.0-or-later
// One n after the other at one alpha, or one k after the other. An evaluation is one n of a run of 4096: so
// many are written one after the other, 128 kilobytes of four velocities.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "magicmass/batch.hpp"
#include "report/contestants.hpp"
#include "report/instruction_sets.hpp"

namespace magicmass::report {
namespace {

constexpr std::size_t run_length = 4096;
constexpr double ns_of_one = 20.0;  // roughly, of ratios; of velocities less

using Columns = std::array<std::vector<double>, 4>;

Columns columns_of(std::size_t size) {
  Columns columns;
  for (auto& column : columns) column.resize(size);
  return columns;
}

/// run(input, columns) writes a run that begins at the input, as far as the columns go.
template <class Run>
Contestant in_runs(const std::string& name, const std::string& quantity, const std::string& form,
                   Run run) {
  Contestant one;
  one.name = name;
  one.quantity = quantity;
  one.form = form;
  one.precision = "double";
  one.can = [](const Input&) { return true; };
  one.expected_ns = [](const Input&) { return ns_of_one * static_cast<double>(run_length); };
  one.prepare = [run](std::span<const Input> inputs) {
    const auto columns = std::make_shared<Columns>(columns_of(run_length));
    const std::vector<Input> all(inputs.begin(), inputs.end());
    return Prepared{[=] {
                      for (const Input& input : all) run(input, *columns);
                    },
                    static_cast<double>(inputs.size() * run_length)};
  };
  one.evaluate_all = [prepare = one.prepare](std::span<const Input> inputs) {
    prepare(inputs).run();
  };
  return one;
}

/// The last of 64 of a run, or of fewer from `least` on, so that its errors are those of a run.
template <class Run>
auto end_of_run(Run run, std::int64_t least, std::size_t members) {
  return [=](const Input& input, long double* result) {
    const std::int64_t first = std::max<std::int64_t>(least, input.index - 63);
    Columns columns = columns_of(static_cast<std::size_t>(input.index - first + 1));
    run({input.alpha, first}, columns);
    for (std::size_t i = 0; i < members; ++i) *result++ = columns[i].back();
  };
}

Contestant stream(const std::string& quantity, InstructionSet set) {
  const auto run = [set](const Input& in, Columns& out) {
    velocity_stream(in.alpha, in.index, out[0], out[1], out[2], out[3], set);
  };
  Contestant one = in_runs("stream" + suffix(set), quantity, "stream, " + to_text(set), run);
  one.eps_bound = 3;
  one.evaluate = end_of_run(run, 0, 4);
  return one;
}

std::vector<Contestant> ratios(const std::string& quantity, InstructionSet set) {
  const auto make = [&](const std::string& of_tier, auto function) {
    const auto run = [=](const Input& in, Columns& out) {
      function(in.index, out[0], out[1], set);
    };
    Contestant one = in_runs(of_tier + suffix(set), quantity, of_tier + ", " + to_text(set), run);
    one.evaluate = end_of_run(run, 1, 2);
    return one;
  };
  Contestant of_fast = make("batch_fast", fast::ratios);
  Contestant of_accurate = make("batch_accurate", accurate::ratios);
  of_fast.ulp_bound = 1;
  of_accurate.ulp_bound = 0.5;
  return {std::move(of_fast), std::move(of_accurate)};
}

/// As many bytes as a stream writes.
Contestant copy(const std::string& quantity) {
  const auto from = std::make_shared<const Columns>(columns_of(run_length));
  Contestant one =
      in_runs("copy_loop", quantity, "a copy of as many bytes", [from](const Input&, Columns& out) {
        for (std::size_t column = 0; column < out.size(); ++column) {
          const double* source = (*from)[column].data();
          double* target = out[column].data();
          for (std::size_t i = 0; i < run_length; ++i) target[i] = source[i];
          asm volatile("" : : "r"(target) : "memory");
        }
      });
  one.is_yardstick = true;
  return one;
}

}  // namespace

std::vector<Contestant> sequence_contestants(const std::string& quantity) {
  std::vector<Contestant> all;
  for (const InstructionSet set : available_instruction_sets()) {
    if (quantity == "sequence") all.push_back(stream(quantity, set));
    if (quantity == "ratios")
      for (Contestant& one : ratios(quantity, set)) all.push_back(std::move(one));
  }
  if (quantity == "sequence") all.push_back(copy(quantity));
  return all;
}

}  // namespace magicmass::report
