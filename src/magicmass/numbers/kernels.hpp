// SPDX-License-Identifier: MIT
// What is compiled once for each instruction set: plain functions behind a table. They throw
// nothing and answer only what their tests make certain; the rest is left open.
#pragma once

#include <cstddef>
#include <cstdint>

#include "magicmass/numbers/values.hpp"

namespace magicmass::numbers {
enum Tier { fast, accurate, slow, by_mpfr };

/// Pointers into columns; fields in the order of the generated ones.
struct VelocityRows {
  const double* alpha;
  const std::int64_t* n;
  double *a, *b, *c, *c_prime;
};
struct TerminalRows {
  const double* alpha;
  std::int64_t *N_A, *N_B;
  double *a_t, *b_t, *c_t, *rho;
};
/// Rows done at a time, so that those left open fit a small list.
constexpr std::size_t longest_block = 256;
using Open = std::uint16_t[longest_block];

/// Single numbers by tier, with whether the result is certain.
template <class Result, class... In>
using Ladder = bool (*[4])(Result& result, In... in);
/// The last tier, for inputs with an answer, magic: k >= 2. Undecided: the last precision fails.
bool velocities_by_mpfr(Velocities& result, double alpha, std::int64_t n);
bool terminal_by_mpfr(Terminal& result, double alpha);
bool collision_by_mpfr(Collision& result, double alpha, std::int64_t j);
bool angle_by_mpfr(double& result, double alpha);
bool magic_by_mpfr(double& result, std::int64_t k);
bool deficient_by_mpfr(double& result, std::int64_t k);
/// Masses above 0, or per_B 0; 0 < e <= 1; within fast's promise. Whether they end; never end.
bool restitution_by_mpfr(Terminal& result, Masses masses, double e);
bool collapse_by_mpfr(Collapse& result, const Masses& masses, double e);

/// Single numbers, and rows by tier (fast, accurate): how
/// many of `size` are open, and which.
struct Kernels {
  const char* name;
  Ladder<Velocities, double, std::int64_t> velocities;
  Ladder<Terminal, double> terminal;
  bool (*restitution)(Terminal& result, const Masses& masses, double e);
  bool (*collapse)(Collapse& result, const Masses& masses, double e);
  bool (*counts)(Counts& result, double alpha);
  Ladder<Collision, double, std::int64_t> collision;
  Ladder<double, double> angle;
  Ladder<double, std::int64_t> magic;
  Ladder<double, std::int64_t> deficient;
  std::size_t (*velocity_rows[2])(std::size_t size, const VelocityRows& rows, Open& open);
  std::size_t (*terminal_rows[2])(std::size_t size, const TerminalRows& rows, Open& open);
};
/// Throws NotIeee where this thread does not round to nearest, or loses subnormal numbers.
void check_arithmetic();
/// Tables by name, for tests: null where the processor cannot run them.
const Kernels* kernels_named(const char* name);
}  // namespace magicmass::numbers
