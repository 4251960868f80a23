// SPDX-License-Identifier: MIT
// Behind the last rounding test: the generated evaluators on MPFR's numbers, with more and more
// bits until every rounding and sign is certain. Why that ends: what is no double and no tie is
// settled by enough bits; of each output none is a dyadic number p/2^q, or it is computed exactly:
//  Velocities, n >= 1. With u = 1/(1 + alpha) a collision multiplies by 2u - 1, 2u, 2 - 2u and
//   1 - 2u. Its part with u maps A's and C's velocities to 2(a - c)(1, 1), so that after j
//   collisions the velocities of the two that collided are polynomials in u with whole
//   coefficients, the last of which is +-2^j u^j. Where m, the numerator of 1 + alpha, has an odd
//   prime factor q, that term has the highest power of q in its denominator, alone: the sum is no
//   dyadic number, and not 0. Its square, rho, neither. alpha < 1: 1 + alpha = m/2^k > 1 is less
//   than 2, so m is odd and above 1. alpha >= 1 without an odd prime: 1 + alpha = 2^j, j <= 53, and
//   the few operations on such u (N_A = N_B = 1) are exact in 190 bits: is_exact, nothing is in
//   doubt, ties included.
//  Counts: alpha_k and beta_k are 1/cos - 1 of rational multiples of pi. By Niven's theorem cos is
//   rational for alpha_1 = 1 alone (2 cos is one of 0, +-1, +-2), and alpha >= 1 is not counted.
//   For the same reason no ratio but alpha_1, and no distance to another, is rational.
//  Collisions: t_j = U_(j-1)/U_j and s_j = 1/U_j at u, with U_j = sin((j + 1) h)/sin(h), h = psi/2.
//   For j = 1 both are (1 + alpha)/2, which two doubles hold; MPFR has alpha below 2^-300 or above
//   2^300 there, and no tie. For j >= 2, alpha < 1 and 1 + alpha = p/2^m, p odd, p >= 3, m >= 1.
//   U_j is a polynomial in 2u = Y/p, Y = 2^(m+1), with whole coefficients, the first is 1: N_j =
//   p^j U_j is an integer that shares no factor with p; s_j = p^j/N_j, t_j = p N_(j-1)/N_j. As
//   N_j^2 - N_(j-1) N_(j+1) = p^(2j), N_j and N_(j-1) share none. So where t_j or s_j is dyadic,
//   N_j is +-2^i. Let j + 1 = 2^a r, r odd; by U_(2k-1) = 2 T_k U_(k-1), N_j is N_(r-1) times
//   p^k 2 T_k(u) for k = r, 2r, ..., 2^(a-1) r, all of them integers.
//   r = 2k + 1 >= 3: N_2k = (N_k + p N_(k-1)) (N_k - p N_(k-1)) is odd, as U_2k ends in +-1 and Y
//   is even; so both factors are +-1, and p >= 3 leaves N_(k-1) = 0; but 0 < k h < pi for k <= j.
//   r = 1, a >= 2: p^2 2 T_2 = Y^2 - 2 p^2 = 2 (2^(2m+1) - p^2) is +- a power of 2, and 2^(2m+1) -
//   p^2 is odd, so 2^(2m+1) = p^2 +- 1: p^2 + 1 is 2 mod 8, and (p - 1)(p + 1) such a power for
//   p = 3 alone: alpha = 1/2, where only j <= 2 take place.
//  Collapse: t is a zero of a quadratic, which the middle of two doubles may be, too: it is tried.
//   Just where collisions begin to end t is rational: a quotient of numbers of some 1100 bits.
//   v = w/D and rho = w/D^2, D = 1 + w (1 + m). With w = o/2^q and D = N/2^r, o and N odd, they are
//   dyadic only where N divides o, and have no more bits than o, 53: between doubles they are if
//   subnormal. But o (1 + m)/2^q = N/2^r - 1 gives the lowest bit of 1 + m, and m has 53: for each
//   sign of q and r that leaves w and m below 2^160, w above 2^-160, so v and rho above 2^-700.
//  psi: cos(psi/2) = u is rational, so psi is transcendental (Lindemann).

#include <bit>

#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/numbers/ladder.hpp"
#include "magicmass/numbers/results.hpp"
#include "magicmass/numbers/until_certain.hpp"

namespace magicmass::numbers {
namespace {
using generated::Ziv;

/// Runs one case.
template <class Case>
double run(Case& k) {
  k.stage_1();
  k.stage_2();
  k.stage_3();
  return k.doubt;
}
/// The doubt that is left.
template <class Q>
double attempt(const typename Q::Inputs& in, typename Q::Outputs& out) {
  return Q::template visit<true>(in, [&]<template <class, class> class Case>() {
    Case<Ziv, MpfrFloat> k(in);
    const double doubt = run(k);
    out = k.outputs();
    return doubt;
  });
}
template <class Q, class Result, class X, class... In>
bool settle(Result& result, const char* what, bool is_exact, X x, In... in) {
  typename Q::Outputs out{};
  until_certain(what, double(x), is_exact, [&] { return attempt<Q>({x, in...}, out); });
  set(result, out);
  return true;
}
/// Whether 1 + alpha is a power of 2, alpha >= 1.
bool has_dyadic_velocities(double alpha) {
  int exponent = 0;
  return alpha >= 1.0 && (alpha + 1.0) - 1.0 == alpha && std::frexp(alpha + 1.0, &exponent) == 0.5;
}
/// The emitted bound is relative, and so is what the quotient and the difference add to it.
template <class Case>
double distance(double alpha, std::int64_t k, MpfrFloat Case::*threshold) {
  double result = 0.0;
  until_certain("the distance to a threshold", alpha, false, [&] {
    Case ratio({k});
    run(ratio);
    const MpfrFloat share = quotient(MpfrFloat(alpha), ratio.*threshold);
    const auto tested =
        rounding_test(share - MpfrFloat(1.0), MpfrFloat::magnitude_of(share) * (Case::E[0] + 1.0));
    result = tested.value;
    return tested.doubt;
  });
  return result;
}
/// Where pi/h = m >= 3: alpha_k for m = 2k + 1, beta_k for m = 2k + 2.
Threshold threshold_at(double alpha, std::int64_t m) {
  const std::int64_t k = (m - 1) / 2;
  if (m == 3) return {true, 1, alpha - 1.0};
  if (m % 2 == 1)
    return {true, k, distance(alpha, k, &generated::MagicGeneral<Ziv, MpfrFloat>::of_alpha_)};
  return {false, k, distance(alpha, k, &generated::DeficientGeneral<Ziv, MpfrFloat>::of_beta_)};
}
}  // namespace

bool velocities_by_mpfr(Velocities& result, double alpha, std::int64_t n) {
  return settle<generated::Velocities>(result, "velocities", has_dyadic_velocities(alpha), alpha,
                                       n);
}
bool terminal_by_mpfr(Terminal& result, double alpha) {
  return settle<generated::Terminal>(result, "terminal", has_dyadic_velocities(alpha), alpha);
}
/// Signs first: of polynomials, exact in the last precision. pi/h is a whole number only where the
/// cosine of h, whose square is rational, is that of pi/3, pi/4 or pi/6 (Niven). At pi/3 two
/// collisions are all. At the others the next M_C has the same counts, at most two envelopes off.
bool restitution_by_mpfr(Terminal& result, Masses masses, double e) {
  const AllExponents here;
  MpfrFloat::bits = last_bits;
  double& M_C = masses.ball;
  const double w_B = masses.per_B;
  const auto two = generated::two_collisions_exact<MpfrFloat>(M_C, w_B, e);
  if (!two.ends.is_positive()) return false;
  if (!(-two.two).is_positive()) {
    result = {
        {1, 1}, rounded(two.a_two), rounded(two.b_two), rounded(two.c_two), rounded(two.rho_two)};
    return true;
  }
  for (const MpfrFloat& tie : {two.four, two.six})
    if (tie.is_zero()) M_C = std::nextafter(M_C, 1.0 / 0.0);
  bool has_case = false;
  const auto attempt = [&]<template <class, class> class Case>() {
    Case<Ziv, MpfrFloat> k({M_C, w_B, e});
    const double doubt = run(k);
    if (is_above(0x1p-80, k.share_e) || is_above(0x1p-124, k.z_e))
      throw Undecided("restitution: too near to inelastic collapse, or above some 2^62 collisions");
    set(result, k.outputs());
    has_case = true;
    return doubt;
  };
  until_certain("terminal velocities with restitution", M_C, false, [&] {
    const double doubt = generated::Restitution::visit<true>({M_C, w_B, e}, attempt);
    if (!has_case) throw Undecided("restitution: more than two collisions of masses so unequal");
    return doubt;
  });
  return true;
}
bool collapse_by_mpfr(Collapse& result, const Masses& masses, double e) {
  const AllExponents here;
  MpfrFloat::bits = last_bits;
  const double M_C = masses.ball, w_B = masses.per_B;
  const MpfrFloat ends = generated::two_collisions_exact<MpfrFloat>(M_C, w_B, e).ends;
  if (ends.is_positive()) return false;
  std::optional<double> t;  // where no rounding test would find it; v and rho know nothing of e
  if (ends.is_zero()) t = rounded(generated::closing_exact<MpfrFloat>(M_C, w_B, e, ends).edge_e);
  generated::CollapseOutputs near{};
  attempt<generated::Collapse>({M_C, w_B, e}, near);
  for (const double to : {0.0, DBL_MAX}) {
    const double one = near.t_end, other = std::nextafter(one, to);
    const MpfrFloat middle = scaled(MpfrFloat(one) + MpfrFloat(other), 0.5);
    if (generated::closing_exact<MpfrFloat>(M_C, w_B, e, middle).closing_e.is_zero())
      t = std::bit_cast<std::uint64_t>(one) % 2 == 0 ? one : other;
  }
  settle<generated::Collapse>(result, "collapse", false, M_C, w_B, t ? std::nextafter(e, 0.0) : e);
  if (t) result.t = *t;
  return true;
}
bool collision_by_mpfr(Collision& result, double alpha, std::int64_t j) {
  return settle<generated::Collision>(result, "a collision", false, alpha, j);
}
bool angle_by_mpfr(double& result, double alpha) {
  return settle<generated::Angle>(result, "angle", false, alpha);
}
bool magic_by_mpfr(double& result, std::int64_t k) {
  return settle<generated::Magic>(result, "magic", false, k);
}
bool deficient_by_mpfr(double& result, std::int64_t k) {
  return settle<generated::Deficient>(result, "deficient", false, k);
}
}  // namespace magicmass::numbers

std::optional<magicmass::Threshold> magicmass::nearest_threshold(double alpha) {
  const std::optional<Counts> counts = count_collisions(alpha);
  if (!counts) return std::nullopt;
  // N_A + N_B = ceil(pi/h) - 1: collision N takes place, the next does not.
  const std::int64_t N = counts->N_A + counts->N_B;
  if (N < 3) return numbers::threshold_at(alpha, 3);
  const Threshold above = numbers::threshold_at(alpha, N);
  if (N == INT64_MAX) return above;
  const Threshold below = numbers::threshold_at(alpha, N + 1);
  return std::fabs(above.distance) < std::fabs(below.distance) ? above : below;
}
