// SPDX-License-Identifier: GPL-2.0-or-later
// The form in which an expression is written: factored, one fraction, and so on.
#pragma once

#include "equality/domain.hpp"
#include "learn/exercise.hpp"

namespace learn {

/// The forms that an exercise may ask for.
Texts forms();
/// What a typed term lacks of a form: the part that has no place in it; why: " is a difference".
struct Lack {
  kernel::Expr part;
  std::string why;
};
std::optional<Lack> lacking(const std::string& form, kernel::Expr typed,
                            const equality::Domain& domain);

}  // namespace learn
