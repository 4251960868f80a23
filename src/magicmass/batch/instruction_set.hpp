// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace magicmass {

/// What a batch function may use: SSE2 alone (any x86-64), AVX2 and FMA, or AVX-512 (F, DQ, VL) and FMA. The results are
/// the same bits with each.
enum class InstructionSet { baseline, avx2, avx512 };

/// From the narrowest to the widest.
inline constexpr InstructionSet all_instruction_sets[] = {
    InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

/// "baseline", "avx2" or "avx512".
std::string to_text(InstructionSet instruction_set);

/// Whether this processor and its operating system have it.
bool is_available(InstructionSet instruction_set);

/// The widest that is available; asked of the processor once.
InstructionSet best_instruction_set();

}  // namespace magicmass
