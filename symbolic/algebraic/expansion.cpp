// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/expansion.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

#include "algebraic/prime_powers.hpp"
#include "algebraic/root_sum.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// Exponents of the generators; generators that are not reached have exponent 0.
using Monomial = std::vector<long>;
using Sum = std::map<Monomial, RootSum>;

struct LessInteger {
  bool operator()(const cl_I& x, const cl_I& y) const { return x < y; }
};

/// A real number g > 0 with g^index = power.
struct Generator {
  long index;
  Sum power;
};

struct Fraction {
  Sum above;
  Sum below;  ///< not the number 0
};

class Expansion {
public:
  Expansion(const Terms& terms, std::size_t id, const Work& work)
      : terms_(terms), work_(work), order_(terms.below(id)), roots_(order_of_roots()) {
    make_prime_generators();
  }

  bool vanishes() {
    for (const std::size_t id : order_) known_.emplace(id, fraction(terms_[id], id));
    for (const auto& [monomial, coefficient] : known_.at(order_.back()).above)
      if (!roots_.vanishes(coefficient)) return false;
    return true;
  }

  long order_of_roots_used() const { return roots_.order(); }
  bool has_radicals() const { return !generators_.empty(); }

private:
  long order_of_roots() const {
    cl_I m = 1;
    for (const std::size_t id : order_)
      if (terms_[id].kind == Kind::cosine) m = cln::lcm(m, cln::denominator(terms_[id].value));
    if (m >= (cl_I(1) << 40)) throw BeyondBudget("roots of unity of too large an order");
    return cln::cl_I_to_long(m);
  }

  bool is_rational_root(const Term& term) const {
    return term.kind == Kind::root && terms_[term.parts[0]].kind == Kind::rational;
  }

  /// p^(1/n), n the common multiple of the indices of the roots that p occurs under.
  void make_prime_generators() {
    std::map<cl_I, cl_I, LessInteger> indices;
    for (const std::size_t id : order_)
      if (is_rational_root(terms_[id]))
        for (const auto& [prime, exponent] : prime_powers(terms_[terms_[id].parts[0]].value)) {
          cl_I& index = indices.emplace(prime, 1).first->second;
          index = cln::lcm(index, terms_[id].exponent);
        }
    for (const auto& [prime, index] : indices) {
      if (cln::integer_length(index) > 30) throw BeyondBudget("a root of too large an index");
      prime_generators_[prime] = generators_.size();
      generators_.push_back({cln::cl_I_to_long(index), number(prime)});
    }
  }

  Fraction fraction(const Term& term, std::size_t id) {
    const auto part = [&](std::size_t i) -> const Fraction& { return known_.at(term.parts[i]); };
    switch (term.kind) {
      case Kind::rational:
        return {number(term.value), number(1)};
      case Kind::cosine:
        return {{{Monomial{}, roots_.cosine(term.value)}}, number(1)};
      case Kind::sum: {
        Fraction result = part(0);
        for (std::size_t i = 1; i < term.parts.size(); ++i) result = sum(result, part(i));
        return result;
      }
      case Kind::product: {
        Fraction result = part(0);
        for (std::size_t i = 1; i < term.parts.size(); ++i)
          result = {product(result.above, part(i).above), product(result.below, part(i).below)};
        return result;
      }
      case Kind::power: {
        const cl_I n = cln::abs(term.exponent);
        const Fraction result = {power(part(0).above, n), power(part(0).below, n)};
        return cln::plusp(term.exponent) ? result : Fraction{result.below, result.above};
      }
      case Kind::root:
        return is_rational_root(term) ? rational_root(term) : new_root(term);
      case Kind::magnitude:
        if (!terms_[term.parts[0]].sign) throw BeyondBudget("an unknown sign");
        return {product(part(0).above, number(*terms_[term.parts[0]].sign)), part(0).below};
    }
    throw std::logic_error("a kind of term that cancels() does not know: " + std::to_string(id));
  }

  Fraction rational_root(const Term& term) {
    Sum result = number(1);
    for (const auto& [prime, exponent] : prime_powers(terms_[term.parts[0]].value)) {
      const std::size_t generator = prime_generators_.at(prime);
      const long index = generators_[generator].index;
      const long scaled = exponent * (index / cln::cl_I_to_long(term.exponent));
      const long whole = scaled >= 0 ? scaled / index : -((-scaled + index - 1) / index);
      Monomial monomial(generator + 1);
      monomial[generator] = scaled - whole * index;
      const cl_RA outside = cln::expt(cl_RA(prime), cl_I(whole));
      result = product(result, {{trimmed(std::move(monomial)), RootsOfUnity::number(outside)}});
    }
    return {result, number(1)};
  }

  /// A new generator. Roots of fractions with other denominators than numbers are left to the separation bound.
  Fraction new_root(const Term& term) {
    const Fraction& radicand = known_.at(term.parts[0]);
    if (radicand.below != number(1)) throw BeyondBudget("a root of a fraction");
    Monomial monomial(generators_.size() + 1);
    monomial.back() = 1;
    generators_.push_back({cln::cl_I_to_long(term.exponent), radicand.above});
    return {{{std::move(monomial), RootsOfUnity::number(1)}}, number(1)};
  }

  static Sum number(const cl_RA& value) {
    if (cln::zerop(value)) return {};
    return {{Monomial{}, RootsOfUnity::number(value)}};
  }

  static Monomial trimmed(Monomial monomial) {
    while (!monomial.empty() && monomial.back() == 0) monomial.pop_back();
    return monomial;
  }

  static void add(Sum& x, const Sum& y) {
    for (const auto& [monomial, coefficient] : y) {
      RootSum& total = x[monomial];
      RootsOfUnity::add(total, coefficient);
      if (total.empty()) x.erase(monomial);
    }
  }

  Fraction sum(const Fraction& x, const Fraction& y) {
    if (x.below == y.below) {
      Sum above = x.above;
      add(above, y.above);
      return {above, x.below};
    }
    Sum above = product(x.above, y.below);
    add(above, product(y.above, x.below));
    return {above, product(x.below, y.below)};
  }

  Sum product(const Sum& x, const Sum& y) {
    Sum result;
    for (const auto& [first, a] : x)
      for (const auto& [second, b] : y) {
        spent_ += static_cast<long>(a.size() * b.size());
        if (spent_ > work_.budget().terms) throw BeyondBudget("an expansion too long");
        work_.check_time();
        add(result, product_of_monomials(first, second, roots_.product(a, b)));
      }
    return result;
  }

  Sum product_of_monomials(const Monomial& x, const Monomial& y, const RootSum& coefficient) {
    Monomial exponents(std::max(x.size(), y.size()));
    for (std::size_t i = 0; i < exponents.size(); ++i)
      exponents[i] = (i < x.size() ? x[i] : 0) + (i < y.size() ? y[i] : 0);
    std::vector<std::size_t> reduced;
    for (std::size_t i = 0; i < exponents.size(); ++i)
      if (exponents[i] >= generators_[i].index) {
        exponents[i] -= generators_[i].index;
        reduced.push_back(i);
      }
    Sum result;
    if (!coefficient.empty()) result.emplace(trimmed(std::move(exponents)), coefficient);
    for (const std::size_t i : reduced) result = product(result, generators_[i].power);
    return result;
  }

  Sum power(Sum x, cl_I n) {
    Sum result = number(1);
    while (true) {
      if (cln::oddp(n)) result = product(result, x);
      n = cln::ash(n, -1);
      if (cln::zerop(n)) return result;
      x = product(x, x);
      for (const auto& [monomial, coefficient] : x)
        for (const auto& [exponent, number] : coefficient)
          if (cln::integer_length(cln::numerator(number)) > 100000)
            throw BeyondBudget("an expansion with numbers too long");
    }
  }

  const Terms& terms_;
  const Work& work_;
  std::vector<std::size_t> order_;
  RootsOfUnity roots_;
  std::vector<Generator> generators_;
  std::map<cl_I, std::size_t, LessInteger> prime_generators_;
  std::map<std::size_t, Fraction> known_;
  long spent_ = 0;
};

}  // namespace

std::optional<std::string> cancels(const Terms& terms, std::size_t id, const Work& work) {
  try {
    Expansion expansion(terms, id, work);
    if (!expansion.vanishes()) return {};
    const long m = expansion.order_of_roots_used();
    const std::string roots = m > 2 ? " of exp(2 pi i/" + std::to_string(m) + ")" : "";
    return "exact arithmetic: multiplied out in powers" + roots +
           (expansion.has_radicals() ? (m > 2 ? " and radicals" : " of radicals") : "") +
           ", everything cancels";
  } catch (const BeyondBudget&) {
    work.check_time();  // a budget of terms that is spent leaves other ways, one of time does not
    return {};
  }
}

}  // namespace magicmass::algebraic
