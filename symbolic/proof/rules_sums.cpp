// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <ginac/ginac.h>

#include "proof/finite_sums.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/sampling.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using GiNaC::subs_options;

namespace {

constexpr int largest_step = 100;

void collect_factorials(const ex& e, GiNaC::exset& arguments) {
  if (is_a<GiNaC::function>(e) && ex_to<GiNaC::function>(e).get_name() == "factorial")
    arguments.insert(e.op(0));
  for (const ex& part : e) collect_factorials(part, arguments);
}

// (m + 1) (m + 2) ... (m + steps)
ex rising(const ex& m, const numeric& steps) {
  ex product = 1;
  for (numeric i = 1; i <= steps; i += 1) product *= m + i;
  return product;
}

std::optional<numeric> steps_between(const ex& from, const ex& to) {
  const ex difference = (to - from).expand();
  if (!is_a<numeric>(difference)) return std::nullopt;
  const numeric steps = ex_to<numeric>(difference);
  const bool whole = steps.is_integer() && !steps.is_negative() && steps <= largest_step;
  return whole ? std::optional(steps) : std::nullopt;
}

}  // namespace

// Write D(x, m) = x^m/m! with D(x, m) = 0 for m < 0. Then x D(x, m) = (m + 1) D(x, m + 1) for every integer m
// and every real x, zero included; with it each term becomes a multiple of the D(x, p) D(y, q) of the left
// side. The multiples agree as polynomials, so the terms agree for all integers k, and so do the sums over them.
Theorem Kernel::sum_recurrence(const Claim& claim, const SumTerms& combination) {
  const std::string rule = "sums, term by term";
  Evidence evidence;
  const ex &left = claim.statement.lhs(), &k = summation_index();
  const auto whole = finite_sum_of(left);
  require(whole.has_value(), claim, rule,
          to_text(left) + " is not a sum that the kernel understands");
  const auto has_integer_exponents = [&](const FiniteSum& sum) {
    return is_integer(sum.p.subs(k == 0, subs_options::no_pattern), claim) &&
           is_integer(sum.q.subs(k == 0, subs_options::no_pattern), claim);
  };
  require(has_integer_exponents(*whole), claim, rule, "an exponent is not seen to be an integer");
  for (const ex& base : {whole->x, whole->y}) require_scalar(base, claim, rule, evidence);

  ex right = 0;
  ex difference = -whole->front;  // of the multiples, up to (-1)^k
  GiNaC::exset arguments;
  collect_factorials(whole->front, arguments);
  for (const auto& [coefficient, sum, shift] : combination) {
    right += coefficient * sum;
    const auto part = finite_sum_of(sum);
    require(part.has_value(), claim, rule,
            to_text(sum) + " is not a sum that the kernel understands");
    require(part->x.is_equal(whole->x) && part->y.is_equal(whole->y) &&
                part->alternating == whole->alternating && has_integer_exponents(*part),
            claim, rule, "the terms of " + to_text(sum) + " are not of the same kind");
    const auto shifted = [&k, by = shift](const ex& e) {
      return e.subs(k == k + by, subs_options::no_pattern);
    };
    const ex p = shifted(part->p), q = shifted(part->q);
    const auto p_steps = steps_between(p, whole->p), q_steps = steps_between(q, whole->q);
    require(p_steps && q_steps, claim, rule,
            "the exponents in " + to_text(sum) + ", so shifted, are not below those on the left");
    const ex number =
        coefficient / (GiNaC::pow(whole->x, *p_steps) * GiNaC::pow(whole->y, *q_steps));
    require(is_a<numeric>(number) && ex_to<numeric>(number).is_rational(), claim, rule,
            to_text(coefficient) + " does not lift the exponents in " + to_text(sum) +
                " to those on the left");
    const ex sign = whole->alternating && shift % 2 != 0 ? -1 : 1;
    difference += sign * number * part->front * rising(p, *p_steps) * rising(q, *q_steps);
    collect_factorials(part->front, arguments);
  }
  require((right - claim.statement.rhs()).expand().is_zero(), claim, rule,
          "the right side is not that combination");

  // The factorials in front: all from the least one, which must be that of a number >= 0.
  if (!arguments.empty()) {
    const auto least = std::find_if(arguments.begin(), arguments.end(), [&](const ex& candidate) {
      return std::all_of(arguments.begin(), arguments.end(), [&](const ex& other) {
        return steps_between(candidate, other).has_value();
      });
    });
    require(least != arguments.end(), claim, rule, "factorials of unrelated numbers");
    require(is_integer(*least, claim) && is_positive(*least + 1, claim, evidence), claim, rule,
            to_text(*least) + " is not seen to be an integer >= 0");
    const ex unit = GiNaC::realsymbol("factorial");
    GiNaC::exmap in_units;
    for (const ex& argument : arguments)
      in_units[factorial(argument)] = unit * rising(*least, *steps_between(*least, argument));
    difference = difference.subs(in_units, subs_options::no_pattern);
  }
  require(difference.normal().expand().is_zero(), claim, rule,
          "the terms differ by a multiple of " + to_text(difference.normal()));
  const auto found =
      counterexample(left, claim.statement.rhs(), domain_of(claim), definitions_, claim.id);
  if (found) refuse(claim, rule, *found);
  return accept(claim, rule, evidence);
}

}  // namespace magicmass::proof
