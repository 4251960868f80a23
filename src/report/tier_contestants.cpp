// SPDX-License-Identifier: GPL-2.0-or-later
#include <limits>
#include <optional>
#include <utility>

#include "magicmass/accurate.hpp"
#include "magicmass/counts.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/tiers/first_stages.hpp"
#include "report/contestants.hpp"
#include "report/make_contestant.hpp"
#include "report/quantities.hpp"

namespace magicmass::report {
namespace {

/// Nothing where the counts do not fit: such an input is not asked for.
Ending<double> ending(const std::optional<Terminal>& found) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!found) return {none, none, none, {-1, -1}};
  return {found->a_t, found->b_t, found->c_t, found->counts};
}

template <class Evaluate>
Contestant fast_tier(const std::string& quantity, Evaluate evaluate) {
  return make_contestant("fast", quantity, "tier fast", "double", evaluate);
}

/// falls_back: did the first stages fail?
template <class Evaluate, class FallsBack>
Contestant accurate_tier(const std::string& quantity, Evaluate evaluate, FallsBack falls_back) {
  Contestant one = make_contestant("accurate", quantity, "tier accurate", "double", evaluate);
  one.ulp_bound = 0.5;
  one.falls_back = falls_back;
  one.expected_ns = [falls_back](const Input& in) { return falls_back(in) ? 5e3 : 100.0; };
  return one;
}

template <class Result>
bool falls_back(double alpha, std::int64_t index) {
  Result result;
  return !tiers::first_stages(alpha, index, result);
}

}  // namespace

std::vector<Contestant> tier_contestants(const std::string& quantity) {
  const auto both = [&](auto of_fast, auto of_accurate, auto falls_back) {
    return std::vector<Contestant>{fast_tier(quantity, of_fast),
                                   accurate_tier(quantity, of_accurate, falls_back)};
  };
  if (quantity == "velocities")
    return both([](const Input& in) { return fast::velocities(in.alpha, in.index); },
                [](const Input& in) { return accurate::velocities(in.alpha, in.index); },
                [](const Input& in) {
                  return falls_back<generated::Velocities<double>>(in.alpha, in.index);
                });
  if (quantity == "encounters")
    return both([](const Input& in) { return fast::encounters(in.alpha, in.index); },
                [](const Input& in) { return accurate::encounters(in.alpha, in.index); },
                [](const Input& in) {
                  return falls_back<generated::Encounters<double>>(in.alpha, in.index);
                });
  if (quantity == "angle")
    return both([](const Input& in) { return fast::angle(in.alpha); },
                [](const Input& in) { return accurate::angle(in.alpha); },
                [](const Input& in) {
                  double psi;
                  return !tiers::first_stages(in.alpha, psi);
                });
  if (quantity == "ratios")
    return both([](const Input& in) { return fast::ratios(in.index); },
                [](const Input& in) { return accurate::ratios(in.index); },
                [](const Input& in) {
                  generated::Ratios<double> result;
                  return !tiers::first_stages(in.index, result);
                });
  if (quantity == "elastic_terminal")
    return both([](const Input& in) { return ending(fast::terminal(in.alpha)); },
                [](const Input& in) { return ending(accurate::terminal(in.alpha)); },
                [](const Input& in) {
                  const std::optional<Counts> counts = count_collisions(in.alpha);
                  generated::TerminalValues<double> result;
                  return counts && !tiers::first_stages(in.alpha, *counts, result);
                });
  return {};
}

}  // namespace magicmass::report
