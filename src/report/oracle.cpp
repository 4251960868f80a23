// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/oracle.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <cln/integer.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "report/exact_angles.hpp"
#include "report/exact_velocities.hpp"
#include "report/quantities.hpp"

namespace magicmass::report {
namespace {

/// alpha_k and beta_k; irrational but for alpha_1 = 1, so that the rounding ends.
template <class Ratio>
ExactValue exact_ratio(const Ratio& ratio) {
  constexpr long most_bits = 3200;
  for (long bits = 200; bits <= most_bits; bits *= 2) {
    const cln::cl_RA y = reference::ratio_within(ratio, bits);
    if (rounding_is_certain(y, bits)) return exact_value(y);
  }
  throw Undecided("the rounding of a ratio stays open at every precision tried");
}

std::vector<ExactValue> exact_counts(const Input& input) {
  const reference::LargeCounts counts = reference::count_collisions(reference::exact(input.alpha));
  return {exact_value(counts.N_A), exact_value(counts.N_B)};
}

std::vector<ExactValue> exact_members(const std::string& quantity, const Input& input) {
  if (quantity == "elastic_terminal") {
    std::vector<ExactValue> members = exact_terminal(input.alpha);
    for (const ExactValue& count : exact_counts(input)) members.push_back(count);
    return members;
  }
  if (quantity == "velocities" || quantity == "sequence") return exact_velocities(input);
  if (quantity == "encounters") return exact_encounter(input);
  if (quantity == "angle") return exact_angle(input);
  if (quantity == "ratios")
    return {exact_ratio(Magic{input.index}), exact_ratio(Deficient{input.index})};
  return exact_counts(input);
}

}  // namespace

const std::vector<ExactValue>& Oracle::at(const std::string& quantity, const Input& input,
                                          const std::string& derived_form) {
  const Quantity& asked = quantity_named(quantity);
  const std::string form = asked.is_known ? "" : derived_form;
  const std::tuple key(asked.name, form, asked.takes("alpha") ? input.alpha : 0.0, input.index,
                       input.e);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  if (asked.is_known) return known_.emplace(key, exact_members(quantity, input)).first->second;
  const auto learnt = learnt_.find({quantity, form});
  if (learnt == learnt_.end())
    throw std::logic_error("the oracle has not learnt what " + quantity + " are");
  return known_.emplace(key, learnt->second(input)).first->second;
}

void Oracle::learn(const std::string& quantity, const std::string& derived_form, Formula formula) {
  if (quantity_named(quantity).is_known)
    throw std::logic_error("the oracle knows what " + quantity + " are");
  learnt_[{quantity, derived_form}] = std::move(formula);
}

}  // namespace magicmass::report
