// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/fallbacks.hpp"

#include <algorithm>

#include "report/family.hpp"

namespace magicmass::report {

std::vector<Fallbacks> count_fallbacks(const std::vector<Contestant>& contestants,
                                       std::size_t inputs) {
  std::vector<Fallbacks> rows;
  for (const Contestant& one : contestants) {
    if (!one.falls_back) continue;
    const Family family = easiest_family(one.quantity, inputs);
    const auto fell_back =
        std::count_if(family.inputs.begin(), family.inputs.end(), one.falls_back);
    rows.push_back({one.name, one.quantity, family.name, family.inputs.size(),
                    static_cast<std::size_t>(fell_back)});
  }
  return rows;
}

}  // namespace magicmass::report
