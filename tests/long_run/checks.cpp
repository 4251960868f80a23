// SPDX-License-Identifier: GPL-2.0-or-later
#include "long_run/checks.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "long_run/stages.hpp"
#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/evaluators/certified_angles.hpp"
#include "magicmass/evaluators/certified_encounters.hpp"
#include "magicmass/evaluators/certified_velocities.hpp"

namespace magicmass::long_run {
namespace {

using report::Input;
using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

Doubles alphas(const Inputs& inputs) {
  Doubles column;
  for (const Input& input : inputs) column.push_back(input.alpha);
  return column;
}

template <class Run>
void on_every_instruction_set(const Run& run) {
  for (const InstructionSet set : all_instruction_sets)
    if (is_available(set)) run(set);
}

Tally velocities(const Inputs& inputs) {
  const std::size_t size = inputs.size();
  const Doubles alpha = alphas(inputs);
  Integers n;
  std::vector<generated::Velocities<double>> expected;
  Tally tally;
  for (const Input& input : inputs) {
    n.push_back(input.index);
    const auto nearest = certified_velocities(input.alpha, input.index);
    const auto one = accurate::velocities(input.alpha, input.index);
    tally.misrounded_single += differences<double>({{one.a, nearest.a},
                                                    {one.b, nearest.b},
                                                    {one.c, nearest.c},
                                                    {one.c_prime, nearest.c_prime}});
    ++tally.decided_at(velocities_stage(input.alpha, input.index));
    expected.push_back(nearest);
  }
  Doubles a(size), b(size), c(size), c_prime(size);
  on_every_instruction_set([&](InstructionSet set) {
    accurate::velocities(alpha, n, a, b, c, c_prime, set);
    for (std::size_t i = 0; i < size; ++i)
      tally.misrounded_batch += differences<double>({{a[i], expected[i].a},
                                                     {b[i], expected[i].b},
                                                     {c[i], expected[i].c},
                                                     {c_prime[i], expected[i].c_prime}});
  });
  return tally;
}

Terminal certified_terminal(double alpha, const std::optional<Counts>& counts) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!counts) return {{-1, -1}, nan, nan, nan, nan};
  const auto at_A = certified_velocities(alpha, counts->N_A);
  const bool is_Q_last = counts->N_A == counts->N_B;
  return {*counts, at_A.a, is_Q_last ? at_A.b : certified_velocity(Velocity::b, alpha, counts->N_B),
          is_Q_last ? at_A.c_prime : at_A.c, certified_energy_fraction(alpha)};
}

Tally terminal(const Inputs& inputs) {
  const std::size_t size = inputs.size();
  const Doubles alpha = alphas(inputs);
  std::vector<Terminal> expected;
  Tally tally;
  for (const double x : alpha) {
    const auto counts = count_collisions(x);
    const Terminal nearest = certified_terminal(x, counts);
    expected.push_back(nearest);
    const auto one = accurate::terminal(x);
    if (one.has_value() != counts.has_value() || (one && one->counts != *counts))
      ++tally.wrong_counts;
    ++tally.decided_at(counts ? terminal_stage(x, *counts) : Stage::first);
    if (!one) continue;
    tally.misrounded_single += differences<double>({{one->a_t, nearest.a_t},
                                                    {one->b_t, nearest.b_t},
                                                    {one->c_t, nearest.c_t},
                                                    {one->rho, nearest.rho}});
  }
  Doubles a(size), b(size), c(size);
  Integers N_A(size), N_B(size), counted_A(size), counted_B(size);
  on_every_instruction_set([&](InstructionSet set) {
    accurate::terminal(alpha, N_A, N_B, a, b, c, set);
    count_collisions(alpha, counted_A, counted_B, set);
    for (std::size_t i = 0; i < size; ++i) {
      tally.misrounded_batch += differences<double>(
          {{a[i], expected[i].a_t}, {b[i], expected[i].b_t}, {c[i], expected[i].c_t}});
      tally.wrong_counts += differences<std::int64_t>({{N_A[i], expected[i].counts.N_A},
                                                       {N_B[i], expected[i].counts.N_B},
                                                       {counted_A[i], expected[i].counts.N_A},
                                                       {counted_B[i], expected[i].counts.N_B}});
    }
  });
  return tally;
}

Tally encounters(const Inputs& inputs) {
  Tally tally;
  for (const Input& input : inputs) {
    const auto nearest = certified_encounters(input.alpha, input.index);
    const auto one = accurate::encounters(input.alpha, input.index);
    tally.misrounded_single += differences<double>({{one.t, nearest.t}, {one.s, nearest.s}});
    ++tally.decided_at(encounters_stage(input.alpha, input.index));
  }
  return tally;
}

Tally angle(const Inputs& inputs) {
  Tally tally;
  for (const Input& input : inputs) {
    tally.misrounded_single +=
        differences<double>({{accurate::angle(input.alpha), certified_angle(input.alpha)}});
    ++tally.decided_at(angle_stage(input.alpha));
  }
  return tally;
}

Tally ratios(const Inputs& inputs) {
  Tally tally;
  for (const Input& input : inputs) {
    const auto nearest = certified_ratios(input.index);
    const auto one = accurate::ratios(input.index);
    tally.misrounded_single +=
        differences<double>({{one.magic, nearest.magic}, {one.deficient, nearest.deficient}});
    ++tally.decided_at(ratios_stage(input.index));
    // in a vector with its neighbours
    constexpr std::size_t rows = 8;
    double magic[rows], deficient[rows];
    on_every_instruction_set([&](InstructionSet set) {
      accurate::ratios(input.index, magic, deficient, set);
      tally.misrounded_batch +=
          differences<double>({{magic[0], nearest.magic}, {deficient[0], nearest.deficient}});
    });
  }
  return tally;
}

}  // namespace

Tally checked(const std::string& quantity, const Inputs& inputs) {
  Tally tally;
  if (quantity == "velocities")
    tally = velocities(inputs);
  else if (quantity == "terminal")
    tally = terminal(inputs);
  else if (quantity == "encounters")
    tally = encounters(inputs);
  else if (quantity == "angle")
    tally = angle(inputs);
  else if (quantity == "ratios")
    tally = ratios(inputs);
  else
    throw std::logic_error("no check of " + quantity);
  tally.inputs = static_cast<std::int64_t>(inputs.size());
  return tally;
}

}  // namespace magicmass::long_run
