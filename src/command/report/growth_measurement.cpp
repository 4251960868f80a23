// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/growth_measurement.hpp"

#include <iterator>

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/velocities_exact.hpp"
#include "report/errors.hpp"

namespace magicmass::command {
namespace {

/// Everyday velocities, all of which every evaluator can do.
std::vector<report::Input> everyday_inputs() {
  std::vector<report::Input> inputs;
  for (int i = 0; i < 64; ++i) inputs.push_back({0.01 + i / 128.0, 1 + i % 3});
  return inputs;
}

std::vector<std::size_t> array_lengths(bool quick) {
  std::vector<std::size_t> lengths;
  const std::size_t longest = std::size_t{1} << (quick ? 18U : 24U);  // 16 bytes each
  for (std::size_t length = 64; length <= longest; length *= 8) lengths.push_back(length);
  return lengths;
}

report::Growth growth_with_digits(bool quick, const report::Plan& plan) {
  report::Scale scale{"digits", "digits asked for, alpha = 1e-12, n = 1000", "velocities", {}, {}};
  for (const double digits : {10, 30, 100, 300, 1000, 3000, 10000})
    if (!quick || digits <= 1000) scale.x.push_back(digits);
  return report::growth_of_work(
      "certified_digits", scale,
      [](double digits) {
        reference::certified_digits(MassRatio(1e-12), 1000, static_cast<int>(digits));
      },
      plan);
}

/// The exact tier's rational numbers: digits grow with n, and the time with them.
report::Growth rationals_with_n(bool quick, const report::Plan& plan) {
  const double alpha = 0.3;  // all of 52 fraction bits
  report::Scale scale{"n", "n, exact rationals at alpha = 0.3", "velocities", {}, {}};
  for (double n = 1; n <= (quick ? 256 : 4096); n *= 2) scale.x.push_back(n);
  return report::growth_of_work(
      "velocities_exact", scale,
      [alpha](double n) {
        generated::velocities_exact<cln::cl_RA, cln::cl_I>(reference::exact(alpha),
                                                           static_cast<long>(n));
      },
      plan);
}

}  // namespace

void measure_growth(const std::vector<report::Contestant>& contestants, bool quick,
                    report::Oracle& oracle, report::TimingPlan plan, Progress& progress,
                    std::vector<report::Growth>& growths) {
  if (contestants.empty() || contestants.front().quantity != "velocities") return;
  std::string words;
  plan.rounds.go_on = [&](double done) { return progress.step(words, done); };
  const auto add = [&](std::vector<report::Growth> more) {
    growths.insert(growths.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
  };
  for (const report::Scale& scale : report::growth_scales(quick)) {
    words = "growth: against " + scale.words;
    add(report::growth_along(
        scale, contestants,
        [&](const report::Contestant& contestant, const report::Family& family) {
          if (!progress.step(words, 1.0)) return std::vector<report::ErrorRow>();
          return report::measure(contestant, family, oracle, report::Climb{0});
        },
        plan));
  }
  words = "growth: against the length of the array";
  if (progress.step(words, 0.0))
    add(report::growth_with_array_length("velocities", everyday_inputs(), contestants,
                                         array_lengths(quick), plan.rounds));
  words = "growth: against digits";
  if (progress.step(words, 0.0)) add({growth_with_digits(quick, plan.rounds)});
  words = "growth: exact rationals against n";
  if (progress.step(words, 0.0)) add({rationals_with_n(quick, plan.rounds)});
  std::erase_if(growths, [](const report::Growth& growth) { return growth.points.empty(); });
}

}  // namespace magicmass::command
