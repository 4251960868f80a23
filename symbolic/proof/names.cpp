// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/names.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <mutex>
#include <set>

#include <cln/real.h>
#include <ginac/ginac.h>

#include "magicmass/errors.hpp"

namespace magicmass::proof {
namespace {

using GiNaC::dynallocate;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

GiNaC::numeric integer_below(const numeric& x) {
  const numeric quotient = GiNaC::iquo(x.numer(), x.denom());
  return x.is_negative() && !x.is_integer() ? quotient - 1 : quotient;
}

bool is_rational(const ex& x) { return is_a<numeric>(x) && ex_to<numeric>(x).is_rational(); }

ex floor_eval(const ex& x);
ex ceiling_eval(const ex& x);
ex sawtooth_eval(const ex& x);

ex finite_sum_eval(const ex& term, const ex& lower, const ex& upper);

ex floor_evalf(const ex& x);
ex ceiling_evalf(const ex& x);
ex sawtooth_evalf(const ex& x);

}  // namespace

DECLARE_FUNCTION_1P(seq_a)
DECLARE_FUNCTION_1P(seq_b)
DECLARE_FUNCTION_1P(seq_c)
DECLARE_FUNCTION_1P(seq_c_prime)
DECLARE_FUNCTION_1P(seq_t_P)
DECLARE_FUNCTION_1P(seq_t_Q)
DECLARE_FUNCTION_1P(seq_s_P)
DECLARE_FUNCTION_1P(seq_s_Q)
DECLARE_FUNCTION_1P(seq_t)
DECLARE_FUNCTION_1P(seq_s)
DECLARE_FUNCTION_1P(seq_T)
DECLARE_FUNCTION_1P(seq_C)
DECLARE_FUNCTION_1P(seq_S)
DECLARE_FUNCTION_1P(seq_X_P)
DECLARE_FUNCTION_1P(seq_Y_P)
DECLARE_FUNCTION_1P(seq_v)
DECLARE_FUNCTION_1P(seq_w)
DECLARE_FUNCTION_3P(sum_finite)
DECLARE_FUNCTION_2P(limit_infinity)
DECLARE_FUNCTION_1P(step_ceil)
DECLARE_FUNCTION_1P(step_floor)
DECLARE_FUNCTION_1P(step_sawtooth)

REGISTER_FUNCTION(seq_a, dummy())
REGISTER_FUNCTION(seq_b, dummy())
REGISTER_FUNCTION(seq_c, dummy())
REGISTER_FUNCTION(seq_c_prime, dummy())
REGISTER_FUNCTION(seq_t_P, dummy())
REGISTER_FUNCTION(seq_t_Q, dummy())
REGISTER_FUNCTION(seq_s_P, dummy())
REGISTER_FUNCTION(seq_s_Q, dummy())
REGISTER_FUNCTION(seq_t, dummy())
REGISTER_FUNCTION(seq_s, dummy())
REGISTER_FUNCTION(seq_T, dummy())
REGISTER_FUNCTION(seq_C, dummy())
REGISTER_FUNCTION(seq_S, dummy())
REGISTER_FUNCTION(seq_X_P, dummy())
REGISTER_FUNCTION(seq_Y_P, dummy())
REGISTER_FUNCTION(seq_v, dummy())
REGISTER_FUNCTION(seq_w, dummy())
REGISTER_FUNCTION(sum_finite, eval_func(finite_sum_eval))
REGISTER_FUNCTION(limit_infinity, dummy())
REGISTER_FUNCTION(step_ceil, eval_func(ceiling_eval).evalf_func(ceiling_evalf))
REGISTER_FUNCTION(step_floor, eval_func(floor_eval).evalf_func(floor_evalf))
REGISTER_FUNCTION(step_sawtooth, eval_func(sawtooth_eval).evalf_func(sawtooth_evalf))

namespace {

ex floor_eval(const ex& x) {
  if (is_rational(x)) return integer_below(ex_to<numeric>(x));
  return step_floor(x).hold();
}
ex ceiling_eval(const ex& x) {
  if (is_rational(x)) return -integer_below(-ex_to<numeric>(x));
  return step_ceil(x).hold();
}
ex sawtooth_eval(const ex& x) {
  if (is_rational(x)) return ex_to<numeric>(x) - integer_below(ex_to<numeric>(x));
  return step_sawtooth(x).hold();
}

ex finite_sum_eval(const ex& term, const ex& lower, const ex& upper) {
  constexpr int longest = 1000;
  const bool bounded = is_a<numeric>(lower) && is_a<numeric>(upper) &&
                       ex_to<numeric>(lower).is_integer() && ex_to<numeric>(upper).is_integer();
  if (!bounded || ex_to<numeric>(upper - lower) > longest)
    return sum_finite(term, lower, upper).hold();
  ex sum = 0;
  for (numeric k = ex_to<numeric>(lower); k <= ex_to<numeric>(upper); k += 1)
    sum += term.subs(summation_index() == k, GiNaC::subs_options::no_pattern);
  return sum;
}

// Floating-point arguments are exact binary rationals to these.
numeric as_integer_below(const numeric& x) {
  return numeric(cln::floor1(cln::the<cln::cl_R>(x.to_cl_N())));
}
ex floor_evalf(const ex& x) {
  const ex value = x.evalf();
  return is_a<numeric>(value) ? ex(as_integer_below(ex_to<numeric>(value)))
                              : ex(step_floor(x).hold());
}
ex ceiling_evalf(const ex& x) {
  const ex value = x.evalf();
  return is_a<numeric>(value) ? ex(-as_integer_below(-ex_to<numeric>(value)))
                              : ex(step_ceil(x).hold());
}
ex sawtooth_evalf(const ex& x) {
  const ex value = x.evalf();
  return is_a<numeric>(value) ? ex(value - as_integer_below(ex_to<numeric>(value)))
                              : ex(step_sawtooth(x).hold());
}

const std::map<std::string, std::string>& printed_names() {
  static const std::map<std::string, std::string> names{
      {"seq_a", "a"},
      {"seq_b", "b"},
      {"seq_c", "c"},
      {"seq_c_prime", "c'"},
      {"seq_t_P", "t_P"},
      {"seq_t_Q", "t_Q"},
      {"seq_s_P", "s_P"},
      {"seq_s_Q", "s_Q"},
      {"seq_T", "T"},
      {"seq_t", "t"},
      {"seq_s", "s"},
      {"step_ceil", "ceil"},
      {"seq_C", "C"},
      {"seq_S", "S"},
      {"seq_X_P", "X_P"},
      {"seq_Y_P", "Y_P"},
      {"seq_v", "v"},
      {"seq_w", "w"},
      {"sum_finite", "sum"},
      {"step_floor", "floor"},
      {"step_sawtooth", "sawtooth"},
      {"seq_v_C_prime", "v_C'"},
      {"limit_infinity", "lim"},
  };
  return names;
}

}  // namespace

GiNaC::ex symbol(const std::string& name) {
  static std::mutex guard;
  static std::map<std::string, ex> symbols;  // grows only; a name never changes its symbol
  const bool identifier = !name.empty() && name != "pi" &&
                          std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
                          std::all_of(name.begin(), name.end(), [](unsigned char character) {
                            return std::isalnum(character) != 0 || character == '_';
                          });
  if (!identifier) throw InvalidInput("not a name for a symbol: " + name);
  const std::lock_guard lock(guard);
  const auto found = symbols.find(name);
  if (found != symbols.end()) return found->second;
  return symbols.emplace(name, GiNaC::realsymbol(name)).first->second;
}

void collect_symbol_names(const ex& e, std::set<std::string>& names) {
  if (is_a<GiNaC::symbol>(e)) names.insert(ex_to<GiNaC::symbol>(e).get_name());
  for (const ex& part : e) collect_symbol_names(part, names);
}

ex a(const ex& n) { return seq_a(n); }
ex b(const ex& n) { return seq_b(n); }
ex c(const ex& n) { return seq_c(n); }
ex c_prime(const ex& n) { return seq_c_prime(n); }
ex t_P(const ex& n) { return seq_t_P(n); }
ex t_Q(const ex& n) { return seq_t_Q(n); }
ex s_P(const ex& n) { return seq_s_P(n); }
ex s_Q(const ex& n) { return seq_s_Q(n); }
ex t(const ex& j) { return seq_t(j); }
ex s(const ex& j) { return seq_s(j); }
ex T(const ex& m) { return seq_T(m); }
ex C(const ex& n) { return seq_C(n); }
ex S(const ex& n) { return seq_S(n); }
ex X_P(const ex& n) { return seq_X_P(n); }
ex Y_P(const ex& n) { return seq_Y_P(n); }
ex v(const ex& j) { return seq_v(j); }
ex w(const ex& j) { return seq_w(j); }
ex finite_sum(const ex& term, const ex& lower, const ex& upper) {
  return sum_finite(term, lower, upper);
}
const ex& summation_index() {
  static const ex index = GiNaC::realsymbol("k'");
  return index;
}
bool is_finite_sum(const ex& e) {
  return is_a<GiNaC::function>(e) && ex_to<GiNaC::function>(e).get_name() == "sum_finite";
}
ex limit_at_infinity(const ex& f, const ex& x) { return limit_infinity(f, x); }
bool is_limit(const ex& e) {
  return is_a<GiNaC::function>(e) && ex_to<GiNaC::function>(e).get_name() == "limit_infinity";
}
ex ceiling(const ex& x) { return step_ceil(x); }
ex floor(const ex& x) { return step_floor(x); }
ex sawtooth(const ex& x) { return step_sawtooth(x); }

bool is_sequence(const ex& e) {
  return is_a<GiNaC::function>(e) && ex_to<GiNaC::function>(e).get_name().starts_with("seq_");
}

bool contains_sequence(const ex& e) {
  return is_sequence(e) || std::any_of(e.begin(), e.end(), contains_sequence);
}

bool is_step_function(const ex& e) {
  return is_a<GiNaC::function>(e) && ex_to<GiNaC::function>(e).get_name().starts_with("step_");
}

std::string function_name(const ex& e) {
  const std::string name = ex_to<GiNaC::function>(e).get_name();
  const auto found = printed_names().find(name);
  if (found != printed_names().end()) return found->second;
  for (const std::string prefix : {"seq_", "family_"})
    if (name.starts_with(prefix)) return name.substr(prefix.size());
  return name;
}

}  // namespace magicmass::proof
