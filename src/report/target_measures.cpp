// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/target_measures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/quantities.hpp"
#include "report/statistics.hpp"

namespace magicmass::report::measures {
namespace {

/// Also with another instruction set than the best: batch_fast_avx2.
bool is_named(const std::string& evaluator, const std::string& contestant) {
  return contestant == evaluator ||
         (evaluator.starts_with("batch_") && contestant.starts_with(evaluator + "_"));
}

template <class Row>
bool is_asked(const Target& target, const Row& row) {
  return (target.quantity.empty() || row.quantity == target.quantity) &&
         std::any_of(
             target.evaluators.begin(), target.evaluators.end(),
             [&](const std::string& evaluator) { return is_named(evaluator, row.contestant); });
}

bool is_easiest(const std::string& family) {
  return family == "everyday" || family == "first k" || family == "long sequences";
}

const TimeRow* easiest(const std::vector<TimeRow>& rows, const std::string& quantity,
                       const std::string& contestant) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const TimeRow& row) {
    return row.quantity == quantity && row.contestant == contestant && row.precision == "double" &&
           is_easiest(row.family);
  });
  return found == rows.end() ? nullptr : &*found;
}

std::string place(const std::string& quantity, const std::string& family) {
  return quantity + ", " + family;
}

}  // namespace

std::optional<Seen> relative_time(const Target& target, const Figures& figures) {
  std::vector<double> values;
  for (const std::vector<TimeRow>& batch : figures.batches) {
    const TimeRow* mine = easiest(batch, target.quantity, target.evaluators.front());
    const TimeRow* theirs = easiest(batch, target.quantity, target.other);
    if (mine == nullptr || theirs == nullptr) continue;
    const double ratio = mine->ratio / theirs->ratio;
    values.push_back(target.is_at_least ? 1 / ratio : ratio);
  }
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::nullopt;
  Seen seen{median(values)};
  if (const auto range = median_interval(values)) {
    seen.low = range->low;
    seen.high = range->high;
  }
  return seen;
}

std::optional<Seen> slowest_family(const Target& target, const Figures& figures) {
  std::optional<Seen> seen;
  for (const TimeRow& row : figures.times)
    if (is_asked(target, row) && !std::isnan(row.ratio) && (!seen || row.ratio > seen->value))
      seen = Seen{row.ratio, row.ratio_low, row.ratio_high, place(row.quantity, row.family)};
  return seen;
}

std::optional<Seen> fallback_share(const Target& target, const Figures& figures) {
  for (const Fallbacks& row : figures.fallbacks)
    if (is_asked(target, row) && row.asked > 0) {
      Seen seen{100.0 * static_cast<double>(row.fell_back) / static_cast<double>(row.asked)};
      seen.where = fmt::format("{} of {}, {}", row.fell_back, row.asked, row.family);
      return seen;
    }
  return std::nullopt;
}

std::optional<Seen> slowest_call(const Target& target, const Figures& figures) {
  constexpr double ns_per_ms = 1e6;
  std::optional<Seen> seen;
  for (const TimeRow& row : figures.times)
    if (is_asked(target, row) && (!seen || row.slowest_call_ns / ns_per_ms > seen->value)) {
      seen = Seen{row.slowest_call_ns / ns_per_ms};
      seen->where = place(row.quantity, row.family);
    }
  return seen;
}

std::optional<Seen> slowest_over_median(const Target& target, const Figures& figures) {
  std::optional<Seen> seen;
  for (const TimeRow& row : figures.times) {
    if (!is_asked(target, row)) continue;
    const TimeRow* usual = easiest(figures.times, row.quantity, row.contestant);
    if (usual == nullptr) continue;
    const double times = row.slowest_call_ns / usual->ns_median;
    if (seen && times <= seen->value) continue;
    seen = Seen{times};
    seen->where = place(row.quantity, row.family);
  }
  return seen;
}

std::optional<Seen> misrounded(const Target& target, const Figures& figures) {
  std::size_t wrong = 0;
  std::size_t asked = 0;
  std::string where;
  for (const ErrorRow& row : figures.errors) {
    if (!is_asked(target, row)) continue;
    asked += row.samples + row.climbed;
    wrong += row.misrounded;
    if (row.misrounded > 0 && where.empty())
      where = fmt::format(", first {} of {} in {}", row.member, row.contestant,
                          place(row.quantity, row.family));
  }
  if (asked == 0) return std::nullopt;
  Seen seen{static_cast<double>(wrong)};
  seen.where = fmt::format("of {}{}", asked, where);
  return seen;
}

std::optional<Seen> wrong_counts(const Target& target, const Figures& figures) {
  Figures counts;
  std::copy_if(figures.errors.begin(), figures.errors.end(), std::back_inserter(counts.errors),
               [](const ErrorRow& row) { return is_count(row.member); });
  return misrounded(target, counts);
}

std::optional<Seen> over_envelope(const Target& target, const Figures& figures) {
  std::optional<Seen> seen;
  for (const ErrorRow& row : figures.errors)
    if (is_asked(target, row) && row.samples > 0 && !is_count(row.member) &&
        (!seen || row.over_envelope > seen->value)) {
      seen = Seen{row.over_envelope};
      seen->where = fmt::format("{} of {} in {}", row.member, row.contestant,
                                place(row.quantity, row.family));
    }
  return seen;
}

std::optional<Seen> event_figure(const Target& target, const Figures& figures) {
  for (const EventFigure& figure : figures.events)
    if (figure.name == target.name) {
      Seen seen{figure.value};
      seen.where = figure.where;
      return seen;
    }
  return std::nullopt;
}

}  // namespace magicmass::report::measures
