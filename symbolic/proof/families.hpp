// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace GiNaC {
class ex;
}

// Families of sequences: one for each choice of the wedge's parameters mu_A = M_A/(M_A + m),
// mu_B = M_B/(M_B + m) (1 for a wall) and e. They depend on these and on V and L alone, so what is proved
// for all parameters holds with numbers or expressions put in; f(n) stands for f(n; mu_A, mu_B, e).
namespace magicmass::proof {

GiNaC::ex v_A(const GiNaC::ex& n);  // velocities just after P_n, Q_n, P_n, Q_n
GiNaC::ex v_B(const GiNaC::ex& n);
GiNaC::ex v_C(const GiNaC::ex& n);
GiNaC::ex v_C_prime(const GiNaC::ex& n);
GiNaC::ex r_P(const GiNaC::ex& n);  // approach speeds just before P_n and Q_n
GiNaC::ex r_Q(const GiNaC::ex& n);
GiNaC::ex p(const GiNaC::ex& n);  // a total momentum
GiNaC::ex x_P(
    const GiNaC::ex& n);  // approach speed times time: the gap that flight would have at time 0
GiNaC::ex x_Q(const GiNaC::ex& n);
GiNaC::ex D_P(const GiNaC::ex& n);  // approach speed times the distance of A and B
GiNaC::ex D_Q(const GiNaC::ex& n);
GiNaC::ex tau_P(const GiNaC::ex& n);  // times of P_n and Q_n
GiNaC::ex tau_Q(const GiNaC::ex& n);
GiNaC::ex tau(const GiNaC::ex& j);  // time of collision j = 0, 1, 2, ...
GiNaC::ex d_P(const GiNaC::ex& n);  // distance of A and B then
GiNaC::ex d_Q(const GiNaC::ex& n);
GiNaC::ex N_C();  // how many collisions there are: the ball takes part in all

// Members of families, "f(n)" and "N_C", and the names of their parameters.
bool is_family(const GiNaC::ex& e);
const std::vector<GiNaC::ex>& family_parameters();
std::vector<GiNaC::ex> arguments_of_family(const GiNaC::ex& e);  // those for the parameters
// Every f(n; mu_A, mu_B, e) in the expression is at the parameters themselves.
bool families_are_general(const GiNaC::ex& e);
bool contains_family(const GiNaC::ex& e);
// Whether its value may change with the symbol of this name other than by its arguments.
bool depends_on_hidden(const GiNaC::ex& family, const std::string& name);

}  // namespace magicmass::proof
