// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <cln/cln.h>
#include <fmt/format.h>

#include "command/demo/demo_report.hpp"
#include "command/demo/evaluator_cases.hpp"
#include "command/report/provenance.hpp"
#include "magicmass/evaluators.hpp"
#include "magicmass/reference/rational.hpp"
#include "report/rounds.hpp"
#include "report/statistics.hpp"

namespace magicmass::command {
namespace {

/// Largest errors over the cases.
struct Errors {
  double ulp = 0.0;             ///< where the exact value is not 0
  double eps = 0.0;             ///< |error| / (eps times the largest such velocity at this alpha)
  double from_simulator = 0.0;  ///< difference from the event simulator, in the same measure
  bool has_scale = false;
  bool has_simulator = false;
};

template <class Real>
void look(Errors& errors, Real got, const Expected<Real>& expected) {
  if (!expected.exists) return;
  if (!cln::zerop(expected.exact))
    errors.ulp = std::max(errors.ulp, reference::ulp_error(got, expected.exact));
  if (expected.scale == 0.0) return;
  const auto in_eps = [&](const cln::cl_RA& difference) {
    return std::abs(cln::double_approx(difference)) /
           (static_cast<double>(std::numeric_limits<Real>::epsilon()) * expected.scale);
  };
  errors.has_scale = true;
  errors.eps = std::max(errors.eps, in_eps(reference::exact(got) - expected.exact));
  if (!expected.simulated) return;
  errors.has_simulator = true;
  errors.from_simulator =
      std::max(errors.from_simulator,
               in_eps(reference::exact(got) - reference::exact(expected.from_simulator)));
}

/// Members of a result in order; the same order as the values of a case.
template <class Real>
std::vector<Real> members(const generated::Velocities<Real>& v) {
  return {v.a, v.b, v.c, v.c_prime};
}
template <class Real>
std::vector<Real> members(const generated::Encounters<Real>& e) {
  return {e.t, e.s};
}
template <class Real>
std::vector<Real> members(const generated::Ratios<Real>& r) {
  return {r.magic, r.deficient};
}
template <class Real>
std::vector<Real> members(Real psi) {
  return {psi};
}

/// Calls an evaluator as its kind wants to be called.
template <class Real, class Result>
Result call(Result (*evaluate)(Real, std::int64_t), const EvaluatorCase<Real>& one) {
  return evaluate(one.alpha, one.index);
}
template <class Real, class Result>
Result call(Result (*evaluate)(std::int64_t), const EvaluatorCase<Real>& one) {
  return evaluate(one.index);
}
template <class Real, class Result>
Result call(Result (*evaluate)(Real), const EvaluatorCase<Real>& one) {
  return evaluate(one.alpha);
}

std::string measure(bool is_there, double value) {
  if (!is_there) return "-";
  return value < 1000.0 ? fmt::format("{:.2f}", value) : fmt::format("{:.1e}", value);
}

std::string row(std::string_view name, const Errors& errors, const std::string& timing,
                std::string_view verdict) {
  return fmt::format("  {:<19}{:>9}{:>9}{:>9}{}{:>8}\n", name, measure(true, errors.ulp),
                     measure(errors.has_scale, errors.eps),
                     measure(errors.has_simulator, errors.from_simulator), timing, verdict);
}

const report::Plan timing_plan{.rounds = 31, .shortest_ns = 2e5};

/// Median, least and largest time, and the median ratio to the baseline, round by round.
std::string timing_cells(const std::vector<double>& mine, const std::vector<double>& baseline) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < mine.size(); ++round)
    ratios.push_back(mine[round] / baseline[round]);
  const auto [shortest, longest] = std::minmax_element(mine.begin(), mine.end());
  return fmt::format("{:>7.0f}{:>10}{:>7.2f}", report::median(mine),
                     fmt::format("{:.0f}..{:.0f}", *shortest, *longest), report::median(ratios));
}

/// Every evaluator of one table on these cases; the closed form is the timing's baseline.
template <class Real, class Evaluators>
void show_kind(DemoReport& report, const Evaluators& evaluators,
               const std::vector<EvaluatorCase<Real>>& cases, bool is_promised = true) {
  report::Group works;
  std::vector<Errors> all_errors;
  std::size_t baseline = 0;
  for (const auto& evaluator : evaluators) {
    if (std::string_view(evaluator.form) == "closed") baseline = works.size();
    Errors errors;
    for (const EvaluatorCase<Real>& one : cases) {
      const std::vector<Real> got = members<Real>(call(evaluator.evaluate, one));
      for (std::size_t i = 0; i < got.size(); ++i) look(errors, got[i], one.values[i]);
    }
    all_errors.push_back(errors);
    const auto work = [&cases, evaluate = evaluator.evaluate] {
      for (const EvaluatorCase<Real>& one : cases) {
        const auto result = call(evaluate, one);
        asm volatile("" : : "m"(result) : "memory");  // the result counts as used
      }
    };
    works.push_back({report::on_steady_clock(work), static_cast<double>(cases.size())});
  }
  const auto times = report::interleaved_rounds({works}, timing_plan).front();
  for (std::size_t i = 0; i < works.size(); ++i) {
    const std::string timing = timing_cells(times[i], times[baseline]);
    const auto& evaluator = evaluators[i];
    const bool has_bound =
        evaluator.ulp_bound != generated::no_bound || evaluator.eps_bound != generated::no_bound;
    const bool kept = !is_promised || (all_errors[i].ulp <= evaluator.ulp_bound &&
                                       all_errors[i].eps <= evaluator.eps_bound);
    report.count_in(kept);
    report.print(row(evaluator.name, all_errors[i], timing,
                     !kept                      ? "BROKEN"
                     : is_promised && has_bound ? "kept"
                                                : "-"));
  }
}

/// The event loop itself, measured like an evaluator.
template <class Real>
void show_simulator(DemoReport& report, const std::vector<EvaluatorCase<Real>>& cases) {
  Errors errors;
  for (const EvaluatorCase<Real>& one : cases)
    for (const Expected<Real>& expected : one.values)
      if (expected.simulated) look(errors, expected.from_simulator, expected);
  errors.has_simulator = false;
  report.print(row("(event simulator)", errors, std::string(24, ' '), "-"));
}

template <class Real>
void show_number_type(DemoReport& report, std::string_view name) {
  report.print(fmt::format("{}\n", name));
  const auto velocities = velocity_cases<Real>(AlphaRange::up_to_1);
  show_kind<Real>(report, generated::velocity_evaluators<Real>(), velocities);
  show_simulator(report, velocities);
  const auto encounters = encounter_cases<Real>();
  show_kind<Real>(report, generated::encounter_evaluators<Real>(), encounters);
  show_simulator(report, encounters);
  show_kind<Real>(report, generated::ratio_evaluators<Real>(), ratio_cases<Real>());
  show_kind<Real>(report, generated::angle_evaluators<Real>(), angle_cases<Real>());
}

}  // namespace

void show_evaluators(DemoReport& report) {
  report.heading("Generated evaluators against exact rationals and the simulator");
  report.print(fmt::format("{}; {} interleaved rounds.\n", processor_name(), timing_plan.rounds));
  report.print(
      "Fixed cases: alpha from 1e-6 to 1, n from 0 to the last collision.\n"
      "ulp: largest error where the exact value is not 0. eps: largest error over eps\n"
      "times the largest value of that body at that alpha (times, distances: the value\n"
      "itself). sim: difference from the event simulator in the same unit. ns: median,\n"
      "then shortest..longest; ratio: to the closed form, round by round. promise: the\n"
      "error bound that the generated header states.\n");
  report.print(fmt::format("  {:<19}{:>9}{:>9}{:>9}{:>7}{:>10}{:>7}{:>8}\n", "evaluator", "ulp",
                           "eps", "sim", "ns", "min..max", "ratio", "promise"));
  show_number_type<double>(report, "double");
  show_number_type<float>(report, "float");
  show_number_type<long double>(report, "long double");
  report.print(
      "double, a ball heavier than the blocks (alpha = 10, 1000, 1e6: beyond the paper)\n");
  const auto heavy = velocity_cases<double>(AlphaRange::above_1);
  show_kind<double>(report, generated::velocity_evaluators<double>(), heavy, false);
  show_simulator(report, heavy);
  const ExactAgreement exact = exact_agreement();
  report.check(
      fmt::format("exact forms = reference = event simulator in rationals: {} of {} collisions",
                  exact.agreeing, exact.cases),
      exact.agreeing == exact.cases);
}

}  // namespace magicmass::command
