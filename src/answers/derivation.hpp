// derive and verify, and what names stand for in the book.
#pragma once

#include "answers/request.hpp"
#include "kernel/theorem.hpp"
#include "render/pages.hpp"

namespace answers {

/// The whole derivation, or the chapters, steps and labels that are named; "from": a step and what
/// it rests on; "list": labels, theorems and formulas. Throws InvalidInput for an unknown name.
Answer derive(const Request& request);
std::vector<render::Section> derivation_sections();

/// Proves everything again: how many theorems are shown, how many failed, kernel steps.
Answer verify(const Request& request);
/// What verify says where these were shown before the problem; "" where there was none.
Answer verified(const kernel::Theorems& shown, const std::string& problem);

/// The term with what the book defines (psi, theta, V_CM, alpha_k, rho, a_n, ...) written out.
kernel::Expr written_out(kernel::Expr term);
/// The right side of the equation that a theorem of the book is.
kernel::Expr right_side(const std::string& id);

/// What the paper's names stand for, from the book: psi, theta, V_CM, alpha_k, beta_k, a_n, b_n,
/// c_n, c'_n. A line for each in `notes`: "psi = 2*atan(sqrt(alpha*(2 + alpha)))".
kernel::Expr with_meanings(kernel::Expr typed, std::vector<std::string>& notes);

/// The right side of an equation that a step states, in the symbols that people type; of several
/// the one with this left side: "power.a", "deficient.terminal: b_(N_B)". Refused if there is none.
kernel::Expr stated_value(const std::string& step);

}  // namespace answers
