// SPDX-License-Identifier: GPL-2.0-or-later
// What a user answered before: a line an answer in answers.tsv, in the folder of their state.
#pragma once

#include <map>
#include <set>
#include <string>

#include "learn/judge.hpp"

namespace classroom {

struct Attempts {
  std::string done = {};  ///< "right" where it was once, "tried", or ""
  std::size_t misses = 0;
  std::set<std::string> shown = {};  ///< "hint 1" and so on
};

/// By exercise. Nothing where nothing was kept, or where it cannot be.
std::map<std::string, Attempts> attempts();
/// Keeps what was said to an answer. From the third miss on, each adds to the feedback the next
/// hint that was not shown yet, or else where the solution is.
void remember(const learn::Exercise& exercise, learn::Judgement& said);
/// Keeps that a hint, counted from 1, was shown.
void remember_hint(const learn::Exercise& exercise, std::size_t number);

}  // namespace classroom
