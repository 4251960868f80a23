// SPDX-License-Identifier: GPL-2.0-or-later
// A constant as a list of terms, each made of earlier ones; equal terms are one.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <cln/integer.h>
#include <cln/rational.h>

#include "algebraic/budget.hpp"
#include "algebraic/interval.hpp"

namespace magicmass::algebraic {

enum class Kind { rational, cosine, sum, product, power, root };

struct Term {
  Kind kind;
  cln::cl_RA value;                ///< rational: itself; cosine: t of cos(2 pi t)
  std::vector<std::size_t> parts;  ///< what it is made of
  cln::cl_I exponent;       ///< power: an integer other than 0 and 1; root: the index, from 2
  std::optional<int> sign;  ///< once decided
  std::optional<Interval>
      near{};  ///< an enclosure at near_precision, unless that is too low to divide
};

constexpr long near_precision = 64;

class Terms {
public:
  explicit Terms(const Budget& budget) : most_(budget.nodes) {}

  const Term& operator[](std::size_t id) const { return terms_[id]; }
  void set_sign(std::size_t id, int sign) { terms_[id].sign = sign; }

  std::size_t rational(const cln::cl_RA& value);
  std::size_t cosine(const cln::cl_RA& turn);
  std::size_t sum(const std::vector<std::size_t>& parts);
  std::size_t product(const std::vector<std::size_t>& parts);
  /// A negative power takes a base that is not 0, a root a radicand > 0: whoever calls has decided that.
  std::size_t power(std::size_t base, const cln::cl_I& exponent);
  std::size_t root(std::size_t radicand, long index);

  /// The terms that a term is made of, itself included, in the order of their making.
  std::vector<std::size_t> below(std::size_t id) const;

  /// Throws Unbounded where this precision is too low to divide; BeyondBudget.
  Interval enclosure(std::size_t id, long precision, const Work& work) const;

private:
  std::size_t add(Term term);
  /// Of a term whose parts' enclosures are found by their place.
  template <class Enclosures>
  static Interval made(const Term& term, const Enclosures& part, long precision);

  long most_;
  std::vector<Term> terms_;
  std::map<std::string, std::size_t> known_;
};

}  // namespace magicmass::algebraic
