// SPDX-License-Identifier: GPL-2.0-or-later
// GiNaC derives: it solves, multiplies out and factors. What it says is a proposal that the kernel
// certifies, so a mistake of GiNaC's is a proof that is not found. Results do not depend on
// GiNaC's order of terms, which changes from run to run.
#pragma once
#include "kernel/expr.hpp"

namespace algebra {
using kernel::Expr;
using kernel::Exprs;

/// The unknowns from equations that are linear in them (after denominators are cleared), in the
/// order of `unknowns`, each as `simplified` with `collect`. Throws Refused where there is not
/// exactly one solution.
Exprs solve(const Exprs& equations, const Exprs& unknowns, const Exprs& collect = {});
/// A quotient of products of powers, roots out of the denominator; sums are collected by the atoms
/// in `collect`. Everything but +, *, powers, quotients and square roots is an atom. Matrices
/// entry by entry.
Expr simplified(Expr term, const Exprs& collect = {});
}  // namespace algebra
