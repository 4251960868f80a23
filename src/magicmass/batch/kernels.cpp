// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. Whatever is included here and is not always inlined has to live in the
// namespace MAGICMASS_TARGET: the linker keeps one copy of any other inline function, which another processor may not run.
#include "magicmass/batch/kernels.hpp"

#include "magicmass/batch/counts.hpp"
#include "magicmass/batch/stream.hpp"

const magicmass::batch::Kernels magicmass::batch::tables::MAGICMASS_TARGET = {
    .counts = count_block_by_block,
    .stream = stream_velocities,
};
