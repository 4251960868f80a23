// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. No function of the standard library here: the linker
// might keep this target's copy of an inline one for all.
#include "magicmass/numbers/kernels.hpp"
#include "magicmass/numbers/results.hpp"

namespace magicmass::numbers {
inline namespace MAGICMASS_TARGET {
using arithmetic::DoubleDouble, arithmetic::lanes, arithmetic::Simd, arithmetic::SimdMask;

/// 0 where n <= N_A for certain: N_A = ceil(pi/(2 h) - 1/2) says that n h - h/2 < pi/2. The limit
/// is 2^-41 below that; low parts and errors of both terms are below 2^-46.
template <class T>
[[gnu::always_inline]] inline T doubt_of_cycle(const DoubleDouble<T>& phase,
                                               const DoubleDouble<T>& half_h) {
  const T limit = arithmetic::all<T>(0x1.921fb54442p0);
  return arithmetic::select(arithmetic::is_above(limit, phase.high - half_h.high), T{},
                            arithmetic::all<T>(1.0));
}
/// The doubt that is left.
template <class Case>
[[gnu::always_inline]] inline auto doubt_of(const Case& k) {
  if constexpr (requires { k.phase; }) {
    return k.doubt + doubt_of_cycle(k.phase, k.half_h);
  } else {
    return k.doubt;
  }
}
template <class Q, class Tier>
[[gnu::always_inline]] inline double attempt(const typename Q::Inputs& in,
                                             typename Q::Outputs& out) {
  return Q::template visit<false>(
      in, [&]<template <class, class> class Case>() __attribute__((always_inline)) {
        Case<Tier, DoubleDouble<double>> k(in);
        k.stage_1();
        k.stage_2();
        k.stage_3();
        out = k.outputs();
        return doubt_of(k);
      });
}

template <class Q, class Tier, class Result, class... In>
bool single(Result& result, In... in) {
  typename Q::Outputs out{};
  const double doubt = attempt<Q, Tier>({in...}, out);
  set(result, out);
  return doubt == 0.0;
}
/// What is in doubt is counts, not roundings: up to the last sums, which lose 2^-96 of the largest
/// velocity, the losses are those of inputs that are off by less than 2^-90. share_e, h and h N
/// lose a few 2^-98 of loss_e, h and h N; a change of M_C changes each at least half as much,
/// relatively. The power loses less than N 2^-100; a change of e changes it by N/2 as much.
bool restitution(Terminal& result, const Masses& masses, double e) {
  return single<generated::Restitution, generated::Slow>(result, masses.ball, masses.per_B, e);
}
bool collapse(Collapse& result, const Masses& masses, double e) {
  return single<generated::Collapse, generated::Accurate>(result, masses.ball, masses.per_B, e);
}

/// Full registers through the main case, a stage at a time for some; what is left, one by one.
template <class Q, class Tier>
[[gnu::always_inline]] inline std::size_t rows_of(std::size_t size,
                                                  const typename Q::Columns& columns, Open& open) {
  constexpr std::size_t width = lanes, most = 64 / width;
  std::size_t left = 0, i = 0;
  while (i + width <= size) {
    const std::size_t fit = (size - i) / width;
    const std::size_t registers = fit < most ? fit : most;
    typename Q::template Main<Tier, DoubleDouble<Simd>> k[most];
    SimdMask is_in_case[most];
    for (std::size_t g = 0; g < registers; ++g) {
      is_in_case[g] = k[g].load_inputs(columns, i + g * width);
      k[g].stage_1();
    }
    for (std::size_t g = 0; g < registers; ++g) k[g].stage_2();
    for (std::size_t g = 0; g < registers; ++g) k[g].stage_3();
    for (std::size_t g = 0; g < registers; ++g, i += width) {
      columns.set(i, k[g]);
      const SimdMask is_open = ~(is_in_case[g] & (doubt_of(k[g]) == 0.0));
      std::int64_t any = 0;
      for (int lane = 0; lane < lanes; ++lane) any |= is_open[lane];
      if (any == 0) [[likely]]
        continue;
      for (std::size_t lane = 0; lane < width; ++lane) {
        open[left] = static_cast<std::uint16_t>(i + lane);
        left += is_open[int(lane)] != 0 ? 1 : 0;
      }
    }
  }
  for (; i < size; ++i) {
    typename Q::Outputs out{};
    const double doubt = attempt<Q, Tier>(columns.get(i), out);
    columns.set(i, out);
    open[left] = static_cast<std::uint16_t>(i);
    left += doubt == 0.0 ? 0 : 1;
  }
  return left;
}
template <class Tier>
std::size_t velocity_rows(std::size_t size, const VelocityRows& r, Open& open) {
  return rows_of<generated::Velocities, Tier>(size, {r.alpha, r.n, r.a, r.b, r.c, r.c_prime}, open);
}
template <class Tier>
std::size_t terminal_rows(std::size_t size, const TerminalRows& r, Open& open) {
  return rows_of<generated::Terminal, Tier>(
      size, {r.alpha, r.N_A, r.N_B, r.a_t, r.b_t, r.c_t, r.rho}, open);
}

using generated::Accurate, generated::Fast, generated::Slow;
extern const Kernels table;
const Kernels table{lanes == 8   ? "avx512"
                    : lanes == 4 ? "avx2"
                                 : "baseline",
                    {single<generated::Velocities, Fast>, single<generated::Velocities, Accurate>,
                     single<generated::Velocities, Slow>, velocities_by_mpfr},
                    {single<generated::Terminal, Fast>, single<generated::Terminal, Accurate>,
                     single<generated::Terminal, Slow>, terminal_by_mpfr},
                    restitution,
                    collapse,
                    single<generated::Counts, Fast>,
                    {single<generated::Collision, Fast>, single<generated::Collision, Accurate>,
                     single<generated::Collision, Slow>, collision_by_mpfr},
                    {single<generated::Angle, Fast>, single<generated::Angle, Accurate>,
                     single<generated::Angle, Slow>, angle_by_mpfr},
                    {single<generated::Magic, Fast>, single<generated::Magic, Accurate>,
                     single<generated::Magic, Slow>, magic_by_mpfr},
                    {single<generated::Deficient, Fast>, single<generated::Deficient, Accurate>,
                     single<generated::Deficient, Slow>, deficient_by_mpfr},
                    {velocity_rows<Fast>, velocity_rows<Accurate>},
                    {terminal_rows<Fast>, terminal_rows<Accurate>}};
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::numbers
