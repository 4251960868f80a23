// derive and verify.
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

}  // namespace answers
