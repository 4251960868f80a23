// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of attacks: each is refused, and for the reason that stands beside it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catch.hpp"
#include "kernel/theorem.hpp"

struct Attack {
  std::string name;
  std::string because;
  std::function<void()> act;
};
inline void refuse_all(const std::vector<Attack>& attacks) {
  for (const Attack& a : attacks) {
    INFO(a.name);
    CHECK_THROWS_WITH(a.act(), ContainsSubstring(a.because));
    CHECK_THROWS_AS(a.act(), kernel::Refused);
  }
}
// A goal that does not follow from these theorems.
struct Conclusion {
  std::string name;
  kernel::Expr goal;
  kernel::Theorems from;
};
inline void refuse_conclusions(const std::vector<Conclusion>& conclusions) {
  for (const Conclusion& c : conclusions) {
    INFO(c.name);
    CHECK_THROWS_WITH(kernel::tautology(c.goal, c.from), ContainsSubstring("does not follow"));
  }
}
