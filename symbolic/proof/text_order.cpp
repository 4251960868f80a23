// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/text_order.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include <ginac/ginac.h>

#include "proof/names.hpp"

namespace magicmass::proof {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

constexpr std::array<std::string_view, 3> leading{"V_CM", "V", "L"};
constexpr std::array<std::string_view, 5> angles{"theta", "psi", "phi", "eta", "x"};
constexpr std::array<std::string_view, 6> functions{"factorial", "binomial", "cos",
                                                    "sin",       "tan",      "atan"};

template <std::size_t size>
int position(const std::array<std::string_view, size>& names, std::string_view name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

template <std::size_t size>
bool contains(const std::array<std::string_view, size>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_index(const ex& e) {
  if (!is_a<GiNaC::symbol>(e)) return false;
  const std::string name = ex_to<GiNaC::symbol>(e).get_name();
  static const std::set<std::string> indices{"j", "k", "m", "n", "k'", "N", "N_A", "N_B"};
  return indices.contains(name);
}

bool is_root(const ex& e) {
  return is_a<GiNaC::power>(e) && is_a<GiNaC::numeric>(e.op(1)) &&
         !ex_to<GiNaC::numeric>(e.op(1)).is_integer();
}

ex base_of(const ex& e) { return is_a<GiNaC::power>(e) ? e.op(0) : e; }

}  // namespace

bool is_sum_of_indices(const ex& sum) {
  return std::any_of(sum.begin(), sum.end(), [](const ex& term) {
    return is_index(term) || (is_a<GiNaC::mul>(term) && term.nops() == 2 &&
                              is_a<GiNaC::numeric>(term.op(1)) && is_index(term.op(0)));
  });
}

Place place(const ex& factor) {
  if (is_root(factor)) return Place::root;
  const ex base = base_of(factor);
  if (is_a<GiNaC::numeric>(base)) return Place::number;
  if (is_a<GiNaC::constant>(base)) return Place::pi;
  if (is_index(base)) return Place::index;
  if (is_a<GiNaC::symbol>(base)) {
    const std::string name = ex_to<GiNaC::symbol>(base).get_name();
    return contains(leading, name)  ? Place::leading
           : contains(angles, name) ? Place::angle
                                    : Place::name;
  }
  if (is_a<GiNaC::add>(base)) return is_sum_of_indices(base) ? Place::index_sum : Place::sum;
  if (is_a<GiNaC::function>(base)) return is_sequence(base) ? Place::element : Place::function;
  return Place::other;
}

OrderedFactor ordered(const ex& factor, std::string shown) {
  const Place where = place(factor);
  const ex base = base_of(factor);
  int within = 0;
  if (where == Place::leading) within = position(leading, ex_to<GiNaC::symbol>(base).get_name());
  if (where == Place::root)
    within = is_a<GiNaC::numeric>(base) ? 0 : is_a<GiNaC::add>(base) ? 2 : 1;
  if (where == Place::function) within = position(functions, function_name(base));
  return {where, within, std::move(shown)};
}

}  // namespace magicmass::proof
