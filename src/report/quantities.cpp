// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/quantities.hpp"

#include "magicmass/errors.hpp"

namespace magicmass::report {

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      {"velocities", {"a", "b", "c", "c_prime"}}, {"encounters", {"t", "s"}}, {"angle", {"psi"}},
      {"ratios", {"magic", "deficient"}},         {"counts", {"N_A", "N_B"}},
  };
  return all;
}

const Quantity& quantity_named(const std::string& name) {
  for (const Quantity& quantity : quantities())
    if (quantity.name == name) return quantity;
  throw InvalidInput("no quantity is called \"" + name +
                     "\"; there are velocities, encounters, angle, ratios and counts");
}

bool takes_alpha(const std::string& quantity) { return quantity != "ratios"; }

}  // namespace magicmass::report
