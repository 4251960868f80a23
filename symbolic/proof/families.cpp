// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/families.hpp"

#include <algorithm>

#include <ginac/ginac.h>

#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::dynallocate;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

DECLARE_FUNCTION_4P(seq_v_A)
DECLARE_FUNCTION_4P(seq_v_B)
DECLARE_FUNCTION_4P(seq_v_C)
DECLARE_FUNCTION_4P(seq_v_C_prime)
DECLARE_FUNCTION_4P(seq_r_P)
DECLARE_FUNCTION_4P(seq_r_Q)
DECLARE_FUNCTION_4P(seq_p)
DECLARE_FUNCTION_4P(seq_x_P)
DECLARE_FUNCTION_4P(seq_x_Q)
DECLARE_FUNCTION_4P(seq_D_P)
DECLARE_FUNCTION_4P(seq_D_Q)
DECLARE_FUNCTION_4P(seq_tau_P)
DECLARE_FUNCTION_4P(seq_tau_Q)
DECLARE_FUNCTION_4P(seq_tau)
DECLARE_FUNCTION_4P(seq_d_P)
DECLARE_FUNCTION_4P(seq_d_Q)
DECLARE_FUNCTION_3P(family_N_C)

REGISTER_FUNCTION(seq_v_A, dummy())
REGISTER_FUNCTION(seq_v_B, dummy())
REGISTER_FUNCTION(seq_v_C, dummy())
REGISTER_FUNCTION(seq_v_C_prime, dummy())
REGISTER_FUNCTION(seq_r_P, dummy())
REGISTER_FUNCTION(seq_r_Q, dummy())
REGISTER_FUNCTION(seq_p, dummy())
REGISTER_FUNCTION(seq_x_P, dummy())
REGISTER_FUNCTION(seq_x_Q, dummy())
REGISTER_FUNCTION(seq_D_P, dummy())
REGISTER_FUNCTION(seq_D_Q, dummy())
REGISTER_FUNCTION(seq_tau_P, dummy())
REGISTER_FUNCTION(seq_tau_Q, dummy())
REGISTER_FUNCTION(seq_tau, dummy())
REGISTER_FUNCTION(seq_d_P, dummy())
REGISTER_FUNCTION(seq_d_Q, dummy())
REGISTER_FUNCTION(family_N_C, dummy())

namespace {

const ex& mu_A() { return family_parameters()[0]; }
const ex& mu_B() { return family_parameters()[1]; }
const ex& e() { return family_parameters()[2]; }

}  // namespace

ex v_A(const ex& n) { return seq_v_A(n, mu_A(), mu_B(), e()); }
ex v_B(const ex& n) { return seq_v_B(n, mu_A(), mu_B(), e()); }
ex v_C(const ex& n) { return seq_v_C(n, mu_A(), mu_B(), e()); }
ex v_C_prime(const ex& n) { return seq_v_C_prime(n, mu_A(), mu_B(), e()); }
ex r_P(const ex& n) { return seq_r_P(n, mu_A(), mu_B(), e()); }
ex r_Q(const ex& n) { return seq_r_Q(n, mu_A(), mu_B(), e()); }
ex p(const ex& n) { return seq_p(n, mu_A(), mu_B(), e()); }
ex x_P(const ex& n) { return seq_x_P(n, mu_A(), mu_B(), e()); }
ex x_Q(const ex& n) { return seq_x_Q(n, mu_A(), mu_B(), e()); }
ex D_P(const ex& n) { return seq_D_P(n, mu_A(), mu_B(), e()); }
ex D_Q(const ex& n) { return seq_D_Q(n, mu_A(), mu_B(), e()); }
ex tau_P(const ex& n) { return seq_tau_P(n, mu_A(), mu_B(), e()); }
ex tau_Q(const ex& n) { return seq_tau_Q(n, mu_A(), mu_B(), e()); }
ex tau(const ex& j) { return seq_tau(j, mu_A(), mu_B(), e()); }
ex d_P(const ex& n) { return seq_d_P(n, mu_A(), mu_B(), e()); }
ex d_Q(const ex& n) { return seq_d_Q(n, mu_A(), mu_B(), e()); }
ex N_C() { return family_N_C(mu_A(), mu_B(), e()); }

const std::vector<ex>& family_parameters() {
  static const std::vector<ex> parameters{symbol("mu_A"), symbol("mu_B"), symbol("e")};
  return parameters;
}

bool is_family(const ex& e) {
  if (!is_a<GiNaC::function>(e)) return false;
  return ex_to<GiNaC::function>(e).get_name().starts_with("family_") ||
         (is_sequence(e) && e.nops() == family_parameters().size() + 1);
}

std::vector<ex> arguments_of_family(const ex& e) {
  return {e.begin() + (is_sequence(e) ? 1 : 0), e.end()};
}

bool families_are_general(const ex& e) {
  if (is_family(e)) {
    const std::vector<ex> arguments = arguments_of_family(e);
    if (!std::equal(arguments.begin(), arguments.end(), family_parameters().begin(),
                    [](const ex& one, const ex& other) { return one.is_equal(other); }))
      return false;
  }
  return std::all_of(e.begin(), e.end(), families_are_general);
}

bool contains_family(const ex& e) {
  return is_family(e) || std::any_of(e.begin(), e.end(), contains_family);
}

bool depends_on_hidden(const ex& family, const std::string& name) {
  return !is_family(family) || name == "V" || name == "L";
}

std::string family_text(const ex& e) {
  std::string arguments = is_sequence(e) ? to_text(e.op(0)) : "";
  if (!families_are_general(e)) {
    std::string separator = arguments.empty() ? "" : "; ";
    for (const ex& argument : arguments_of_family(e)) {
      arguments += separator + to_text(argument);
      separator = ", ";
    }
  }
  return function_name(e) + (arguments.empty() ? "" : "(" + arguments + ")");
}

}  // namespace magicmass::proof
