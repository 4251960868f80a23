// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "proof/definitions.hpp"
#include "proof/domain.hpp"
#include "proof/theorem.hpp"

namespace GiNaC {
class matrix;
}

namespace magicmass::proof {

/// What a derivation asks the kernel to accept.
struct Claim {
  std::string id;                            ///< "contact.Gamma": chapter, dot, name; new
  Statement statement;                       ///< what is claimed
  std::string words = {};                    ///< what is done, for a reader
  std::string label = {};                    ///< the paper's equation, if it has one
  std::map<std::string, long> indices = {};  ///< integers and where they start: {{"n", 1}}
  std::vector<Statement> assuming = {};  ///< ">" and "<=" between constants; they become conditions
  /// How to print a side that computes something: "det Gamma", "R^T Lambda R".
  std::string shown_lhs = {};
  std::string shown_rhs = {};  ///< the same of the right side
  /// A law's symbols that stand for anything of their kind, such as the masses of any two bodies. Its other
  /// symbols are that one thing from then on: no theorem may put a value in their place.
  std::set<std::string> schematic = {};
};

/// The trusted kernel: the only maker of theorems. Each member function below is a rule; each checks its
/// claim by the exact normal form and then at random points (sampling.hpp), records the conditions it
/// used and those of its premises, and appends a Step. A refused claim throws NotProved.
class Kernel {
public:
  /// What may be assumed of symbols.
  explicit Kernel(Domain domain);

  // --- what goes in unproved: verdicts "law", "definition", "hypothesis" -------------------------------
  /// What nature does: verdict "law".
  Theorem law(const Claim& claim);
  Theorem definition(const Claim& claim);  ///< left side: a new name or a new sequence
  Theorem hypothesis(const Claim& claim);  ///< becomes a condition of all that rests on it

  // --- algebra (rules_algebra.cpp) ---------------------------------------------------------------------
  /// Both sides have one normal form.
  Theorem identity(const Claim& claim);
  /// Premises, each with its cofactor.
  using Combination = std::vector<std::pair<Theorem, GiNaC::ex>>;
  /// lhs - rhs = sum of cofactor * (premise.lhs - premise.rhs).
  Theorem consequence(const Claim& claim, const Combination& premises);
  /// Each equation, in turn, replaces its left side by its right side in both sides of the claim; then identity.
  /// An equation for f(n) is used at every index from its own least n on.
  Theorem rewriting(const Claim& claim, const std::vector<Theorem>& equations);
  /// product = 0 and product = factor * lhs with factor != 0 (proved sign or a law "x != y") give lhs = 0.
  Theorem cancellation(const Claim& claim, const Theorem& product, const GiNaC::ex& factor,
                       const std::optional<Theorem>& nonzero = std::nullopt);
  /// Symbols, each with what is put in its place.
  using Values = std::vector<std::pair<GiNaC::ex, GiNaC::ex>>;
  /// A theorem's symbols replaced by expressions of the same kind; not those that a law speaks of.
  Theorem instance(const Claim& claim, const Theorem& general, const Values& values);
  /// One entry of an equation of columns.
  Theorem component(const Claim& claim, const Theorem& columns, unsigned row);
  /// The claim, with each case's values put in, is that case's theorem. `words` says why the cases are all.
  Theorem cases(const Claim& claim, const std::vector<std::pair<Values, Theorem>>& all);
  /// lhs > 0 by signs of factors and coefficients; the right side must be 0.
  Theorem positivity(const Claim& claim);

  // --- real numbers (rules_real.cpp) -------------------------------------------------------------------
  /// (lhs - rhs)^2 = 0 gives lhs = rhs.
  Theorem vanishing_square(const Claim& claim, const Theorem& square);

  // --- finite sums (rules_sums.cpp) --------------------------------------------------------------------
  /// Coefficient, sum, shift.
  using SumTerms = std::vector<std::tuple<GiNaC::ex, GiNaC::ex, long>>;
  /// A sum over k is a combination of others, term by term: sum(f) = sum_i coefficient_i sum(f_i), where f(k)
  /// takes f_i at k + shift_i. Terms hold x^p y^q/(p! q!) with p, q affine in k; each sum runs over
  /// exactly the k with p, q >= 0.
  Theorem sum_recurrence(const Claim& claim, const SumTerms& combination);

  // --- separate runs (rules_runs.cpp) ------------------------------------------------------------------
  /// v(j) = v(first) from v(j + 1) = v(j), where each step may have a run of its own: whatever else the
  /// step's conditions name is chosen anew for each j. The conditions of `supposing` are added to each step's.
  Theorem unchanged_through_runs(const Claim& claim, const Theorem& step, const GiNaC::ex& j,
                                 const std::vector<Theorem>& supposing = {});

  // --- induction (rules_induction.cpp) -----------------------------------------------------------------
  /// M^n = F(n): F(0) = 1 and F(n + 1) = M F(n). Left side: power of the name that `matrix` defines.
  Theorem matrix_power(const Claim& claim, const Theorem& matrix, const GiNaC::ex& n);
  /// A column of sequences [f(n), g(n), ...] = [F(n), G(n), ...] from their values at the first index and
  /// from recurrences f(n) = ..., g(n) = ... in terms of f(n - 1), g(n - 1), ...
  Theorem induction(const Claim& claim, const std::vector<Theorem>& initial,
                    const std::vector<Theorem>& recurrences, const GiNaC::ex& n);

  /// f(n) = F(n) from `first` on, from f(first) = F(first) and from the same for all later n.
  Theorem first_and_later(const Claim& claim, const Theorem& at_first, const Theorem& later,
                          const GiNaC::ex& n);

  // --- angles (rules_angles.cpp) -----------------------------------------------------------------------
  /// Two angles in [0, pi] with the same cosine are equal.
  Theorem equal_angles(const Claim& claim);
  /// (N_B + 1/2) psi lies in [pi - psi/2, pi + psi/2) as N_B = ceil(pi/psi - 1); so one angle there has the
  /// cosine that `cosine` states. Claim: that angle.
  Theorem last_angle(const Claim& claim, const Theorem& cosine, const Theorem& count);

  // --- counting (rules_counting.cpp) -------------------------------------------------------------------
  /// Approach speeds before collisions 0, 2, 4, ... and 1, 3, 5, ... are positive multiples of
  /// sin((2 n + 1) h) and sin((2 n + 2) h), 0 < h < pi/2; collisions go on while they are positive.
  /// Claim: their number is ceil(pi/h) - 1.
  Theorem collision_count(const Claim& claim, const Theorem& before_even, const Theorem& before_odd,
                          const GiNaC::ex& n, const GiNaC::ex& h);
  /// Collisions alternate and A has the first: N_A = ceil(N/2), N_B = floor(N/2).
  Theorem collisions_of(const Claim& claim, const Theorem& count);
  /// N = ceil(pi/psi - s), 0 < s <= 1, psi in [0, pi] increases with alpha, psi(alpha_k) = pi/(k + s), alpha_k > 0:
  /// N = k exactly for alpha_k <= alpha < alpha_(k-1).
  Theorem threshold(const Claim& claim, const Theorem& count, const Theorem& increasing,
                    const Theorem& angle_at_threshold, const GiNaC::ex& k);

  // --- step functions (rules_step_functions.cpp) -------------------------------------------------------
  /// Both sides are built from ceil, floor and sawtooth of rational affine functions of one real variable
  /// (an integer one if the claim's indices name it); all pieces of one period are compared exactly.
  /// `equations` are applied first; `where` (statements with <= or >) restricts the cases and becomes a condition.
  Theorem step_functions(const Claim& claim, const std::vector<Theorem>& equations,
                         const GiNaC::ex& variable, const std::vector<Statement>& where = {});

  // --- inequalities (rules_inequalities.cpp, rules_ordering.cpp) ---------------------------------------
  /// A sum that is seen to be >= 0, or > 0: each term is coefficient * square^2 * product of the differences
  /// that `factors` state to be > 0 or >= 0; its coefficient is positive by signs.
  using NonnegativeTerm =
      std::tuple<GiNaC::ex, std::vector<Theorem>, GiNaC::ex>;  ///< coefficient, factors, square
  /// The larger side minus the smaller one, `equations` applied to both, is the sum of the terms.
  Theorem ordering(const Claim& claim, const std::vector<NonnegativeTerm>& terms,
                   const std::vector<Theorem>& equations = {});
  /// Conditions of a theorem that `proofs` state are no longer conditions.
  Theorem discharge(const Claim& claim, const Theorem& theorem, const std::vector<Theorem>& proofs);
  /// x <= y and x != y give y > x.
  Theorem strictly(const Claim& claim, const Theorem& at_most, const Theorem& different);
  /// X = ceil(y) + m: then y <= X - m and y + 1 > X - m, times what is positive.
  Theorem ceiling_bound(const Claim& claim, const Theorem& count);
  /// ... and X = m + k for the whole number k with y <= k, y + 1 > k.
  Theorem ceiling_value(const Claim& claim, const Theorem& count, const Theorem& at_most,
                        const Theorem& above);
  /// pi > 2 atan(t), pi > pi/d with d > 1.
  Theorem angle_below_pi(const Claim& claim);
  /// x > y or x <= y for two angles in [0, pi]: their cosines differ by a positive multiple of what the
  /// inequality `sign`, of the same kind, says.
  Theorem larger_angle(const Claim& claim, const Theorem& sign);
  /// sin x > 0, >= 0 on [0, pi] and < 0, <= 0 on [pi, 2 pi]; cos x = sin(x + pi/2). `bounds` confine x.
  Theorem sine_sign(const Claim& claim, const std::vector<Theorem>& bounds);

  // --- expansions as alpha -> 0 (rules_asymptotic.cpp) -------------------------------------------------
  /// f ~ sum of powers of sqrt(alpha): the Laurent series of f, up to its last term there.
  Theorem expansion(const Claim& claim);
  /// The leading term of a count N = ceil(q f + number) + m from that of f, which grows beyond all bounds.
  Theorem expansion_of_count(const Claim& claim, const Theorem& count, const Theorem& expansion);

  // --- signs by induction (rules_positivity_induction.cpp) ---------------------------------------------
  /// One of `values`, expressions in sequences at n, is > 0: all are at the first index, where `initial`
  /// gives the sequences, and each value at n is the sum of factors(i, k) >= 0 times value k at n - 1.
  Theorem positivity_by_induction(const Claim& claim, const std::vector<GiNaC::ex>& values,
                                  const GiNaC::matrix& factors, const std::vector<Theorem>& initial,
                                  const std::vector<Theorem>& recurrences, const GiNaC::ex& n);

  // --- limits (rules_limits.cpp) -----------------------------------------------------------------------
  /// lim(f, x) = value for x -> infinity: f, or what `closed` says it is, is `form` with p = `vanishing`,
  /// which is 1/x or b^(-c x), b > 1; the form is rational in p and defined at p = 0.
  Theorem limit(const Claim& claim, const std::optional<Theorem>& closed, const GiNaC::ex& form,
                const GiNaC::ex& p, const GiNaC::ex& vanishing);

  const std::vector<Theorem>& theorems() const { return theorems_; }  ///< all of them, in order
  /// All names defined so far.
  const Definitions& definitions() const { return definitions_; }
  /// The kernel's, with the claim's indices and assumptions.
  Domain domain_of(const Claim& claim) const;

  /// A simplified, equal expression under this kernel's domain and definitions; a proposal, not a proof.
  GiNaC::ex simplified(const GiNaC::ex& e, const std::map<std::string, long>& indices = {},
                       const std::vector<Statement>& assuming = {}) const;

private:
  struct Evidence {
    Conditions conditions;
    std::vector<std::string> premises;
  };
  /// A premise hands on its conditions and its id. Those on its own indices become the claim's: the claim
  /// must start where the premise does or later. `bound`: an index that the caller deals with, and with it
  /// the conditions that speak of it.
  void use(const Theorem& premise, const Claim& claim, const std::string& rule, Evidence& evidence,
           const std::string& bound = {}) const;
  /// The conditions of a premise that is used with its symbols at these values.
  void add_conditions_at(const Theorem& premise, const Values& values, const Claim& claim,
                         Evidence& evidence) const;
  void add_alternatives_at(const Condition& general, const Values& values, const Claim& claim,
                           Evidence& evidence) const;
  /// The claim's assumptions are inequalities between constants, and conditions of what is proved from them.
  void require_assumptions(const Claim& claim, const std::string& rule, Evidence& evidence) const;
  /// Replacing this symbol in the theorem reaches all that depends on it.
  void require_replaceable(const Theorem& general, const GiNaC::ex& symbol, const Claim& claim,
                           const std::string& rule) const;
  /// A premise of this kernel (definitions and domain are this one's), and an equation.
  void require_own(const Theorem& premise, const Claim& claim, const std::string& rule) const;
  void require_equation(const Theorem& premise, const Claim& claim, const std::string& rule) const;
  /// e is a real scalar wherever the recorded conditions hold: what may stand for a symbol or multiply a premise.
  void require_scalar(const GiNaC::ex& e, const Claim& claim, const std::string& rule,
                      Evidence& evidence) const;
  /// A law or a definition of a family of sequences speaks of its parameters, V and L alone.
  void require_family_law(const Claim& claim, const std::string& rule) const;
  GiNaC::ex written_out(const GiNaC::ex& e, const Values& values) const;
  /// No defined name in e hides `name`: so substituting for `name` in e reaches every occurrence.
  void require_visible(const GiNaC::ex& e, const GiNaC::ex& name, const Claim& claim,
                       const std::string& rule) const;
  void require_new_id(const Claim& claim) const;
  bool mentions(const Theorem& theorem, const std::string& name) const;
  Step step_for(const Claim& claim, const std::string& rule, const Evidence& evidence) const;
  Theorem accept(const Claim& claim, const std::string& rule, const Evidence& evidence,
                 const std::string& verdict = "proved");
  [[noreturn]] void refuse(const Claim& claim, const std::string& rule,
                           const std::string& reason) const;
  void require(bool holds, const Claim& claim, const std::string& rule,
               const std::string& reason) const;
  /// Both nets on lhs = rhs; throws NotProved.
  void require_equal(const GiNaC::ex& lhs, const GiNaC::ex& rhs, const Claim& claim,
                     const std::string& rule, Evidence& evidence) const;
  bool is_positive(const GiNaC::ex& e, const Claim& claim, Evidence& evidence) const;
  bool is_not_negative(const GiNaC::ex& e, const Claim& claim, Evidence& evidence) const;
  bool is_integer(const GiNaC::ex& e, const Claim& claim) const;
  /// e = 0 by normal form; outside of the class: not seen.
  bool is_zero(const GiNaC::ex& e, const Claim& claim, Evidence& evidence) const;
  /// X = ceil(y) + m, taken apart: y and X - m.
  std::pair<GiNaC::ex, GiNaC::ex> ceiling_of(const Theorem& count, const Claim& claim,
                                             const std::string& rule) const;

  bool tends_to_zero(const GiNaC::ex& vanishing, const GiNaC::ex& x, const Claim& claim,
                     Evidence& evidence) const;
  bool is_angle_up_to_pi(const GiNaC::ex& angle, const Claim& claim, Evidence& evidence) const;
  GiNaC::ex applied(const Theorem& equation, const GiNaC::ex& e, const Claim& claim,
                    const std::string& rule, Evidence& evidence) const;

  Domain domain_;
  Definitions definitions_;
  std::vector<Theorem> theorems_;
  std::set<std::string> fixed_;  ///< symbols of laws that are not schematic
};

}  // namespace magicmass::proof
