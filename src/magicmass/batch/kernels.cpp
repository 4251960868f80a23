// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. Whatever is included here and is not always inlined has to live in the
// namespace MAGICMASS_TARGET: the linker keeps one copy of any other inline function, which another processor may not run.
#include "magicmass/batch/kernels.hpp"

#include <type_traits>

#include "magicmass/arithmetic/side_by_side.hpp"
#include "magicmass/batch/counts.hpp"
#include "magicmass/batch/ratios.hpp"
#include "magicmass/batch/stream.hpp"
#include "magicmass/batch/terminal.hpp"
#include "magicmass/batch/transmission.hpp"
#include "magicmass/batch/velocities.hpp"

namespace magicmass::batch {
namespace {
using Lanes = arithmetic::Lanes<arithmetic::widest>;
using Pairs = arithmetic::Pair<Lanes>;
// Two registers at a time where there are 32 of them.
using Rows = std::conditional_t<arithmetic::widest == 8, arithmetic::SideBySide<Lanes>, Lanes>;
using Fast = arithmetic::Rough<Rows>;
using Accurate = arithmetic::Tracked<Lanes, true>;
}  // namespace

const Kernels tables::MAGICMASS_TARGET = {
    .counts = count_block_by_block,
    .stream = stream_velocities,
    .fast_velocities = velocities_block_by_block<Fast>,
    .accurate_velocities = velocities_block_by_block<Accurate>,
    .fast_velocities_at_n = velocities_at_n_block_by_block<Fast, Pairs>,
    .accurate_velocities_at_n = velocities_at_n_block_by_block<Accurate>,
    .fast_terminal = terminal_block_by_block<Fast>,
    .accurate_terminal = terminal_block_by_block<Accurate>,
    .transmission = transmission_block_by_block,
    .fast_ratios = ratios_block_by_block<Pairs>,
    .accurate_ratios = ratios_block_by_block<Accurate>,
};

}  // namespace magicmass::batch
