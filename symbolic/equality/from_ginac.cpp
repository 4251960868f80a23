// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/from_ginac.hpp"

#include <algorithm>
#include <stdexcept>

#include <ginac/ginac.h>

#include "proof/text.hpp"

namespace magicmass::equality {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

Tree from_ginac(const ex& e) {
  if (is_a<GiNaC::numeric>(e)) {
    const auto& value = ex_to<GiNaC::numeric>(e);
    return number(cln::the<cln::cl_RA>(value.to_cl_N()));
  }
  if (is_a<GiNaC::symbol>(e)) return symbol(ex_to<GiNaC::symbol>(e).get_name());
  if (e.is_equal(GiNaC::Pi)) return pi();
  std::vector<ex> operands(e.begin(), e.end());
  if (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e))  // GiNaC's own order changes from run to run
    std::sort(operands.begin(), operands.end(),
              [](const ex& x, const ex& y) { return proof::to_text(x) < proof::to_text(y); });
  std::vector<Tree> parts;
  parts.reserve(operands.size());
  for (const ex& part : operands) parts.push_back(from_ginac(part));
  if (is_a<GiNaC::add>(e)) return sum(parts);
  if (is_a<GiNaC::mul>(e)) return product(parts);
  if (is_a<GiNaC::power>(e)) {
    if (is_number(parts[1]) && cln::denominator(parts[1]->value) == 2) {
      const Tree square_root = root(parts[0], 2);
      const cln::cl_RA whole = cln::numerator(parts[1]->value);
      return whole == 1 ? square_root : power(square_root, number(whole));
    }
    return power(parts[0], parts[1]);
  }
  if (is_a<GiNaC::function>(e)) return function(ex_to<GiNaC::function>(e).get_name(), parts[0]);
  throw std::logic_error("no scalar expression");
}

}  // namespace magicmass::equality
