// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/inelastic_end.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>

#include <cln/integer.h>

#include "magicmass/errors.hpp"
#include "magicmass/fast.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "magicmass/reference/restitution.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

using Wide = long double;

Wide nearest_wide(const MassRatio& alpha) {
  if (const auto* magic = std::get_if<Magic>(&alpha)) return reference::nearest_ratio<Wide>(*magic);
  if (const auto* deficient = std::get_if<Deficient>(&alpha))
    return reference::nearest_ratio<Wide>(*deficient);
  return reference::nearest<Wide>(*reference::exact(alpha));
}

void require_told_apart(double value) {
  if (!std::isfinite(value))
    throw Undecided(
        "alpha is too close to alpha_c(e), up to which there is a collapse, for long double");
}

}  // namespace

cln::cl_RA parse_restitution(std::string_view text) {
  const auto refuse = [&] {
    return InvalidInput("restitution must be above 0 and at most 1, like 0.9 or 9/10, got " +
                        shown_text(text));
  };
  std::optional<cln::cl_RA> e;
  try {
    e = reference::exact(parse_mass_ratio(text));
  } catch (const InvalidInput&) {  // it speaks of alpha
  }
  if (!e || *e > 1) throw refuse();
  return *e;
}

InelasticEnd inelastic_end(const MassRatio& alpha, const cln::cl_RA& e) {
  InelasticEnd end{.counts = reference::count_collisions(alpha, e)};
  const Wide ratio = nearest_wide(alpha);
  const Wide restitution = reference::nearest<Wide>(e);
  if (!end.counts) {
    end.collapse_time = fast::collapse_time(ratio, restitution);
    require_told_apart(end.collapse_time);
    return end;
  }
  const auto& [N_A, N_B] = *end.counts;
  if (N_A > cln::cl_I(std::numeric_limits<std::int64_t>::max()))
    throw Undecided("N_A = " + reference::to_text(N_A) + " does not fit 64 bits");
  end.terminal =
      fast::terminal(ratio, restitution, {cln::cl_I_to_long(N_A), cln::cl_I_to_long(N_B)});
  for (const double value :
       {end.terminal.a_t, end.terminal.b_t, end.terminal.c_t, end.terminal.rho})
    require_told_apart(value);
  return end;
}

}  // namespace magicmass::command
