// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>

#include "derivation/derivation.hpp"
#include "equality/bounded.hpp"
#include "magicmass/reference/rational.hpp"

int main() {
  magicmass::equality::Question question;
  question.lhs = "sec(pi/5) - 1";
  question.rhs = "sqrt(5) - 2";
  const bool equal =
      magicmass::equality::answer_within(question).answer == magicmass::equality::Answer::equal;
  std::cout << (equal ? "equal" : "not equal") << ", "
            << magicmass::derivation::chapter_names().size() << " chapters, "
            << magicmass::reference::to_text(cln::cl_I(42)) << "\n";
}
