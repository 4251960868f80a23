// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "proof/theorem.hpp"

namespace magicmass::render {

/// The steps that a reader means by a step's id, by a label of the paper (eq:a-final), or by the paper's symbol (a_n,
/// c'_n, c_prime_n, alpha_k, N_A, Lambda): for a symbol the one step that states it, the paper's form before others.
/// None if nothing has that name.
std::vector<proof::Step> steps_called(const std::string& name, const std::vector<proof::Step>& all);

/// Every name that finds something, in the derivation's order.
std::vector<std::string> all_names(const std::vector<proof::Step>& all);

/// The labels that a step cites: "eq:Lam-G-G, Lam-GAM" as two, "app:Vn, Gamma_A" as one.
std::vector<std::string> labels_of(const proof::Step& step);

}  // namespace magicmass::render
