// Attacks: each is refused, and for the reason that stands beside it.
#pragma once

#include <sstream>

#include "catch.hpp"
#include "kernel/theorem.hpp"
#include "notation/typed.hpp"

// What most attacks are about.
inline const kernel::Expr x = kernel::real("x"), y = kernel::real("y");
inline const kernel::Expr i = kernel::integer("i"), n = kernel::integer("n");
inline const kernel::Expr half = kernel::Expr(1) / 2;
inline const kernel::Theorem zero = kernel::arithmetic(kernel::eq(0, 0), {});
inline const kernel::Theorem positive = kernel::assume(kernel::lt(0, x));
inline const kernel::Theorem nought = kernel::assume(kernel::eq(x, 0));
/// A term of more than 2^times nodes.
inline kernel::Expr doubled(int times) {
  kernel::Expr e = x;
  for (int k = 0; k < times; ++k) e = sin(e + e);
  return e;
}

/// Terms and formulas with ";" between them.
inline kernel::Exprs listed(const std::string& words) {
  kernel::Exprs out;
  std::istringstream in(words);
  for (std::string word; std::getline(in, word, ';');) out.push_back(notation::read(word));
  return out;
}
template <class Act>
void refused(const std::string& name, const std::string& because, const Act& act) {
  INFO(name);
  CHECK_THROWS_WITH(act(), ContainsSubstring(because));
  CHECK_THROWS_AS(act(), kernel::Refused);
}
// What is refused, as an act to come.
inline auto made(const kernel::Parts& parts) {
  return [=] { kernel::make(parts); };
}
inline auto recursive(const kernel::Exprs& params, kernel::Expr index, const kernel::Exprs& before,
                      const kernel::Exprs& start, const kernel::Exprs& next) {
  return [=] { kernel::define_recursive({"bad"}, params, index, before, start, next); };
}
inline auto least(const kernel::Exprs& params, kernel::Expr index, kernel::Expr lo,
                  kernel::Expr f) {
  return [=] { kernel::define_least("bad", params, index, lo, f); };
}
// A goal that does not follow from these theorems.
inline void does_not_follow(const std::string& name, kernel::Expr goal,
                            const kernel::Theorems& from) {
  refused(name, "does not follow", [&] { kernel::tautology(goal, from); });
}
