// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. No function of the standard library here: the linker
// might keep this target's copy of an inline one for all.
#include "magicmass/evaluators/angle.hpp"
#include "magicmass/evaluators/collision.hpp"
#include "magicmass/evaluators/deficient.hpp"
#include "magicmass/evaluators/magic.hpp"
#include "magicmass/evaluators/restitution.hpp"
#include "magicmass/evaluators/terminal.hpp"
#include "magicmass/evaluators/velocities.hpp"
#include "magicmass/numbers/kernels.hpp"

namespace magicmass::numbers {
inline namespace MAGICMASS_TARGET {
using arithmetic::DoubleDouble;
using arithmetic::lanes;
using arithmetic::Simd;
using arithmetic::SimdMask;

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

template <class Tier>
bool velocities(Velocities& result, double alpha, std::int64_t n) {
  generated::VelocitiesOutputs v{};
  const double doubt = attempt<generated::Velocities, Tier>({alpha, n}, v);
  result = {v.a, v.b, v.c, v.c_prime};
  return doubt == 0.0;
}
template <class Tier>
bool terminal(Terminal& result, double alpha) {
  generated::TerminalOutputs v{};
  const double doubt = attempt<generated::Terminal, Tier>({alpha}, v);
  result = {{v.N_A, v.N_B}, v.a_t, v.b_t, v.c_t, v.rho};
  return doubt == 0.0;
}
/// What is in doubt is counts, not roundings: up to the last sums, which lose 2^-96 of the largest
/// velocity, the losses are those of inputs that are off by less than 2^-90. share_e, h and h N
/// lose a few 2^-98 of loss_e, h and h N; a change of M_C changes each at least half as much,
/// relatively. The power loses less than N 2^-100; a change of e changes it by N/2 as much.
bool restitution(Terminal& result, const Masses& masses, double e) {
  generated::RestitutionOutputs v{};
  const double doubt =
      attempt<generated::Restitution, generated::Slow>({masses.ball, masses.per_B, e}, v);
  result = {{v.N_e - v.N_e / 2, v.N_e / 2}, v.a_end, v.b_end, v.c_end, v.rho_end};
  return doubt == 0.0;
}
bool counts(Counts& result, double alpha) {
  generated::TerminalOutputs v{};  // what is not returned is not computed: nothing else is tested
  const double doubt = attempt<generated::Terminal, generated::Fast>({alpha}, v);
  result = {v.N_A, v.N_B};
  return doubt == 0.0;
}
template <class Tier>
bool collision(Collision& result, double alpha, std::int64_t j) {
  generated::CollisionOutputs v{};
  const double doubt = attempt<generated::Collision, Tier>({alpha, j}, v);
  result = {v.when, v.apart};
  return doubt == 0.0;
}
/// A quantity of one input and one output.
template <class Q, class Tier, auto output, class Input>
bool number(double& result, Input input) {
  typename Q::Outputs v{};
  const double doubt = attempt<Q, Tier>({input}, v);
  result = v.*output;
  return doubt == 0.0;
}
template <class Tier>
constexpr auto angle = number<generated::Angle, Tier, &generated::AngleOutputs::psi, double>;
template <class Tier>
constexpr auto magic =
    number<generated::Magic, Tier, &generated::MagicOutputs::alpha_, std::int64_t>;
template <class Tier>
constexpr auto deficient =
    number<generated::Deficient, Tier, &generated::DeficientOutputs::beta_, std::int64_t>;

/// Full registers through the main case, a stage at a time for some of them; what is left over, one
/// number at a time.
template <class Q, class Tier>
[[gnu::always_inline]] inline std::size_t rows_of(std::size_t size,
                                                  const typename Q::Columns& columns, Open& open) {
  constexpr std::size_t width = lanes;
  constexpr std::size_t most = 64 / width;
  std::size_t left = 0;
  std::size_t i = 0;
  while (i + width <= size) {
    const std::size_t fit = (size - i) / width;
    const std::size_t registers = fit < most ? fit : most;
    typename Q::template Main<Tier, DoubleDouble<Simd>> k[most];
    for (std::size_t g = 0; g < registers; ++g) {
      k[g].load_inputs(columns, i + g * width);
      k[g].stage_1();
    }
    for (std::size_t g = 0; g < registers; ++g) k[g].stage_2();
    for (std::size_t g = 0; g < registers; ++g) k[g].stage_3();
    for (std::size_t g = 0; g < registers; ++g, i += width) {
      k[g].store_outputs(columns, i);
      const SimdMask is_open = ~(k[g].is_in_case(columns, i) & (doubt_of(k[g]) == 0.0));
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

using generated::Accurate;
using generated::Fast;
using generated::Slow;
extern const Kernels table;
const Kernels table{lanes == 8   ? "avx512"
                    : lanes == 4 ? "avx2"
                                 : "baseline",
                    {velocities<Fast>, velocities<Accurate>, velocities<Slow>},
                    {terminal<Fast>, terminal<Accurate>, terminal<Slow>},
                    restitution,
                    counts,
                    {collision<Fast>, collision<Accurate>, collision<Slow>},
                    {angle<Fast>, angle<Accurate>, angle<Slow>},
                    {magic<Fast>, magic<Accurate>, magic<Slow>},
                    {deficient<Fast>, deficient<Accurate>, deficient<Slow>},
                    {velocity_rows<Fast>, velocity_rows<Accurate>},
                    {terminal_rows<Fast>, terminal_rows<Accurate>}};
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::numbers
