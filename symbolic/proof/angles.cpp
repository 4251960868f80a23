// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/arctangent.hpp"
#include "proof/generators.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

bool is_function(const ex& e, const char* name) {
  return is_a<GiNaC::function>(e) && ex_to<GiNaC::function>(e).get_name() == name;
}

constexpr int largest_multiple = 200;  // (C + i S)^k is written out

ex first_symbol(const ex& e) {  // by name
  ex first;
  std::string first_name;
  const auto visit = [&](const auto& self, const ex& part) -> void {
    if (is_a<GiNaC::symbol>(part)) {
      const std::string name = ex_to<GiNaC::symbol>(part).get_name();
      if (first_name.empty() || name < first_name) {
        first_name = name;
        first = part;
      }
    }
    for (const ex& inner : part) self(self, inner);
  };
  visit(visit, e);
  return first;
}

// (C + i S)^k by repeated squaring.
std::pair<ex, ex> multiple(ex cosine, ex sine, numeric k) {
  if (k.is_negative()) {
    sine = -sine;
    k = -k;
  }
  ex c = 1;
  ex s = 0;
  while (!k.is_zero()) {
    if (k.is_odd()) {
      const ex next = (c * cosine - s * sine).expand();
      s = (s * cosine + c * sine).expand();
      c = next;
    }
    const ex squared = (cosine * cosine - sine * sine).expand();
    sine = (2 * cosine * sine).expand();
    cosine = squared;
    k = GiNaC::iquo(k, 2);
  }
  return {c, s};
}

}  // namespace

// An angle as a sum of rational multiples of monomials; k pi/(2k+1) is pi/2 - (1/2) pi/(2k+1).
std::vector<NormalForm::Generators::Term> NormalForm::Generators::terms(const ex& angle) const {
  std::vector<Term> result;
  GiNaC::exmap originals;  // pi and arctangents are symbols while polynomials are divided
  const ex rational = angle.to_rational(originals);
  const auto add_monomials = [&](const ex& sum, const ex& below) {
    const ex expanded = sum.expand();
    const auto add = [&](const ex& monomial) {
      const ex whole = (monomial / below).subs(originals, GiNaC::subs_options::no_pattern);
      numeric factor = 1;
      if (is_a<numeric>(whole)) {
        if (whole.is_zero()) return;
        throw NotInClass("cos or sin of a number: " + to_text(whole));
      }
      if (is_a<GiNaC::mul>(whole))
        for (const ex& part : whole)
          if (is_a<numeric>(part)) factor = ex_to<numeric>(part);
      if (!factor.is_rational()) throw NotInClass("not a rational multiple: " + to_text(whole));
      if (GiNaC::abs(factor) > largest_multiple)
        throw NotInClass("too large a multiple of an angle: " + to_text(whole));
      result.push_back({factor, whole / factor});
    };
    if (is_a<GiNaC::add>(expanded))
      for (const ex& monomial : expanded) add(monomial);
    else
      add(expanded);
  };
  const ex fraction = rational.numer_denom();
  const ex above = fraction.op(0).expand();
  const ex below = fraction.op(1).expand();
  if (is_a<numeric>(below)) {
    add_monomials(above / below, 1);
    return result;
  }
  const ex variable = first_symbol(below);  // of an angle's denominator: k, n
  const ex content = below.content(variable) * below.unit(variable);
  const ex primitive = (below / content).normal();
  add_monomials(GiNaC::quo(above / content, primitive, variable), 1);
  add_monomials(GiNaC::rem(above / content, primitive, variable), primitive);
  return result;
}

void NormalForm::Generators::collect_angles(const ex& e) {
  if (is_function(e, "cos") || is_function(e, "sin") || is_function(e, "tan"))
    for (const Term& term : terms(e.op(0))) {
      numeric& denominator = denominators_.try_emplace(to_text(term.angle), 1).first->second;
      denominator = GiNaC::lcm(denominator, term.factor.denom());
    }
  for (const ex& part : e) collect_angles(part);
}

NormalForm::Generators::Pair NormalForm::Generators::cosine_and_sine(const ex& angle) {
  if (const auto known = pairs_of_angles_.find(angle); known != pairs_of_angles_.end())
    return known->second;  // most angles come with a cosine and a sine
  Pair sum{1, 0};
  bool first = true;
  for (const Term& term : terms(angle)) {
    const std::string name = to_text(term.angle);
    const std::string key = to_text(term.factor) + " " + name;
    auto known = multiples_.find(key);
    if (known == multiples_.end()) {
      const numeric denominator = denominators_.at(name);
      const bool whole = is_function(term.angle, "atan") && term.factor.is_even();
      const Pair base = whole ? base_pair(term.factor * term.angle, 1)  // no root of 1 + tan^2
                              : base_pair(term.angle, denominator);
      const auto [cosine, sine] =
          multiple(base.cosine, base.sine, whole ? numeric(1) : term.factor * denominator);
      known = multiples_.emplace(key, Pair{reduced_fraction(cosine), reduced_fraction(sine)}).first;
    }
    const auto& [c, s] = known->second;
    sum = first ? known->second
                : Pair{reduced_fraction(sum.cosine * c - sum.sine * s),
                       reduced_fraction(sum.sine * c + sum.cosine * s)};
    first = false;
  }
  pairs_of_angles_[angle] = sum;
  return sum;
}

// cos and sin of angle/denominator.
NormalForm::Generators::Pair NormalForm::Generators::base_pair(const ex& angle,
                                                               const numeric& denominator) {
  if (angle.is_equal(GiNaC::Pi)) {
    if (denominator.is_equal(1)) return {-1, 0};
    if (denominator.is_equal(2)) return {0, 1};
  }
  const ex* meaning = is_a<GiNaC::symbol>(angle)
                          ? definitions_.angle(ex_to<GiNaC::symbol>(angle).get_name())
                          : nullptr;
  const ex arctangent = meaning != nullptr ? *meaning : angle;
  if (const auto multiple_of = multiple_of_arctangent(arctangent))
    return pair_of_arctangent(multiple_of->second, multiple_of->first / denominator);
  return independent_pair(angle / denominator);
}

// cos atan t = 1/sqrt(1 + t^2) > 0, sin atan t = t cos atan t; halves as long as needed:
// |x| < pi/2 gives cos(x/2) = sqrt((1 + cos x)/2) and sin(x/2) = sin x/(2 cos(x/2)).
NormalForm::Generators::Pair NormalForm::Generators::pair_of_arctangent(const ex& tangent,
                                                                        const numeric& factor) {
  const ex t = rewritten(tangent);
  if (factor.is_integer() && factor.is_even()) {  // cos 2x and sin 2x need no root of 1 + tan^2 x
    const ex below = 1 + GiNaC::pow(t, 2);
    const auto [c, s] = multiple(reduced_fraction((1 - GiNaC::pow(t, 2)) / below),
                                 reduced_fraction(2 * t / below), factor / 2);
    return {reduced_fraction(c), reduced_fraction(s)};
  }
  ex cosine = 1 / square_root(1 + GiNaC::pow(t, 2));
  ex sine = reduced_fraction(t * cosine);
  for (numeric halves = factor.denom(); !halves.is_equal(1); halves = GiNaC::iquo(halves, 2)) {
    if (halves.is_odd()) return independent_pair(factor * atan(tangent));
    const ex half = square_root((1 + cosine) / 2);
    sine = reduced_fraction(sine / (2 * half));
    cosine = reduced_fraction(half);
  }
  const auto [c, s] = multiple(cosine, sine, factor.numer());
  return {reduced_fraction(c), reduced_fraction(s)};
}

// A generic pair with C^2 + S^2 = 1.
NormalForm::Generators::Pair NormalForm::Generators::independent_pair(const ex& angle) {
  const std::string key = to_text(angle);
  const std::string cosine_key = "cos(" + key + ")";
  const std::string sine_key = "sin(" + key + ")";
  const bool is_new = !by_key_.contains(cosine_key);
  if (is_new) rewritten(angle);  // for what its roots and denominators ask for
  const ex cosine = GiNaC::cos(angle);
  const ex sine = GiNaC::sin(angle);
  Pair pair{opaque(cosine_key, cosine, is_new && positive_at_fraction_of_pi(cosine)),
            opaque(sine_key, sine, is_new && positive_at_fraction_of_pi(sine))};
  if (is_new) {
    relations_.push_back({pair.sine, 1 - GiNaC::pow(pair.cosine, 2)});
    pairs_.emplace_back(pair.cosine, pair.sine);
  }
  return pair;
}

}  // namespace magicmass::proof
