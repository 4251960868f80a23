// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace magicmass::render {

/// A name taken apart: V_CM is V with the subscript CM, c' is c with a prime, c_prime too.
struct Symbol {
  std::string base;
  std::string subscript;
  std::size_t primes = 0;
};
Symbol symbol_of(std::string_view name);

/// One letter or one Greek letter, with whatever subscript and primes; or det and its like.
bool looks_like_symbol(std::string_view name);

/// cos, ceil, lambda, Gamma_A and others that are applied to an argument, whatever that is.
bool is_function_name(std::string_view name);

/// cos, arctan, det: as it is printed upright; empty if the name is no such function.
std::string upright_function(std::string_view name);

/// "alpha" as "α"; anything else as it is.
std::string unicode_letter(std::string_view name);

/// "alpha" as "\alpha"; one letter as it is; else upright.
std::string latex_letter(std::string_view name);

std::string unicode_sign(std::string_view sign);  ///< "<=" as "≤"
std::string latex_sign(std::string_view sign);

}  // namespace magicmass::render
