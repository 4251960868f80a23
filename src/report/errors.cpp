// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/errors.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "report/evaluation.hpp"
#include "report/quantities.hpp"

namespace magicmass::report {
namespace {

using Key = std::tuple<std::uint64_t, std::int64_t, std::uint64_t>;
Key key(const Input& input) {
  return {std::bit_cast<std::uint64_t>(input.alpha), input.index,
          std::bit_cast<std::uint64_t>(input.e)};
}

/// What is climbed on: a figure of a sample, the largest in the row, and where that was.
struct Figure {
  double Deviation::*of_sample;
  double ErrorRow::*largest;
  Input ErrorRow::*where;
};

constexpr std::array<Figure, 3> figures{{
    {&Deviation::ulp, &ErrorRow::max_ulp, &ErrorRow::worst},
    {&Deviation::over_envelope, &ErrorRow::over_envelope, &ErrorRow::worst_over_envelope},
    {&Deviation::promise_eps, &ErrorRow::max_promise_eps, &ErrorRow::worst_eps},
}};

/// One member's samples, in the family's order.
struct Samples {
  ErrorRow row;
  std::vector<double> ulps;
  std::size_t correct = 0;

  /// What the climb may raise.
  void raise(const Input& input, const Deviation& d) {
    for (const Figure& figure : figures)
      if (d.*figure.of_sample > row.*figure.largest) {
        row.*figure.largest = d.*figure.of_sample;
        row.*figure.where = input;
      }
    row.max_eps = std::max(row.max_eps, d.eps);
    row.misrounded += d.correctly_rounded ? 0 : 1;
  }

  void add(const Input& input, const Deviation& d) {
    if (row.samples++ == 0)
      for (const Figure& figure : figures) row.*figure.where = input;
    raise(input, d);
    if (d.has_ulp) ulps.push_back(d.ulp);
    correct += d.correctly_rounded ? 1 : 0;
    row.wrong_signs += d.wrong_sign ? 1 : 0;
  }

  /// The smallest ulp error that a share of the samples does not exceed.
  double percentile(double share) {
    if (ulps.empty()) return 0;
    std::sort(ulps.begin(), ulps.end());
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(ulps.size())));
    return ulps[std::max<std::size_t>(rank, 1) - 1];
  }

  ErrorRow finished(const Contestant& contestant) {
    row.ulp_median = percentile(0.5);
    row.ulp_999 = percentile(0.999);
    if (row.samples > 0)
      row.correctly_rounded = static_cast<double>(correct) / static_cast<double>(row.samples);
    if (is_count(row.member)) row.wrong = row.samples - correct;
    row.promise_kept =
        row.max_ulp <= contestant.ulp_bound && row.max_promise_eps <= contestant.eps_bound;
    return row;
  }
};

double moved(double alpha, std::int64_t steps) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(alpha) + steps);
}

/// Doubles and indices next to an input, near and less near; those without a meaning are refused later on.
std::vector<Input> neighbours(const Input& at, const Contestant& contestant) {
  // a float's neighbour is 2^29 doubles away
  const std::int64_t ulp = contestant.precision == "float" ? std::int64_t{1} << 29U : 1;
  std::vector<Input> all;
  if (takes_alpha(contestant.quantity))
    for (const std::int64_t steps : {1, -1, 2, -2, 5, -5, 17, -17, 1000, -1000})
      all.push_back({moved(at.alpha, steps * ulp), at.index, at.e});
  if (!quantity_named(contestant.quantity).index().empty())
    for (const std::int64_t step : {1, -1, 2, -2, 3, -3, 10, -10})
      all.push_back({at.alpha, at.index + step, at.e});
  return all;
}

/// From the worst sample to its worst neighbour, and on from there, while it gets worse and inputs are left.
void climb(Samples& samples, std::size_t member, const Figure& figure, const Contestant& contestant,
           Oracle& oracle, std::size_t most_inputs) {
  Input from = samples.row.*figure.where;
  double height = samples.row.*figure.largest;
  std::set<Key> tried{key(from)};
  std::size_t left = most_inputs;
  for (bool is_higher = true; is_higher && std::isfinite(height);) {
    is_higher = false;
    const Input centre = from;
    for (const Input& next : neighbours(centre, contestant)) {
      if (!tried.insert(key(next)).second) continue;
      if (left == 0) return;
      const auto deviations = compared(contestant, next, oracle);
      if (!deviations || !(*deviations)[member]) continue;
      --left;
      ++samples.row.climbed;
      const Deviation& d = *(*deviations)[member];
      samples.raise(next, d);
      if (d.*figure.of_sample > height) {
        height = d.*figure.of_sample;
        from = next;
        is_higher = true;
      }
    }
  }
}

}  // namespace

std::vector<ErrorRow> measure(const Contestant& contestant, const Family& family, Oracle& oracle,
                              const Climb& limits) {
  std::vector<Samples> members;
  for (const std::string& member : quantity_named(contestant.quantity).members) {
    Samples samples;
    samples.row.contestant = contestant.name;
    samples.row.precision = contestant.precision;
    samples.row.quantity = contestant.quantity;
    samples.row.member = member;
    samples.row.family = family.name;
    members.push_back(std::move(samples));
  }
  std::set<Key> seen;  // rounding to float makes one of many
  for (const Input& input : family.inputs) {
    const Input rounded = rounded_input(input, contestant.quantity, contestant.precision);
    if (!seen.insert(key(rounded)).second) continue;
    const auto deviations = compared(contestant, rounded, oracle);
    if (!deviations) continue;
    for (std::size_t i = 0; i < members.size(); ++i)
      if ((*deviations)[i]) members[i].add(rounded, *(*deviations)[i]);
  }
  std::vector<ErrorRow> rows;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].row.samples > 0 && limits.most_inputs > 0)
      for (const Figure& figure : figures)
        climb(members[i], i, figure, contestant, oracle, limits.most_inputs);
    rows.push_back(members[i].finished(contestant));
  }
  return rows;
}

}  // namespace magicmass::report
