// SPDX-License-Identifier: MIT
#include "magicmass/batch.hpp"

#include <string>

#include "magicmass/batch/columns.hpp"
#include "magicmass/batch/kernels.hpp"
#include "magicmass/errors.hpp"

namespace magicmass {
namespace batch {

const Kernels& kernels(InstructionSet instruction_set) {
  if (!is_available(instruction_set)) {
    throw InvalidInput("this machine does not have the instruction set " +
                       std::string(name(instruction_set)) + "; the best it has is " +
                       name(best_instruction_set()));
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

}  // namespace magicmass
