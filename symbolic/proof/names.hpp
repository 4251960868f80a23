// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>

namespace GiNaC {
class ex;
}

// The paper's symbols, one object a name, and the functions of an index.
namespace magicmass::proof {

/// A real symbol; the same name always gives the same symbol. What is known of it stands in a Domain.
GiNaC::ex symbol(const std::string& name);

/// Adds the names of all symbols in e.
void collect_symbol_names(const GiNaC::ex& e, std::set<std::string>& names);

/// Sequences: velocities just after P_n, Q_n, P_n, Q_n, times and A-B distances there, and cos(m psi/2).
GiNaC::ex a(const GiNaC::ex& n);        ///< velocity of A just after P_n; at n = 0 the initial one
GiNaC::ex b(const GiNaC::ex& n);        ///< velocity of B just after Q_n
GiNaC::ex c(const GiNaC::ex& n);        ///< velocity of C just after P_n
GiNaC::ex c_prime(const GiNaC::ex& n);  ///< velocity of C just after Q_n
GiNaC::ex t_P(const GiNaC::ex& n);      ///< time of P_n
GiNaC::ex t_Q(const GiNaC::ex& n);      ///< time of Q_n
GiNaC::ex s_P(const GiNaC::ex& n);      ///< distance of A and B at P_n
GiNaC::ex s_Q(const GiNaC::ex& n);      ///< distance of A and B at Q_n
GiNaC::ex t(const GiNaC::ex& j);        ///< of the collision counted j = 0, 1, 2, ... over P and Q
GiNaC::ex s(const GiNaC::ex& j);        ///< the distance of A and B then
GiNaC::ex T(const GiNaC::ex& m);        ///< cos(m psi/2)
GiNaC::ex C(const GiNaC::ex& n);  ///< cos(n x) and sin(n x) as sums of powers of cos(x) and sin(x)
GiNaC::ex S(const GiNaC::ex& n);  ///< see C
GiNaC::ex X_P(const GiNaC::ex& n);  ///< where P_n is in the unfolded plane
GiNaC::ex Y_P(const GiNaC::ex& n);  ///< the other coordinate
GiNaC::ex v(const GiNaC::ex& j);    ///< with which block j of a chain comes in; on the way back
GiNaC::ex w(const GiNaC::ex& j);    ///< see v

/// Step functions, paper eqs. def:ceil, def:floor, def:sawtooth. They evaluate at rational numbers.
GiNaC::ex ceiling(const GiNaC::ex& x);
GiNaC::ex floor(const GiNaC::ex& x);     ///< likewise
GiNaC::ex sawtooth(const GiNaC::ex& x);  ///< likewise

/// The sum of `term` over summation_index() = lower, lower + 1, ..., upper; zero when there is none. It is
/// written out once both bounds are numbers. The index is no symbol(name), so nothing outside is mistaken
/// for it.
GiNaC::ex finite_sum(const GiNaC::ex& term, const GiNaC::ex& lower, const GiNaC::ex& upper);
/// The index of every finite_sum.
const GiNaC::ex& summation_index();
/// Made by finite_sum.
bool is_finite_sum(const GiNaC::ex& e);

/// lim(f, x): what f tends to as x grows without bound.
GiNaC::ex limit_at_infinity(const GiNaC::ex& f, const GiNaC::ex& x);
/// Made by limit_at_infinity.
bool is_limit(const GiNaC::ex& e);

bool is_sequence(const GiNaC::ex& e);  ///< a(...), b(...), ...: a function of an index
/// is_sequence holds for some part.
bool contains_sequence(const GiNaC::ex& e);
bool is_step_function(const GiNaC::ex& e);  ///< ceiling, floor, sawtooth

/// A function's name as it is printed: "c'" for c_prime, "ceil" for ceiling.
std::string function_name(const GiNaC::ex& e);

}  // namespace magicmass::proof
