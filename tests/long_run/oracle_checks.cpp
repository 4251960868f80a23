// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <initializer_list>

#include "long_run/checks.hpp"
#include "magicmass/accurate.hpp"
#include "report/oracle.hpp"
#include "tiers/exact_terminal.hpp"

namespace magicmass::long_run {
namespace {

using report::ExactValue;

std::int64_t differ(std::initializer_list<double> got, const std::vector<ExactValue>& exact) {
  std::int64_t different = 0;
  auto value = exact.begin();
  for (const double x : got) {
    different += !value->exists || x == value->nearest_double ? 0 : 1;
    ++value;
  }
  return different;
}

Tally compared(const std::string& quantity, const report::Input& input, report::Oracle& oracle) {
  Tally tally;
  tally.oracle_inputs = 1;
  if (quantity == "terminal") {
    const auto got = accurate::terminal(input.alpha);
    const auto exact = testing::exact_terminal(oracle, input.alpha);
    if (got.has_value() != exact.has_value() || (got && got->counts != exact->counts))
      tally.wrong_counts = 1;
    else if (got)
      tally.oracle_wrong = differ({got->a_t, got->b_t, got->c_t, got->rho},
                                  {exact->a_t, exact->b_t, exact->c_t, exact->rho});
    return tally;
  }
  const auto& exact = oracle.at(quantity, input);
  if (quantity == "velocities") {
    const auto got = accurate::velocities(input.alpha, input.index);
    tally.oracle_wrong = differ({got.a, got.b, got.c, got.c_prime}, exact);
  } else if (quantity == "encounters") {
    const auto got = accurate::encounters(input.alpha, input.index);
    tally.oracle_wrong = differ({got.t, got.s}, exact);
  } else if (quantity == "angle") {
    tally.oracle_wrong = differ({accurate::angle(input.alpha)}, exact);
  } else {
    const auto got = accurate::ratios(input.index);
    tally.oracle_wrong = differ({got.magic, got.deficient}, exact);
  }
  return tally;
}

}  // namespace

Tally against_oracle(const std::string& quantity, const Inputs& inputs, std::size_t every) {
  Tally tally;
  report::Oracle oracle;
  for (std::size_t i = every / 2; i < inputs.size(); i += every)
    tally += compared(quantity, inputs[i], oracle);
  return tally;
}

}  // namespace magicmass::long_run
