// SPDX-License-Identifier: GPL-2.0-or-later
// Kinds of difficult inputs, each measured by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace report {

using Random = std::mt19937_64;

enum class Quantity {
  velocities,  ///< a, b, c, c' at alpha and n
  collisions,  ///< t and s of collision j
  terminal,    ///< N_A, N_B; a_t, b_t, c_t, rho at alpha
  counts,      ///< N_A, N_B at alpha
  ratios       ///< alpha_k and beta_k
};
inline const std::vector<std::pair<Quantity, std::string>> quantities{
    {Quantity::velocities, "velocities"},
    {Quantity::collisions, "collisions"},
    {Quantity::terminal, "terminal"},
    {Quantity::counts, "counts"},
    {Quantity::ratios, "ratios"}};
inline std::string name_of(Quantity quantity) { return quantities[std::size_t(quantity)].second; }

/// The index is n of velocities, j of the last collision of cycle n, k of ratios, else 0.
struct Input {
  double alpha = 0;
  std::int64_t index = 0;
  friend bool operator==(const Input&, const Input&) = default;
};

struct Family {
  std::string name;
  std::string description;
  std::uint64_t seed;
  double (*alpha)(Random&);
  /// Some n for a motion whose last is N_A.
  std::int64_t (*n)(Random&, std::int64_t last);
};
/// Hardest first.
const std::vector<Family>& families();

/// So many draws of the family for the quantity, each input once. For terminal velocities and
/// counts those alpha whose counts fit 63 bits; for ratios the k = N_A of these.
std::vector<Input> inputs_of(const Family& family, Quantity quantity, std::size_t draws);

}  // namespace report
