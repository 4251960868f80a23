// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/contestant.hpp"
#include "report/family.hpp"
#include "report/oracle.hpp"
#include "report/rows.hpp"

namespace magicmass::report {

/// How far the search goes on from the worst samples: so many inputs a member and a figure (ulp, envelope, eps).
/// 0: not at all.
struct Climb {
  std::size_t most_inputs = 60;
};

/// The errors of one contestant on one family, a row for each member of the quantity. The contestant is asked what it
/// can take: alpha rounded to its own precision (and n or j cut back to the last collision there), its exact
/// value being that of the rounded alpha. The same figures on every run; they can differ between
/// machines only as their floating-point functions do.
std::vector<ErrorRow> measure(const Contestant& contestant, const Family& family, Oracle& oracle,
                              const Climb& climb = {});

/// The input as a contestant of that precision takes it: alpha rounded, index cut back to the last collision. An alpha
/// that is rounded to 0 or infinity stays so.
Input rounded_input(const Input& input, const std::string& quantity, const std::string& precision);

}  // namespace magicmass::report
