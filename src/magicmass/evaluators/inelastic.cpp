// SPDX-License-Identifier: MIT
#include "magicmass/collapse_product.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/terminal_after_P.hpp"
#include "magicmass/terminal_after_Q.hpp"
#include "magicmass/two_collisions_rational.hpp"

namespace magicmass::fast {

// Long double has 11 bits more than double. What is left of pi after N turns by h is wrong by some 8 of its eps times pi:
// that is what a like relative change of alpha - alpha_c does to it, as the condition number counts; 2^11 times less
// than a rounding of alpha to double. All else is a dozen roundings, with no difference of nearly equal numbers but
// where a velocity itself is small, and then its condition number is large. With two collisions h may be near pi/2,
// and the rest near 0 for no such cause: there the rational form is used.
Terminal terminal(long double alpha, long double e, const Counts& counts) {
  const bool only_two = counts == Counts{1, 1};
  const auto v = only_two                   ? generated::two_collisions_rational(alpha, e)
                 : counts.N_A == counts.N_B ? generated::terminal_after_Q(alpha, e, counts.N_B)
                                            : generated::terminal_after_P(alpha, e, counts.N_B);
  return {counts, static_cast<double>(v.a_t), static_cast<double>(v.b_t),
          static_cast<double>(v.c_t), static_cast<double>(v.rho)};
}

double collapse_time(long double alpha, long double e) {
  return static_cast<double>(generated::collapse_product(alpha, e));
}

}  // namespace magicmass::fast
