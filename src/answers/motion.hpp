// Counts and velocities for a mass ratio as it is written, from the book's theorems.
#pragma once

#include "answers/request.hpp"
#include "magicmass/scenes/trio.hpp"

namespace answers {

using magicmass::scenes::Ball, magicmass::scenes::Surd, magicmass::scenes::Trio;
using magicmass::scenes::value_of;

/// The mass ratio of a request. Throws InvalidInput.
notation::Alpha alpha_of(const std::string& text);
double nearest(const notation::Alpha& alpha);
/// It; nothing for magic:k and deficient:k.
std::optional<cln::cl_RA> fraction_of(const notation::Alpha& alpha);
/// It, with the bits that are set now.
Ball ball_of(const notation::Alpha& alpha);
/// The right side of a theorem's equation there, where V is 1, after n cycles.
Ball right_side_at(const char* id, const Ball& alpha, const cln::cl_RA& n = 0);

struct LargeCounts {
  cln::cl_I N_A, N_B;
};
/// Of any size. Throws Undecided where more bits would be needed than are allowed.
LargeCounts count_collisions(const notation::Alpha& alpha);
Row count_cells(const LargeCounts& counts);

/// a, b, c, c_prime in units of V after n cycles, or the terminal a, b, c and rho, with the bits
/// set now. What is 0 by a theorem is exactly 0: before any collision, and where B takes all.
using Balls = std::vector<Ball>;
Balls velocities(const notation::Alpha& alpha, const cln::cl_I& n);
Balls terminal(const notation::Alpha& alpha, const LargeCounts& counts);

/// The terminal a, b, c and rho after all of N collisions; of infinitely many, and when they end.
Balls terminal(const Trio& trio, std::optional<std::int64_t> N);
/// The terminal rho, the nearest double; missing where the collisions never end.
Cell rho(const notation::Alpha& alpha, const cln::cl_RA& e);

/// The digits that are asked for. Throws Undecided for too many.
std::optional<int> digits_wanted(const Request& request);
/// Cells with the nearest doubles of what is computed, or with so many significant digits. Throws
/// Undecided where more bits would be needed than are allowed.
Row rounded(const std::function<Balls()>& values, std::optional<int> digits = {});

/// Whole coefficients, of x^0 first.
using Polynomial = std::vector<cln::cl_I>;

/// The polynomial of least degree that alpha_k (`is_magic`) or beta_k is a root of, 1 <= k: without
/// a common factor, its first coefficient positive.
Polynomial polynomial_of_ratio(int k, bool is_magic);
/// "x^2 + 4*x - 1".
std::string text_of(const Polynomial& p);

}  // namespace answers
