// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/arctangent.hpp"

#include <ginac/ginac.h>

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

std::optional<std::pair<numeric, ex>> multiple_of_arctangent(const ex& e) {
  const auto is_arctangent = [](const ex& part) {
    return is_a<GiNaC::function>(part) && ex_to<GiNaC::function>(part).get_name() == "atan";
  };
  if (is_arctangent(e)) return std::pair{numeric(1), e.op(0)};
  if (!is_a<GiNaC::mul>(e) || e.nops() != 2) return std::nullopt;
  for (const std::size_t which : {0U, 1U}) {
    const ex& factor = e.op(1 - which);
    if (is_arctangent(e.op(which)) && is_a<numeric>(factor) && ex_to<numeric>(factor).is_rational())
      return std::pair{ex_to<numeric>(factor), e.op(which).op(0)};
  }
  return std::nullopt;
}

}  // namespace magicmass::proof
