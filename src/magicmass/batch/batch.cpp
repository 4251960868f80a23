// SPDX-License-Identifier: MIT
#include "magicmass/batch.hpp"

#include <array>
#include <charconv>
#include <string>

#include "magicmass/batch/columns.hpp"
#include "magicmass/batch/kernels.hpp"
#include "magicmass/errors.hpp"

namespace magicmass {
namespace batch {

const Kernels& kernels(InstructionSet instruction_set) {
  if (!is_available(instruction_set)) {
    throw InvalidInput("this machine does not have the instruction set " +
                       to_text(instruction_set) + "; the best it has is " +
                       to_text(best_instruction_set()));
  }
  switch (instruction_set) {
    case InstructionSet::avx512:
      return tables::avx512;
    case InstructionSet::avx2:
      return tables::avx2;
    case InstructionSet::baseline:
      break;
  }
  return tables::baseline;
}

}  // namespace batch

void count_collisions(std::span<const double> alpha, std::span<std::int64_t> N_A,
                      std::span<std::int64_t> N_B, InstructionSet instruction_set) {
  batch::require_separate_columns(
      {batch::input("alpha", alpha), batch::output("N_A", N_A), batch::output("N_B", N_B)});
  batch::kernels(instruction_set).counts(alpha.data(), N_A.data(), N_B.data(), alpha.size());
}

void velocity_stream(double alpha, std::int64_t first_n, std::span<double> a, std::span<double> b,
                     std::span<double> c, std::span<double> c_prime,
                     InstructionSet instruction_set) {
  batch::require_separate_columns({batch::output("a", a), batch::output("b", b),
                                   batch::output("c", c), batch::output("c_prime", c_prime)});
  batch::kernels(instruction_set)
      .stream(alpha, first_n, a.data(), b.data(), c.data(), c_prime.data(), a.size());
}

namespace {

using Doubles = std::span<double>;
using Integers = std::span<std::int64_t>;

void check_and_run(batch::Kernels::Velocities run, std::span<const double> alpha,
                   std::span<const std::int64_t> n, Doubles a, Doubles b, Doubles c,
                   Doubles c_prime) {
  batch::require_separate_columns({batch::input("alpha", alpha), batch::input("n", n),
                                   batch::output("a", a), batch::output("b", b),
                                   batch::output("c", c), batch::output("c_prime", c_prime)});
  run(alpha.data(), n.data(), a.data(), b.data(), c.data(), c_prime.data(), alpha.size());
}

void check_and_run(batch::Kernels::VelocitiesAtN run, std::span<const double> alpha, std::int64_t n,
                   Doubles a, Doubles b, Doubles c, Doubles c_prime) {
  batch::require_separate_columns({batch::input("alpha", alpha), batch::output("a", a),
                                   batch::output("b", b), batch::output("c", c),
                                   batch::output("c_prime", c_prime)});
  run(alpha.data(), n, a.data(), b.data(), c.data(), c_prime.data(), alpha.size());
}

void check_and_run(batch::Kernels::Terminal run, std::span<const double> alpha, Integers N_A,
                   Integers N_B, Doubles a_t, Doubles b_t, Doubles c_t) {
  batch::require_separate_columns({batch::input("alpha", alpha), batch::output("N_A", N_A),
                                   batch::output("N_B", N_B), batch::output("a_t", a_t),
                                   batch::output("b_t", b_t), batch::output("c_t", c_t)});
  run(alpha.data(), N_A.data(), N_B.data(), a_t.data(), b_t.data(), c_t.data(), alpha.size());
}

void check_and_run(batch::Kernels::Ratios run, std::int64_t first_k, Doubles magic,
                   Doubles deficient) {
  batch::require_separate_columns(
      {batch::output("magic", magic), batch::output("deficient", deficient)});
  run(first_k, magic.data(), deficient.data(), magic.size());
}

}  // namespace

void fast::velocities(std::span<const double> alpha, std::span<const std::int64_t> n, Doubles a,
                      Doubles b, Doubles c, Doubles c_prime, InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).fast_velocities, alpha, n, a, b, c, c_prime);
}
void accurate::velocities(std::span<const double> alpha, std::span<const std::int64_t> n, Doubles a,
                          Doubles b, Doubles c, Doubles c_prime, InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).accurate_velocities, alpha, n, a, b, c, c_prime);
}
void fast::velocities(std::span<const double> alpha, std::int64_t n, Doubles a, Doubles b,
                      Doubles c, Doubles c_prime, InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).fast_velocities_at_n, alpha, n, a, b, c, c_prime);
}
void accurate::velocities(std::span<const double> alpha, std::int64_t n, Doubles a, Doubles b,
                          Doubles c, Doubles c_prime, InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).accurate_velocities_at_n, alpha, n, a, b, c,
                c_prime);
}
void fast::terminal(std::span<const double> alpha, Integers N_A, Integers N_B, Doubles a_t,
                    Doubles b_t, Doubles c_t, InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).fast_terminal, alpha, N_A, N_B, a_t, b_t, c_t);
}
void accurate::terminal(std::span<const double> alpha, Integers N_A, Integers N_B, Doubles a_t,
                        Doubles b_t, Doubles c_t, InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).accurate_terminal, alpha, N_A, N_B, a_t, b_t, c_t);
}
void fast::transmission(std::span<const double> alpha, double e, Doubles rho,
                        InstructionSet instruction_set) {
  if (!(e >= 0x1p-400 && e <= 1.0)) {
    std::array<char, 32> text{};
    const char* const end = std::to_chars(text.data(), text.data() + text.size(), e).ptr;
    throw InvalidInput("a restitution must be at least 2^-400 and at most 1, got " +
                       std::string(static_cast<const char*>(text.data()), end));
  }
  batch::require_separate_columns({batch::input("alpha", alpha), batch::output("rho", rho)});
  batch::kernels(instruction_set).transmission(alpha.data(), e, rho.data(), alpha.size());
}
void fast::ratios(std::int64_t first_k, Doubles magic, Doubles deficient,
                  InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).fast_ratios, first_k, magic, deficient);
}
void accurate::ratios(std::int64_t first_k, Doubles magic, Doubles deficient,
                      InstructionSet instruction_set) {
  check_and_run(batch::kernels(instruction_set).accurate_ratios, first_k, magic, deficient);
}

}  // namespace magicmass
