// SPDX-License-Identifier: MIT
// More and more bits until every rounding and sign is certain.
#pragma once

#include <algorithm>

#include "magicmass/numbers/errors.hpp"
#include "magicmass/numbers/ladder.hpp"
#include "magicmass/numbers/mpfr_float.hpp"

namespace magicmass::numbers {
/// Numbers of 184 bits first, enough for counts of 62 bits, a double and 40 more.
/// The last is enough for the smallest alpha: its square has 2^-2148.
inline constexpr long first_bits = 184 - MpfrFloat::spare;
inline constexpr long last_bits = 8192;

/// MPFR keeps pi, for each thread.
struct Cache {
  ~Cache() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};
/// All of MPFR's exponents, and after it the caller's again, with their flags.
class AllExponents {
public:
  AllExponents() {
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
  }
  AllExponents(const AllExponents&) = delete;
  ~AllExponents() {
    mpfr_set_emin(least);
    mpfr_set_emax(most);
    mpfr_flags_restore(flags, MPFR_FLAGS_ALL);
  }

private:
  mpfr_exp_t least = mpfr_get_emin(), most = mpfr_get_emax();
  mpfr_flags_t flags = mpfr_flags_save();
};

/// Runs `attempt`, which returns a doubt, with more and more bits until that is 0.
template <class F>
void until_certain(const char* what, double x, bool is_exact, F attempt) {
  static thread_local const Cache freed_with_thread;
  const AllExponents here;
  MpfrFloat::is_exact = is_exact;
  for (long bits = first_bits;; bits = std::min(2 * bits, last_bits)) {
    MpfrFloat::bits = bits;
    if (attempt() == 0.0) return;
    if (bits == last_bits)
      throw Undecided(std::string(what) + " at " + text_of(x) + ": still open at " +
                      std::to_string(bits) + " bits");
  }
}
}  // namespace magicmass::numbers
