// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/growth.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "magicmass/counts.hpp"

namespace magicmass::report {
namespace {

constexpr int inputs_near = 8;

Scale along_n(bool quick) {
  constexpr double alpha = 1e-12;
  const std::int64_t last = count_collisions(alpha).value().N_A;
  Scale scale{"n", fmt::format("n at alpha = {}", alpha), "velocities", {}, {}};
  for (std::int64_t n = 1; n <= last; n *= quick ? 8 : 2) {
    Family family{fmt::format("n = {}", n), "", scale.quantity, {}};
    for (std::int64_t i = 0; i < inputs_near; ++i)
      if (i == 0 || n + i * n / (2 * inputs_near) > family.inputs.back().index)
        family.inputs.push_back({alpha, std::min(last, n + i * n / (2 * inputs_near))});
    scale.x.push_back(static_cast<double>(n));
    scale.families.push_back(std::move(family));
  }
  return scale;
}

Scale along_alpha(bool quick) {
  Scale scale{"alpha", "alpha at n = N_A", "velocities", {}, {}};
  for (int exponent = 0; exponent <= 30; exponent += quick ? 5 : 1) {
    const double largest = std::pow(10.0, -exponent);
    Family family{fmt::format("alpha = {}", largest), "", scale.quantity, {}};
    for (int i = 0; i < inputs_near; ++i) {
      const double alpha = largest * (1.0 - i / (2.0 * inputs_near));
      if (const auto counts = count_collisions(alpha))
        family.inputs.push_back({alpha, counts->N_A});
    }
    scale.x.push_back(largest);
    scale.families.push_back(std::move(family));
  }
  return scale;
}

void fit(Growth& growth) {
  std::vector<Point> times;
  std::vector<Point> errors;
  for (const GrowthPoint& point : growth.points) {
    times.push_back({point.x, point.ns});
    errors.push_back({point.x, point.max_ulp});
  }
  growth.time = fit_power_law(times);
  growth.error = fit_power_law(errors);
}

/// The next inputs of a long array, or all of a short one.
class Window {
public:
  Window(std::shared_ptr<const std::vector<Input>> inputs, std::size_t length)
      : inputs_(std::move(inputs)), length_(length), width_(std::min(length, widest)) {}

  std::span<const Input> next() {
    if (begin_ + width_ > length_) begin_ = 0;
    const std::span<const Input> window(inputs_->data() + begin_, width_);
    begin_ += width_;
    return window;
  }
  std::size_t width() const { return width_; }

private:
  static constexpr std::size_t widest = 4096;
  std::shared_ptr<const std::vector<Input>> inputs_;
  std::size_t length_, width_, begin_ = 0;
};

bool is_fast(const Contestant& contestant, const std::string& quantity, const Input& input) {
  constexpr double microsecond = 1e3;
  if (contestant.quantity != quantity || contestant.precision != "double" || contestant.own_clock ||
      contestant.prepare || !contestant.can(input))
    return false;
  const auto timed = on_steady_clock([&] { contestant.evaluate_all({&input, 1}); });
  timed(100);
  return timed(100) < 100 * microsecond;
}

}  // namespace

std::vector<Scale> growth_scales(bool quick) { return {along_n(quick), along_alpha(quick)}; }

std::vector<Growth> growth_along(const Scale& scale, const std::vector<Contestant>& contestants,
                                 const MeasureErrors& errors, const TimingPlan& plan) {
  const std::vector<TimeRow> times = time_families(contestants, scale.families, plan);
  std::vector<Growth> all;
  for (const Contestant& contestant : contestants) {
    if (contestant.quantity != scale.quantity) continue;
    Growth growth{contestant.name,
                  contestant.precision,
                  contestant.quantity,
                  scale.name,
                  scale.words,
                  {},
                  {},
                  {},
                  contestant.is_reproducible};
    for (std::size_t i = 0; i < scale.families.size(); ++i) {
      const Family& family = scale.families[i];
      const auto time = std::find_if(times.begin(), times.end(), [&](const TimeRow& row) {
        return row.contestant == contestant.name && row.precision == contestant.precision &&
               row.family == family.name;
      });
      if (time == times.end()) continue;
      GrowthPoint point{scale.x[i], time->ns_median};
      for (const ErrorRow& row : errors(contestant, family)) {
        if (row.samples == 0) continue;
        point.max_ulp = std::fmax(point.max_ulp, row.max_ulp);  // fmax passes over NaN
        point.over_envelope = std::fmax(point.over_envelope, row.over_envelope);
      }
      growth.points.push_back(point);
    }
    fit(growth);
    if (!growth.points.empty()) all.push_back(std::move(growth));
  }
  return all;
}

std::vector<Growth> growth_with_array_length(const std::string& quantity,
                                             const std::vector<Input>& inputs,
                                             const std::vector<Contestant>& contestants,
                                             const std::vector<std::size_t>& lengths,
                                             const Plan& plan) {
  std::vector<Growth> all;
  std::vector<Group> groups(lengths.size());
  if (inputs.empty() || lengths.empty()) return all;
  auto longest = std::make_shared<std::vector<Input>>();
  longest->reserve(*std::max_element(lengths.begin(), lengths.end()));
  while (longest->size() < longest->capacity())
    longest->push_back(inputs[longest->size() % inputs.size()]);
  for (const Contestant& contestant : contestants) {
    if (!is_fast(contestant, quantity, inputs.front()) ||
        !std::all_of(inputs.begin(), inputs.end(), contestant.can))
      continue;
    all.push_back({contestant.name,
                   contestant.precision,
                   quantity,
                   "length",
                   "length of the array of inputs",
                   {},
                   {},
                   {},
                   contestant.is_reproducible});
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const auto window = std::make_shared<Window>(longest, lengths[i]);
      groups[i].push_back(
          {on_steady_clock([&contestant, window] { contestant.evaluate_all(window->next()); }),
           static_cast<double>(window->width())});
    }
  }
  const RoundTimes times = interleaved_rounds(groups, plan);
  for (std::size_t which = 0; which < all.size(); ++which) {
    for (std::size_t i = 0; i < lengths.size(); ++i)
      if (!times[i][which].empty())
        all[which].points.push_back({static_cast<double>(lengths[i]), median(times[i][which])});
    fit(all[which]);
  }
  return all;
}

Growth growth_of_work(const std::string& contestant, const Scale& scale,
                      const std::function<void(double x)>& work, const Plan& plan) {
  std::vector<Group> groups;
  groups.reserve(scale.x.size());
  for (const double x : scale.x)
    groups.push_back({{on_steady_clock([&work, x] { work(x); }), 1.0}});
  const RoundTimes times = interleaved_rounds(groups, plan);
  Growth growth{contestant, "exact", scale.quantity, scale.name, scale.words, {}, {}, {}};
  for (std::size_t i = 0; i < scale.x.size(); ++i)
    if (!times[i][0].empty()) growth.points.push_back({scale.x[i], median(times[i][0])});
  fit(growth);
  return growth;
}

}  // namespace magicmass::report
