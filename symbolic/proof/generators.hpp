// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ginac/ginac.h>

#include "proof/normal_form.hpp"

// Inside of the normal form; included by its own .cpp files only.
namespace magicmass::proof {

class NormalForm::Generators {
public:
  using ex = GiNaC::ex;
  struct Pair {
    ex cosine;
    ex sine;
  };

  Generators(Domain domain, Definitions definitions)
      : domain_(std::move(domain)), definitions_(std::move(definitions)) {}

  // translation.cpp: to a rational function of generators, and back.
  ex translate(const ex& e);  // collects the angles of e, then rewrites it
  ex back(const ex& e) const { return e.subs(originals_, GiNaC::subs_options::no_pattern); }
  ex rewritten(const ex& e);
  ex opaque_sum(const ex& sum);
  ex opaque(const std::string& key, const ex& original, bool positive);

  // reduction.cpp: modulo the relations; polynomial and quotient.
  ex reduced(const ex& polynomial) const;
  std::pair<ex, ex> reduced_parts(const ex& rational) const;  // zero exactly when the first is
  std::pair<ex, ex> quotient(const ex& rational) const;       // in lowest terms
  ex reduced_fraction(const ex& rational) const;
  ex tidied(const ex& polynomial) const;

  // powers.cpp
  ex symbolic_power(const ex& base, const ex& exponent);
  ex in_excesses(const ex& polynomial, GiNaC::exset& strict, GiNaC::exset& not_negative,
                 Conditions& used) const;

  // radicals.cpp
  ex square_root(const ex& radicand);
  ex radical(const ex& square, bool is_positive);

  // angles.cpp
  void collect_angles(const ex& e);
  Pair cosine_and_sine(const ex& angle);

  // sign.cpp
  bool positive(const ex& rational);
  bool not_negative(const ex& rational);
  bool positive_at_fraction_of_pi(const ex& e);
  void require_nonzero(const ex& rational, const ex& shown);

  Conditions conditions;
  static constexpr int largest_exponent = 200;  // polynomials are expanded

private:
  struct Square {
    ex generator;
    ex square;  // in generators made before it
  };
  struct Term {
    GiNaC::numeric factor;
    ex angle;
  };

  ex rewritten_anew(const ex& e);
  std::vector<Term> terms(const ex& angle) const;
  Pair base_pair(const ex& angle, const GiNaC::numeric& denominator);
  Pair pair_of_arctangent(const ex& tangent, const GiNaC::numeric& factor);
  Pair independent_pair(const ex& angle);
  bool within_unit_circle(const ex& polynomial) const;
  bool positive_polynomial(const ex& polynomial);
  const std::vector<std::pair<ex, Condition>>& assumptions();
  bool assumed_positive(const ex& polynomial);
  bool sine_product(ex& radicand, ex& root);

  Domain domain_;
  Definitions definitions_;
  std::map<std::string, ex> by_key_;
  std::vector<Square> relations_;
  GiNaC::exmap originals_;
  GiNaC::exmap translated_;
  GiNaC::exmap rewritten_;  // known already: powers and functions, and multiples of angles
  std::map<std::string, Pair> multiples_;
  std::map<ex, Pair, GiNaC::ex_is_less> pairs_of_angles_;
  GiNaC::exset positive_generators_;
  std::vector<std::pair<ex, ex>> pairs_;  // independent (C, S)
  std::map<std::string, GiNaC::numeric> denominators_;
  struct SymbolicPower {
    ex generator, base, exponent;  // base^(exponent/2)
  };
  std::vector<SymbolicPower> powers_;
  std::optional<std::vector<std::pair<ex, Condition>>> assumptions_;
};

}  // namespace magicmass::proof
