// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "algebraic/budget.hpp"
#include "algebraic/polynomial.hpp"

namespace GiNaC {
class ex;
}

namespace magicmass::algebraic {

/// The degree up to which annihilating polynomials are made and factored.
constexpr long largest_degree = 16;

/// The minimal polynomial of a constant over the integers: irreducible, primitive, the leading coefficient positive.
/// Nothing if some step on the way exceeds the largest degree or the budget. Throws NotAlgebraic (constant.hpp).
std::optional<Polynomial> minimal_polynomial(const GiNaC::ex& constant, const Budget& budget = {});

/// The constant in words: "the root near 0.2361 of x^2 + 4*x - 1", with so many decimals that it is the only root whose
/// first decimals these are; or "the rational number 1/2". Nothing where there is no minimal polynomial.
std::optional<std::string> as_root(const GiNaC::ex& constant, const Budget& budget = {});

}  // namespace magicmass::algebraic
