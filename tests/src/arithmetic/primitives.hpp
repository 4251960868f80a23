// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "magicmass/batch/instruction_set.hpp"

namespace magicmass::testing {

/// One function of src/magicmass/arithmetic, element by element: column k of the inputs begins at in + k size, and of the
/// outputs at out + k size; size is a multiple of 8. A pair takes two columns; numbers that know their error, three.
struct Primitive {
  using Run = void (*)(const double* in, double* out, std::size_t size);

  const char* name;
  std::size_t inputs;
  std::size_t outputs;
  Run run[4];  ///< on one double, 2, 4 and 8 lanes; null where the instruction set has none
};

inline constexpr std::size_t primitive_count = 85;

/// primitives_for_target.cpp, compiled once for each instruction set as the kernels are.
namespace primitives {
extern const Primitive baseline[primitive_count];
extern const Primitive avx2[primitive_count];
extern const Primitive avx512[primitive_count];
}  // namespace primitives

/// Throws std::logic_error for a name that is none.
const Primitive& primitive(InstructionSet instruction_set, const char* name);

}  // namespace magicmass::testing
