// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace magicmass::batch {

/// What the batch says of one alpha, from the exact function for one: -1 and -1 where alpha is not positive and finite
/// or N_A + N_B does not fit. A plain function, so that no inline code of the library is compiled for more than
/// one instruction set.
void count_exactly(double alpha, std::int64_t* N_A, std::int64_t* N_B);

}  // namespace magicmass::batch
