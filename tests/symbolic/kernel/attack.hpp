// SPDX-License-Identifier: GPL-2.0-or-later
// Attacks: each is refused, and for the reason that stands beside it.
#pragma once

#include <string>

#include "catch.hpp"
#include "kernel/theorem.hpp"

// What most attacks are about.
namespace attacked {
inline const kernel::Expr x = kernel::real("x");
inline const kernel::Expr y = kernel::real("y");
inline const kernel::Expr i = kernel::integer("i");
inline const kernel::Expr n = kernel::integer("n");
inline const kernel::Expr half = kernel::Expr(1) / 2;
inline const kernel::Theorem zero = kernel::arithmetic(kernel::eq(0, 0), {});
inline const kernel::Theorem positive = kernel::assume(kernel::lt(0, x));
inline const kernel::Theorem nought = kernel::assume(kernel::eq(x, 0));
}  // namespace attacked

template <class Act>
void refused(const std::string& name, const std::string& because, const Act& act) {
  INFO(name);
  CHECK_THROWS_WITH(act(), ContainsSubstring(because));
  CHECK_THROWS_AS(act(), kernel::Refused);
}
// A goal that does not follow from these theorems.
inline void does_not_follow(const std::string& name, kernel::Expr goal,
                            const kernel::Theorems& from) {
  INFO(name);
  CHECK_THROWS_WITH(kernel::tautology(goal, from), ContainsSubstring("does not follow"));
}
