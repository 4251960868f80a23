// SPDX-License-Identifier: GPL-2.0-or-later
// What theorems are made from, as verify counts it and derive shows it.
#include "answers/derivation.hpp"

#include "catch.hpp"

using namespace answers;

TEST_CASE("a proof that fails is counted, and said beside the counts") {
  const kernel::Theorems shown{kernel::assume(kernel::eq(1, 1))};
  const Answer answer = verified(shown, "no proof of a = b");
  CHECK(answer.check_failed);
  CHECK(answer.note == "verify: not proved: no proof of a = b");
  const Row& row = answer.table.rows.at(0);
  CHECK((row[0].text == "1" && row[1].text == "1" && row[2].text == "1"));
  CHECK_FALSE(verified(shown, "").check_failed);
}
