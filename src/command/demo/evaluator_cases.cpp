// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/demo/evaluator_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <cln/cln.h>

#include "magicmass/encounters_exact.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/simulator/three_body.hpp"
#include "magicmass/velocities_exact.hpp"

namespace magicmass::command {
namespace {

using cln::cl_I;
using cln::cl_RA;

constexpr std::array<double, 12> alphas = {1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.05,
                                           0.1,  0.12, 0.25, 0.5,  0.75, 1.0};
constexpr std::array<double, 3> alphas_above_1 = {10.0, 1000.0, 1e6};
constexpr double smallest_alpha_stepped_exactly = 0.01;  // rationals grow with every collision

/// Up to 12 whole numbers from 0 to last, the ends among them.
std::vector<std::int64_t> spread(std::int64_t last) {
  constexpr std::int64_t most = 11;
  std::vector<std::int64_t> numbers;
  const std::int64_t steps = std::min(most, last);
  for (std::int64_t i = 0; i <= steps; ++i) numbers.push_back(steps == 0 ? 0 : last * i / steps);
  return numbers;
}

/// The largest exact velocity of A, of B, and of C, for which c and c' count alike.
template <class Real>
void scale_by_largest(std::vector<EvaluatorCase<Real>>& cases, std::size_t begin) {
  constexpr std::array<std::size_t, 4> body = {0, 1, 2, 2};
  std::array<double, 3> largest = {};
  const auto each = [&](const auto& visit) {
    for (std::size_t i = begin; i < cases.size(); ++i)
      for (std::size_t member = 0; member < body.size(); ++member)
        visit(cases[i].values[member], largest[body[member]]);
  };
  each([](const Expected<Real>& expected, double& of_body) {
    of_body = std::max(of_body, std::abs(cln::double_approx(expected.exact)));
  });
  each([](Expected<Real>& expected, double of_body) { expected.scale = of_body; });
}

/// Puts the simulator's velocities beside the exact ones: a_n and c_n come with P_n, b_n and c'_n with Q_n.
template <class Real>
void add_simulated(std::vector<EvaluatorCase<Real>>& cases, std::size_t begin,
                   const RecordedRun<Real>& recorded) {
  for (const Event<Real>& event : recorded.events)
    for (std::size_t i = begin; i < cases.size(); ++i) {
      if (cases[i].index != event.n) continue;
      const bool with_A = event.body == Body::A;
      const auto set = [&](std::size_t member, Real value) {
        cases[i].values[member].simulated = true;
        cases[i].values[member].from_simulator = value;
      };
      set(with_A ? 0 : 1, with_A ? event.after.a : event.after.b);
      set(with_A ? 2 : 3, event.after.c);
    }
}

cl_RA exact_psi(const cl_RA& alpha) {
  const cln::cl_R size = cln::sqrt(cln::cl_float(alpha * (2 + alpha), cln::float_format(80)));
  return cln::rational(2 * cln::atan(size));
}

}  // namespace

template <class Real>
std::vector<EvaluatorCase<Real>> velocity_cases(AlphaRange range) {
  std::vector<EvaluatorCase<Real>> cases;
  const std::span<const double> values =
      range == AlphaRange::up_to_1 ? std::span<const double>(alphas) : alphas_above_1;
  for (const double value : values) {
    const auto alpha = static_cast<Real>(value);
    const cl_RA exact_alpha = reference::exact(alpha);
    const reference::LargeCounts counts = reference::count_collisions(exact_alpha);
    const std::size_t begin = cases.size();
    for (const std::int64_t n : spread(cln::cl_I_to_long(counts.N_A))) {
      const auto v = reference::exact_velocities(exact_alpha, n);
      const bool has_Q = cl_I(n) <= counts.N_B;
      cases.push_back({alpha, n, {{v.a}, {v.b, 0, has_Q}, {v.c}, {v.c_prime, 0, has_Q}}});
    }
    scale_by_largest(cases, begin);
    add_simulated(cases, begin, record_three_body(alpha));
  }
  return cases;
}

template <class Real>
std::vector<EvaluatorCase<Real>> encounter_cases() {
  std::vector<EvaluatorCase<Real>> cases;
  for (const double value : alphas) {
    if (value < smallest_alpha_stepped_exactly) continue;
    const auto alpha = static_cast<Real>(value);
    const auto exact = record_three_body(reference::exact(alpha)).events;
    const auto stepped = record_three_body(alpha).events;
    for (std::size_t j = 0; j < exact.size(); ++j) {
      EvaluatorCase<Real> one{alpha,
                              static_cast<std::int64_t>(j),
                              {{exact[j].time}, {exact[j].positions.b - exact[j].positions.a}}};
      if (j < stepped.size()) {
        one.values[0].simulated = one.values[1].simulated = true;
        one.values[0].from_simulator = stepped[j].time;
        one.values[1].from_simulator = stepped[j].positions.b - stepped[j].positions.a;
      }
      for (Expected<Real>& expected : one.values)
        expected.scale = std::abs(cln::double_approx(expected.exact));
      cases.push_back(one);
    }
  }
  return cases;
}

template <class Real>
std::vector<EvaluatorCase<Real>> ratio_cases() {
  constexpr std::array<std::int64_t, 16> indices = {1, 2,  3,  4,   5,    6,     7,      8,
                                                    9, 10, 20, 100, 1000, 10000, 100000, 1000000};
  std::vector<EvaluatorCase<Real>> cases;
  cases.reserve(indices.size());
  constexpr long bits = 200;
  for (const std::int64_t k : indices)
    cases.push_back({0,
                     k,
                     {{reference::ratio_within(Magic{k}, bits)},
                      {reference::ratio_within(Deficient{k}, bits)}}});
  return cases;
}

template <class Real>
std::vector<EvaluatorCase<Real>> angle_cases() {
  std::vector<EvaluatorCase<Real>> cases;
  for (int exponent = -12; exponent <= 12; ++exponent) {
    const auto alpha = static_cast<Real>(1.25 * std::pow(10.0, exponent));
    cases.push_back({alpha, 0, {{exact_psi(reference::exact(alpha))}}});
  }
  return cases;
}

ExactAgreement exact_agreement() {
  ExactAgreement agreement;
  for (const double value : alphas) {
    if (value < smallest_alpha_stepped_exactly) continue;
    const cl_RA alpha = reference::exact(value);
    cl_I j(0);
    for (const Event<cl_RA>& event : record_three_body(alpha).events) {
      const auto ours = generated::velocities_exact<cl_RA, cl_I>(alpha, event.n);
      const auto reference = reference::exact_velocities(alpha, event.n);
      const auto encounter = generated::encounters_exact<cl_RA, cl_I>(alpha, j);
      const bool with_A = event.body == Body::A;
      const cl_RA block = with_A ? event.after.a : event.after.b;
      const bool same =
          block == (with_A ? ours.a : ours.b) && block == (with_A ? reference.a : reference.b) &&
          event.after.c == (with_A ? ours.c : ours.c_prime) &&
          event.after.c == (with_A ? reference.c : reference.c_prime) &&
          event.time == encounter.t && event.positions.b - event.positions.a == encounter.s;
      ++agreement.cases;
      agreement.agreeing += same ? 1 : 0;
      j = j + 1;
    }
  }
  return agreement;
}

template std::vector<EvaluatorCase<float>> velocity_cases(AlphaRange);
template std::vector<EvaluatorCase<double>> velocity_cases(AlphaRange);
template std::vector<EvaluatorCase<long double>> velocity_cases(AlphaRange);
template std::vector<EvaluatorCase<float>> encounter_cases();
template std::vector<EvaluatorCase<double>> encounter_cases();
template std::vector<EvaluatorCase<long double>> encounter_cases();
template std::vector<EvaluatorCase<float>> ratio_cases();
template std::vector<EvaluatorCase<double>> ratio_cases();
template std::vector<EvaluatorCase<long double>> ratio_cases();
template std::vector<EvaluatorCase<float>> angle_cases();
template std::vector<EvaluatorCase<double>> angle_cases();
template std::vector<EvaluatorCase<long double>> angle_cases();

}  // namespace magicmass::command
