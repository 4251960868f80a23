// SPDX-License-Identifier: GPL-2.0-or-later
// The fixed cases on which evaluators are measured, with exact values and the event simulator's.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cln/rational.h>

namespace magicmass::command {

/// One number that an evaluator returns for a case.
template <class Real>
struct Expected {
  cln::cl_RA exact;
  double scale =
      0.0;  ///< largest exact value of this quantity at this alpha; 0: relative errors alone
  bool exists = true;      ///< false: no collision, only the formula goes on
  bool simulated = false;  ///< the event simulator has it too
  Real from_simulator = 0;
};

/// Arguments (alpha and n, alpha and j, or k) and what should come out, in the order of the result's members.
template <class Real>
struct EvaluatorCase {
  Real alpha;
  std::int64_t index;
  std::vector<Expected<Real>> values;
};

/// The paper's range of alpha, and beyond it a ball heavier than the blocks.
enum class AlphaRange { up_to_1, above_1 };

/// a, b, c and c' at 12 alphas from 1e-6 to 1 (or at 10, 1000 and 1e6), up to 12 values of n from 0 to N_A each.
template <class Real>
std::vector<EvaluatorCase<Real>> velocity_cases(AlphaRange range);
/// t and s of every collision at the alphas from 0.01 to 1; exact values by events in rationals.
template <class Real>
std::vector<EvaluatorCase<Real>> encounter_cases();
/// alpha_k and beta_k, k from 1 to 1e6; exact values by CLN's pi and cosine.
template <class Real>
std::vector<EvaluatorCase<Real>> ratio_cases();
/// psi at alphas from 1e-12 to 1e12; exact values by CLN's arctangent.
template <class Real>
std::vector<EvaluatorCase<Real>> angle_cases();

/// In how many of the exact velocity and encounter cases the generated exact forms, the reference and the event
/// simulator in rationals agree.
struct ExactAgreement {
  int cases = 0;
  int agreeing = 0;
};
ExactAgreement exact_agreement();

}  // namespace magicmass::command
