// SPDX-License-Identifier: GPL-2.0-or-later
// The kernels for one input give the same bits, and the same certainty, on every instruction set of this machine.
#include <bit>
#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/tiers/single_kernels.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using tiers::SingleKernels;

namespace {

void add(std::vector<std::uint64_t>& bits, double x) {
  bits.push_back(std::bit_cast<std::uint64_t>(x));
}
template <class Result>
void add(std::vector<std::uint64_t>& bits, const Result& all) {
  for (const double x : as_array(all)) add(bits, x);
}
void add_terminal(std::vector<std::uint64_t>& bits, const SingleKernels& kernels, double alpha) {
  Terminal all{};
  bits.push_back(kernels.fast_terminal(alpha, all));
  if (alpha < 1.0) bits.push_back(static_cast<std::uint64_t>(kernels.total(alpha)));
  for (const double x : {all.a_t, all.b_t, all.c_t, all.rho}) add(bits, x);
}

/// All that the kernels say of one alpha and one n.
std::vector<std::uint64_t> bits(const SingleKernels& kernels, double alpha, double n,
                                const Counts& counts) {
  std::vector<std::uint64_t> all;
  const double N_A = static_cast<double>(counts.N_A);
  const double turn = counts.N_A == counts.N_B ? 1.0 : -1.0;
  add(all, kernels.fast_velocities(alpha, n, 0.0));
  if (alpha < 1.0) add(all, kernels.fast_encounters(alpha, n, n > 0x1p40 ? 0.5 : 0.0));
  add(all, kernels.fast_angle(alpha));
  add(all, kernels.fast_ratios(n + 1, n > 0x1p40 ? 0.5 : 0.0));
  add_terminal(all, kernels, alpha);
  generated::Velocities<double> velocities;
  generated::Encounters<double> encounters;
  generated::Ratios<double> ratios;
  generated::TerminalValues<double> terminal;
  double angle = 0.0;
  all.push_back(kernels.velocities(alpha, n, velocities));
  all.push_back(kernels.encounters(alpha, n, encounters));
  all.push_back(kernels.angle(alpha, angle));
  all.push_back(kernels.ratios(n + 1, ratios));
  all.push_back(kernels.terminal(alpha, N_A, turn, terminal));
  add(all, velocities);
  add(all, encounters);
  add(all, angle);
  add(all, ratios);
  add(all, terminal);
  all.push_back(kernels.terminal_in_second_stage(alpha, N_A, turn, terminal));
  add(all, terminal);
  return all;
}

void require_same(double low, double high, std::uint64_t seed, int size) {
  testing::Generator generator(seed);
  for (int i = 0; i < size; ++i) {
    const double alpha = testing::log_uniform(generator, low, high);
    const Counts counts = count_collisions(alpha).value();
    const auto n = static_cast<double>(
        testing::whole(generator, alpha < 1.0 ? 2 : 0, std::max<std::int64_t>(counts.N_A, 1)));
    const auto expected = bits(tiers::single_kernels(InstructionSet::baseline), alpha, n, counts);
    for (const InstructionSet set : testing::available_instruction_sets()) {
      INFO(to_text(set) << ", alpha = " << alpha << ", n = " << n);
      REQUIRE(bits(tiers::single_kernels(set), alpha, n, counts) == expected);
    }
  }
}

}  // namespace

TEST_CASE("kernels for one input have the same bits everywhere", "[check]") {
  require_same(1e-6, 0.2, 91, 20000);
  require_same(1e-29, 0.2, 92, 5000);
}

TEST_CASE("from alpha = 1 on, too", "[check]") {
  testing::Generator generator(93);
  for (int i = 0; i < 5000; ++i) {
    const double alpha = testing::log_uniform(generator, 1.0, 0x1p400);
    for (const double n : {0.0, 1.0}) {
      const auto expected = bits(tiers::single_kernels(InstructionSet::baseline), alpha, n, {1, 1});
      for (const InstructionSet set : testing::available_instruction_sets()) {
        INFO(to_text(set) << ", alpha = " << alpha << ", n = " << n);
        REQUIRE(bits(tiers::single_kernels(set), alpha, n, {1, 1}) == expected);
      }
    }
  }

  // tier fast goes on up to 2^960
  for (int i = 0; i < 2000; ++i) {
    const double alpha = testing::log_uniform(generator, 0x1p400, 0x1p960);
    std::vector<std::uint64_t> expected;
    for (const InstructionSet set : testing::available_instruction_sets()) {
      std::vector<std::uint64_t> all;
      add(all, tiers::single_kernels(set).fast_velocities(alpha, 1.0, 0.0));
      add_terminal(all, tiers::single_kernels(set), alpha);
      if (expected.empty()) expected = all;
      INFO(to_text(set) << ", alpha = " << alpha);
      REQUIRE(all == expected);
    }
  }
}
