// SPDX-License-Identifier: GPL-2.0-or-later
// Where both ends round alike, so does all that lies between them.
#include "magicmass/oracle/certain.hpp"

namespace magicmass::oracle {

using cln::cl_I;
using cln::cl_RA;

Rounding<double> to_double() {
  const auto common = [](const cl_RA& low, const cl_RA& high) {
    const double value = nearest(low);
    return value == nearest(high) ? std::optional(value) : std::nullopt;
  };
  return {common, 64};
}

Rounding<cl_RA> to_within(long bits) {
  const auto common = [bits](const cl_RA& low, const cl_RA& high) {
    const cl_RA smallest = cln::min(cln::abs(low), cln::abs(high));
    const bool close = (high - low) * cln::ash(cl_I(1), bits) < smallest;
    return low == high || close ? std::optional(low) : std::nullopt;
  };
  return {common, bits};
}

cl_I exact_length(const cl_RA& alpha, const cl_I& j) {
  // Both collisions have entries of the same size, so either one's common denominator will do.
  const Map<cl_RA> map = cycle_of(alpha).with_A;
  cl_I common(1);
  for (const cl_RA& entry : map.reshaped()) common = cln::lcm(common, cln::denominator(entry));
  return j * cl_I(static_cast<unsigned long>(cln::integer_length(common - 1)));
}

}  // namespace magicmass::oracle
