// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include "magicmass/encounters_exact.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/velocities_exact.hpp"
#include "report/contestants.hpp"
#include "report/make_contestant.hpp"

namespace magicmass::report {
namespace {

using cln::cl_F;
using cln::cl_I;
using cln::cl_RA;

double rounded(const cl_RA& x) { return reference::nearest<double>(x); }
double rounded(const cl_F& x) { return rounded(cln::rational(x)); }

/// Rationals grow by the length of alpha a cycle: up to a few thousand digits they take milliseconds.
bool stays_short(const Input& in) {
  constexpr std::int64_t most_bits = 4096;
  const std::int64_t length = 53 + std::labs(std::ilogb(in.alpha));
  return in.index < most_bits && 2 * (in.index + 1) * length <= most_bits;
}

double rational_ns(const Input& in) { return 4e3 * static_cast<double>(in.index + 1); }

// Ee & Lee eqs. def:psi, eq:a-final to eq:c'-final, exact:ak, exact:bk, eq:NA-ans, eq:a-terminal to eq:ct, typed by hand once more, in 50
// decimal digits.
struct Digits {
  cln::float_format_t format = cln::float_format(50);

  cl_F number(const cl_RA& x) const { return cln::cl_float(x, format); }
  cl_F number(std::int64_t n) const { return number(cl_RA(static_cast<long>(n))); }
  cl_F pi() const { return cln::pi(format); }
  cl_F psi(const cl_F& alpha) const {
    return cln::cl_float(cln::atan(cln::sqrt(alpha * (number(2) + alpha))), format) * number(2);
  }
};

generated::Velocities<double> velocities_in_digits(const Input& in) {
  const Digits in_digits;
  const cl_F alpha = in_digits.number(reference::exact(in.alpha));
  const cl_F one = in_digits.number(1);
  const cl_F two = in_digits.number(2);
  const cl_F n = in_digits.number(in.index);
  const cl_F V_CM = one / (two + alpha);
  const cl_F psi = in_digits.psi(alpha);
  const cl_F quarter = psi / in_digits.number(4);
  const cl_F cosine = cln::cos(psi / two);
  const cl_F sine = cln::sin(quarter);
  return {rounded(V_CM * (one + cln::cos(n * psi) / cosine)),
          rounded(V_CM * (one - cln::cos(n * psi + psi / two) / cosine)),
          rounded(V_CM * (one + cln::sin(n * psi - quarter) / sine)),
          rounded(V_CM * (one - cln::sin(n * psi + quarter) / sine))};
}

generated::Encounters<double> encounters_in_digits(const Input& in) {
  const Digits in_digits;
  const cl_F half =
      in_digits.psi(in_digits.number(reference::exact(in.alpha))) / in_digits.number(2);
  const cl_F below = cln::sin(in_digits.number(in.index + 1) * half);
  return {rounded(cln::sin(in_digits.number(in.index) * half) / below),
          rounded(cln::sin(half) / below)};
}

generated::Ratios<double> ratios_in_digits(const Input& in) {
  const Digits in_digits;
  const cl_F one = in_digits.number(1);
  const cl_RA k(static_cast<long>(in.index));
  const auto ratio = [&](const cl_RA& parts) {
    return rounded(one / cln::cos(in_digits.pi() / in_digits.number(parts)) - one);
  };
  return {ratio(2 * k + 1), ratio(2 * k + 2)};
}

Counts counts_in_digits(const Input& in) {
  const Digits in_digits;
  const cl_F cycles = in_digits.pi() / in_digits.psi(in_digits.number(reference::exact(in.alpha)));
  const auto whole = [&](const cl_F& x) {
    return static_cast<std::int64_t>(cln::cl_I_to_long(cln::ceiling1(x)));
  };
  return {whole(cycles - in_digits.number(cl_RA(1) / 2)), whole(cycles - in_digits.number(1))};
}

Ending<double> ending_in_digits(const Input& in) {
  const Counts counts = counts_in_digits(in);
  const Digits in_digits;
  const cl_F alpha = in_digits.number(reference::exact(in.alpha));
  const cl_F one = in_digits.number(1);
  const cl_F psi = in_digits.psi(alpha);
  const cl_F V_CM = one / (in_digits.number(2) + alpha);
  const cl_F half_turns_B = in_digits.number(cl_RA(static_cast<long>(counts.N_B)) + cl_RA(1) / 2);
  const cl_F a_t = V_CM * (one + (one + alpha) * cln::cos(in_digits.number(counts.N_A) * psi));
  const cl_F b_t = V_CM * (one - (one + alpha) * cln::cos(half_turns_B * psi));
  return {rounded(a_t), rounded(b_t), rounded((one - a_t - b_t) / alpha), counts};
}

double angle_in_digits(const Input& in) {
  const Digits in_digits;
  return rounded(in_digits.psi(in_digits.number(reference::exact(in.alpha))));
}

}  // namespace

std::vector<Contestant> rational_contestants(const std::string& quantity) {
  const auto make = [&](auto evaluate) {
    Contestant one =
        make_contestant("exact_rational", quantity, "exact, rounded", "double", evaluate);
    one.can = stays_short;
    one.expected_ns = rational_ns;
    one.ulp_bound = 0.5;
    return std::vector<Contestant>{one};
  };
  if (quantity == "velocities")
    return make([](const Input& in) -> generated::Velocities<double> {
      const auto v = generated::velocities_exact<cl_RA, cl_I>(reference::exact(in.alpha),
                                                              static_cast<long>(in.index));
      return {rounded(v.a), rounded(v.b), rounded(v.c), rounded(v.c_prime)};
    });
  if (quantity == "encounters")
    return make([](const Input& in) -> generated::Encounters<double> {
      const auto e = generated::encounters_exact<cl_RA, cl_I>(reference::exact(in.alpha),
                                                              static_cast<long>(in.index));
      return {rounded(e.t), rounded(e.s)};
    });
  return {};
}

std::vector<Contestant> digits_contestants(const std::string& quantity) {
  const auto make = [&](auto evaluate) {
    Contestant one = make_contestant("digits_50", quantity, "naive, 50 digits", "double", evaluate);
    one.expected_ns = [](const Input&) { return 1e4; };
    return std::vector<Contestant>{one};
  };
  if (quantity == "velocities") return make(velocities_in_digits);
  if (quantity == "encounters") return make(encounters_in_digits);
  if (quantity == "ratios") return make(ratios_in_digits);
  if (quantity == "counts") return make(counts_in_digits);
  if (quantity == "elastic_terminal") return make(ending_in_digits);
  if (quantity == "sequence") return {};
  return make(angle_in_digits);
}

}  // namespace magicmass::report
