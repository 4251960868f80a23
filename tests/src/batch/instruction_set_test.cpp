// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/batch/instruction_set.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/errors.hpp"

using namespace magicmass;

TEST_CASE("the best instruction set is the last that is available", "[exam]") {
  CHECK(is_available(InstructionSet::baseline));
  CHECK(testing::available_instruction_sets().back() == best_instruction_set());
  CHECK(to_text(InstructionSet::avx512) == "avx512");
  CHECK(to_text(InstructionSet::baseline) == "baseline");
}

TEST_CASE("an instruction set that the machine lacks is refused in one line", "[exam]") {
  for (const InstructionSet set : all_instruction_sets) {
    if (is_available(set)) {
      CHECK_NOTHROW(count_collisions({}, {}, {}, set));
    } else {
      CHECK_THROWS_WITH(count_collisions({}, {}, {}, set),
                        "this machine does not have the instruction set " + to_text(set) +
                            "; the best it has is " + to_text(best_instruction_set()));
    }
  }
}
