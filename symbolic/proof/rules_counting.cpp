// SPDX-License-Identifier: GPL-2.0-or-later
#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

// The one factor sin(...) of a product, and the rest.
std::optional<std::pair<ex, ex>> split_sine(const ex& product, const ex& n) {
  if (!is_a<GiNaC::mul>(product)) return std::nullopt;
  for (const ex& part : product)
    if (is_a<GiNaC::function>(part) && ex_to<GiNaC::function>(part).get_name() == "sin" &&
        part.has(n))
      return std::pair{part.op(0), product / part};
  return std::nullopt;
}

// a(n) != a(n - 1), which holds while there are collisions.
bool are_different_velocities(const Statement& statement) {
  return statement.relation() == Relation::not_equal && is_sequence(statement.lhs()) &&
         is_sequence(statement.rhs());
}

}  // namespace

// Collision j happens if those before it have and the approach speed before it is positive. With speeds
// K_j sin((j + 1) h), K_j > 0, 0 < h < pi/2: (j + 1) h < pi gives a positive one, and the first j with
// (j + 1) h >= pi has (j + 1) h < pi + h < 2 pi, where it is not. So there are j = 0 .. ceil(pi/h) - 2.
Theorem Kernel::collision_count(const Claim& claim, const Theorem& before_even,
                                const Theorem& before_odd, const ex& n, const ex& h) {
  const std::string rule = "last collision";
  Evidence evidence;
  Claim at_n = claim;  // the factors are positive at each n >= 0
  at_n.indices[to_text(n)] = 0;
  require(is_a<GiNaC::symbol>(n) && !domain_.positive.contains(to_text(n)), claim, rule,
          to_text(n) + " is not an index");
  int shift = 1;
  for (const Theorem& speed : {before_even, before_odd}) {
    use(speed, claim, rule, evidence,
        to_text(n));  // "velocities changed" holds while the pairs approach
    require_equation(speed, claim, rule);
    for (const Condition& condition : speed.conditions())
      require(!condition.statement || are_different_velocities(*condition.statement) ||
                  !(condition.statement->lhs() - condition.statement->rhs()).has(n),
              claim, rule, speed.id() + " holds only if " + condition.text);
    require(contains_sequence(speed.lhs()), claim, rule, speed.id() + " is not about velocities");
    const auto split = split_sine(speed.rhs(), n);
    require(split.has_value(), claim, rule, speed.id() + " is not a multiple of a sine");
    const auto& [angle, rest] = *split;
    require(definitions_.expand_except_angles(angle - (2 * n + shift) * h).expand().is_zero(),
            claim, rule,
            speed.id() + " is not a multiple of sin((2 n + " + std::to_string(shift) + ") h)");
    require(is_positive(rest, at_n, evidence), claim, rule,
            "the factor " + to_text(rest) + " in " + speed.id() + " is not seen to be positive");
    const auto from = speed.domain().integer.find(to_text(n));
    require(from != speed.domain().integer.end() && from->second == 0, claim, rule,
            speed.id() + " must hold for n >= 0");
    ++shift;
  }
  require(is_angle_up_to_pi(2 * h, claim, evidence), claim, rule,
          "2 h is not seen to lie in [0, pi]");
  std::erase_if(evidence.conditions,
                [&](const Condition& condition) { return condition.index == to_text(n); });
  const ex& number = claim.statement.lhs();
  const bool of_family = contains_family(before_even.lhs()) || contains_family(before_odd.lhs());
  require(number.is_equal(of_family ? N_C() : symbol("N")), claim, rule,
          std::string("the claim must be about ") + (of_family ? "N_C" : "N"));
  require(families_are_general(before_even.lhs()) && families_are_general(before_odd.lhs()), claim,
          rule, "the speeds are not those of the general wedge");
  require(!definitions_.expand_all(h).has(n), claim, rule, "h depends on n");
  for (const Theorem& earlier : theorems_)
    require(of_family ? !(earlier.lhs().has(number) || earlier.rhs().has(number))
                      : !mentions(earlier, "N"),
            claim, rule, to_text(number) + " is in use already, in " + earlier.id());
  require(claim.statement.rhs().is_equal(ceiling(GiNaC::Pi / h) - 1), claim, rule,
          "the number of collisions is " + to_text(ceiling(GiNaC::Pi / h) - 1));
  evidence.conditions.insert({"the objects do not pass through each other"});
  return accept(claim, rule, evidence);
}

// Collisions 0, 2, 4, ... below N are ceil(N/2) many, 1, 3, 5, ... are floor(N/2).
Theorem Kernel::collisions_of(const Claim& claim, const Theorem& count) {
  const std::string rule = "every other collision";
  Evidence evidence;
  use(count, claim, rule, evidence);
  require(count.step().rule == "last collision", claim, rule,
          count.id() + " does not count all collisions");
  const bool of_A = claim.statement.lhs().is_equal(symbol("N_A"));
  require(of_A || claim.statement.lhs().is_equal(symbol("N_B")), claim, rule,
          "the claim must be about N_A or N_B");
  const ex share = of_A ? ceiling(count.lhs() / 2) : floor(count.lhs() / 2);
  require(claim.statement.rhs().is_equal(share), claim, rule, "its share is " + to_text(share));
  return accept(claim, rule, evidence);
}

Theorem Kernel::threshold(const Claim& claim, const Theorem& count, const Theorem& increasing,
                          const Theorem& angle_at_threshold, const ex& k) {
  const std::string rule = "threshold";
  Evidence evidence;
  for (const Theorem& premise : {count, increasing, angle_at_threshold})
    use(premise, claim, rule, evidence);
  require_equation(count, claim, rule);
  require_equation(angle_at_threshold, claim, rule);
  require(is_a<GiNaC::symbol>(claim.statement.lhs()) &&
              definitions_.contains(to_text(claim.statement.lhs())) &&
              definitions_.expand_all(claim.statement.lhs())
                  .is_equal(definitions_.expand_all(claim.statement.rhs())),
          claim, rule, "the left side must be a name for the right side");
  const ex psi = symbol("psi");
  const ex alpha = symbol("alpha");
  const ex& ratio = claim.statement.rhs();
  require(is_step_function(count.rhs()) && function_name(count.rhs()) == "ceil", claim, rule,
          count.id() + " is not a ceiling");
  const ex s = (GiNaC::Pi / psi - count.rhs().op(0)).normal();
  require(is_a<numeric>(s) && ex_to<numeric>(s).is_positive() && s <= 1, claim, rule,
          count.id() + " is not ceil(pi/psi - s), 0 < s <= 1");
  require(definitions_.angle("psi") != nullptr, claim, rule, "psi has no definition");
  require(is_angle_up_to_pi(psi, claim, evidence), claim, rule,
          "psi is not seen to lie in [0, pi]");
  require(is_positive(ratio, claim, evidence), claim, rule,
          to_text(ratio) + " is not seen to be positive");
  const ex meaning = definitions_.expand_all(psi);
  require_equal(increasing.lhs(), meaning.diff(ex_to<GiNaC::symbol>(alpha)), claim, rule, evidence);
  require(increasing.statement().relation() == Relation::greater && increasing.rhs().is_zero(),
          claim, rule, increasing.id() + " does not say that psi increases with alpha");
  require_equal(angle_at_threshold.lhs(), meaning.subs(alpha == ratio), claim, rule, evidence);
  require_equal(angle_at_threshold.rhs(), GiNaC::Pi / (k + s), claim, rule, evidence);
  // N = k <=> k - 1 < pi/psi - s <= k <=> pi/(k + s) <= psi < pi/(k - 1 + s) <=> threshold(k) <= alpha < threshold(k - 1)
  Claim told = claim;
  told.words += std::string(claim.words.empty() ? "" : ": ") + to_text(count.lhs()) + " = " +
                to_text(k) + " exactly for " + to_text(claim.statement.lhs()) +
                " <= alpha < the same at " + to_text(k) + " - 1 (infinite for " + to_text(k) +
                " = 1)";
  return accept(told, rule, evidence);
}

}  // namespace magicmass::proof
