// SPDX-License-Identifier: GPL-2.0-or-later
// What a formula needs to make sense. Functions are total in the kernel, so that no theorem depends
// on this; but nothing should be shown that has 1/x where x may be 0.
#pragma once

#include "kernel/theorem.hpp"

namespace kernel {
/// Where a function is meant to be used: a condition on its parameters. Once for each name.
void restrict_domain(const std::string& name, const Exprs& params, Expr condition);
/// For each term with a restricted domain its condition, under what the formula says before it.
/// Predicates are unfolded by their definitions.
Exprs needs(Expr formula);
/// The same for hypotheses |- conclusion: each hypothesis under those before it, then the
/// conclusion under all of them.
Exprs needs(const Theorem& t);
}  // namespace kernel
