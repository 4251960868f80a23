// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <functional>
#include <stdexcept>

#include <ginac/ginac.h>

#include "codegen/emit.hpp"
#include "codegen/make_kernel.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::codegen {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

// A right side in T(m), T(m + 1), T(1) with whole coefficients, by ring operations alone: the ring need not
// know its integers, only +, - and *. `names` maps T(...) to variables.
class RingExpression {
public:
  explicit RingExpression(const std::vector<std::pair<ex, std::string>>& names) : names_(names) {}

  std::string sum(const ex& e) const {
    std::vector<std::string> plus, minus;
    const ex expanded = e.expand();
    const auto add = [&](const ex& term) {
      const GiNaC::numeric scale = coefficient(term);
      const std::string shown = scaled(term / scale, GiNaC::abs(scale));
      (scale.is_negative() ? minus : plus).push_back(shown);
    };
    if (is_a<GiNaC::add>(expanded))
      for (const ex& term : expanded) add(term);
    else
      add(expanded);
    std::sort(plus.begin(), plus.end());
    std::sort(minus.begin(), minus.end());
    std::string result;
    for (const std::string& shown : plus) result += (result.empty() ? "" : " + ") + shown;
    for (const std::string& shown : minus) result += " - " + shown;
    return result;
  }

private:
  static GiNaC::numeric coefficient(const ex& term) {
    if (is_a<GiNaC::numeric>(term)) return ex_to<GiNaC::numeric>(term);
    if (is_a<GiNaC::mul>(term))
      for (const ex& part : term)
        if (is_a<GiNaC::numeric>(part)) return ex_to<GiNaC::numeric>(part);
    return 1;
  }

  std::string scaled(const ex& monomial, const GiNaC::numeric& scale) const {
    std::string shown = product(monomial);
    if (scale.is_equal(1)) return shown;
    if (scale.is_equal(2)) return "twice(" + shown + ")";
    throw std::logic_error("the ladder knows no coefficient " + proof::to_text(scale));
  }

  std::string product(const ex& monomial) const {
    if (is_a<GiNaC::numeric>(monomial)) return "one";
    if (is_a<GiNaC::power>(monomial))
      return variable(monomial.op(0)) + " * " + variable(monomial.op(0));
    if (!is_a<GiNaC::mul>(monomial)) return variable(monomial);
    std::vector<std::string> factors;
    for (const ex& part : monomial) factors.push_back(variable(part));
    std::sort(factors.begin(), factors.end(), std::greater<>());
    std::string result;
    for (const std::string& factor : factors) result += (result.empty() ? "" : " * ") + factor;
    return result;
  }

  std::string variable(const ex& element) const {
    for (const auto& [known, name] : names_)
      if (known.is_equal(element)) return name;
    throw std::logic_error("the ladder does not hold " + proof::to_text(element));
  }

  const std::vector<std::pair<ex, std::string>>& names_;
};

}  // namespace

std::string emit_cosine_ladder(const std::vector<proof::Theorem>& theorems) {
  const proof::Theorem& even = theorem_named(theorems, "chebyshev.even");
  const proof::Theorem& odd = theorem_named(theorems, "chebyshev.odd");
  const proof::Theorem& sine = theorem_named(theorems, "chebyshev.sine");
  const proof::Theorem& start = theorem_named(theorems, "chebyshev.T_0");
  if (!start.rhs().is_equal(1)) throw std::logic_error("the ladder starts at T(0) = 1");
  const ex m = proof::symbol("m");
  const std::vector<std::pair<ex, std::string>> low{
      {proof::T(m), "pair.low"}, {proof::T(m + 1), "pair.high"}, {proof::T(1), "x"}};
  const std::vector<std::pair<ex, std::string>> high{{proof::T(m + 1), "pair.high"},
                                                     {proof::T(1), "x"}};
  const ex even_of_next = even.rhs().subs(proof::T(m) == proof::T(m + 1));

  std::string text = file_header("T(m) = cos(m psi/2) and T(m + 1) from cos(psi/2), by doubling");
  text += R"(
namespace magicmass::generated {

/// What cosine_ladder gives.
template <class Ring>
struct CosinePair {
  Ring low;   ///< T(m) = cos(m psi/2)
  Ring high;  ///< T(m + 1)
};

/// T(m) and T(m + 1) from x = T(1) = cos(psi/2); `one` is the ring's 1. Integer needs >, >> and &.
/// Domain: m >= 0. Error: none in an exact ring; each step at most quadruples an absolute error.
/// From: chebyshev.T_0, )" +
          even.id() + " (" + proof::to_text(even.statement()) + "),\n/// " + odd.id() + " (" +
          proof::to_text(odd.statement()) + R"().
/// Cost: 2 multiplications, 4 additions a bit of m.
template <class Ring, class Integer>
CosinePair<Ring> cosine_ladder(const Integer& m, const Ring& x, const Ring& one) {
  const auto twice = [](const Ring& y) { return y + y; };
  int bits = 0;
  for (Integer rest = m; rest > Integer(0); rest = Integer(rest >> 1)) ++bits;
  CosinePair<Ring> pair{one, x};
  while (bits > 0) {
    --bits;
    const Ring between = )" +
          RingExpression(low).sum(odd.rhs()) + R"(;
    if ((Integer(m >> bits) & Integer(1)) > Integer(0))
      pair = {between, )" +
          RingExpression(high).sum(even_of_next) + R"(};
    else
      pair = {)" +
          RingExpression(low).sum(even.rhs()) + R"(, between};
  }
  return pair;
}

/// sin(m psi/2) sin(psi/2) from x = cos(psi/2): its sign tells whether collision m takes place.
/// From: )" +
          sine.id() + " (" + proof::to_text(sine.statement()) + R"().
template <class Ring, class Integer>
Ring sine_ladder(const Integer& m, const Ring& x, const Ring& one) {
  const CosinePair<Ring> pair = cosine_ladder(m, x, one);
  return )" +
          RingExpression(low).sum(sine.rhs()) + R"(;
}

}  // namespace magicmass::generated
)";
  return text;
}

}  // namespace magicmass::codegen
