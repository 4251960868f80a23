// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "equality/expression.hpp"
#include "magicmass/errors.hpp"

namespace GiNaC {
class ex;
}

namespace magicmass::equality {

// Not a constant that the exact methods handle.
struct OutsideConstants : Undecided {
  using Undecided::Undecided;
};

// A constant as an algebraic number: rationals, roots, cos sin tan of rational multiples of pi and of rational
// multiples (denominators 1, 2, 4, ...) of asin, acos and atan. Where pi stands by itself it becomes the given symbol.
// Throws OutsideConstants. The constant must be defined.
GiNaC::ex algebraic(const Tree& constant, const GiNaC::ex* symbol_for_pi = nullptr);

struct ExactResult {
  std::optional<int> sign;         // -1, 0 or 1
  std::optional<bool> is_nonzero;  // known even where the sign is not
  std::string method;              // a sentence
};

// The sign of a constant that is defined, decided and never estimated: algebraic numbers; polynomials in pi over
// them; rational combinations of inverse trigonometric functions and pi; of logarithms.
ExactResult exact_sign(const Tree& constant);

// The sign alone, as an evaluation asks for it.
std::optional<int> exact_sign_or_nothing(const Tree& constant);

}  // namespace magicmass::equality
