// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/expansion.hpp"

#include <map>
#include <stdexcept>
#include <vector>

#include "algebraic/prime_powers.hpp"
#include "algebraic/radical_ring.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;

using Number = RadicalRing::Number;

struct LessInteger {
  bool operator()(const cl_I& x, const cl_I& y) const { return x < y; }
};

struct Fraction {
  Number above;
  Number below;  ///< not 0
};

class Expansion {
public:
  Expansion(const Terms& terms, std::size_t id, const Work& work)
      : terms_(terms), order_(terms.below(id)), ring_(order_of_roots(), work) {
    make_prime_generators();
  }

  std::optional<bool> is_zero() {
    for (const std::size_t id : order_) known_.emplace(id, fraction(terms_[id]));
    return ring_.is_zero(known_.at(order_.back()).above);
  }

  const RadicalRing& ring() const { return ring_; }

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
      const long n = cln::cl_I_to_long(index);
      prime_generators_.emplace(prime, PrimeGenerator{n, ring_.generator(n, number(prime))});
    }
  }

  Fraction fraction(const Term& term) {
    const auto part = [&](std::size_t i) -> const Fraction& { return known_.at(term.parts[i]); };
    Fraction result = term.parts.empty() ? Fraction{} : part(0);
    switch (term.kind) {
      case Kind::rational:
        return {number(term.value), number(1)};
      case Kind::cosine:
        return {ring_.cosine(term.value), number(1)};
      case Kind::sum:
        for (std::size_t i = 1; i < term.parts.size(); ++i) result = sum(result, part(i));
        return result;
      case Kind::product:
        for (std::size_t i = 1; i < term.parts.size(); ++i)
          result = {ring_.product(result.above, part(i).above),
                    ring_.product(result.below, part(i).below)};
        return result;
      case Kind::power: {
        const cl_I n = cln::abs(term.exponent);
        result = {ring_.power(result.above, n), ring_.power(result.below, n)};
        return cln::plusp(term.exponent) ? result : Fraction{result.below, result.above};
      }
      case Kind::root:
        return is_rational_root(term) ? Fraction{rational_root(term), number(1)} : root(term);
    }
    throw std::logic_error("a kind of term that cannot be expanded");
  }

  Fraction sum(const Fraction& x, const Fraction& y) {
    if (x.below == y.below) return {RadicalRing::sum(x.above, y.above), x.below};
    return {RadicalRing::sum(ring_.product(x.above, y.below), ring_.product(y.above, x.below)),
            ring_.product(x.below, y.below)};
  }

  Number rational_root(const Term& term) {
    Number result = number(1);
    for (const auto& [prime, exponent] : prime_powers(terms_[term.parts[0]].value)) {
      const PrimeGenerator& generator = prime_generators_.at(prime);
      const long scaled = exponent * (generator.index / cln::cl_I_to_long(term.exponent));
      const long rest = ((scaled % generator.index) + generator.index) % generator.index;
      const cl_RA whole = cln::expt(cl_RA(prime), cl_I((scaled - rest) / generator.index));
      result = ring_.product(result, RadicalRing::power_of_generator(generator.place, rest, whole));
    }
    return result;
  }

  /// (a/b)^(1/n) = (a b^(n-1))^(1/n)/b for a, b > 0.
  Fraction root(const Term& term) {
    Fraction radicand = known_.at(term.parts[0]);
    const std::optional<int> sign = ring_.sign_of_nonzero(radicand.below);
    if (!sign) throw BeyondBudget("a divisor too close to 0");
    if (*sign < 0)
      for (Number* part : {&radicand.above, &radicand.below})
        *part = ring_.product(*part, number(-1));
    const long index = cln::cl_I_to_long(term.exponent);
    const Number power =
        radicand.below == number(1)
            ? radicand.above
            : ring_.product(radicand.above, ring_.power(radicand.below, index - 1));
    return {RadicalRing::power_of_generator(ring_.generator(index, power), 1, 1), radicand.below};
  }

  static Number number(const cl_RA& value) { return RadicalRing::number(value); }

  struct PrimeGenerator {
    long index;
    std::size_t place;
  };

  const Terms& terms_;
  std::vector<std::size_t> order_;
  RadicalRing ring_;
  std::map<cl_I, PrimeGenerator, LessInteger> prime_generators_;
  std::map<std::size_t, Fraction> known_;
};

}  // namespace

std::optional<std::string> proof_of_zero(const Terms& terms, std::size_t id, const Work& work) {
  try {
    Expansion expansion(terms, id, work);
    if (expansion.is_zero() != true) return {};
    const long m = expansion.ring().roots().order();
    std::string method = "exact arithmetic: ";
    if (m > 2) method += "with cosines in powers of exp(2 pi i/" + std::to_string(m) + "), ";
    if (expansion.ring().generators() > 0) return method + "multiplied out, all radicals cancel";
    return method + "everything cancels";
  } catch (const BeyondBudget&) {
    work.check_time();  // a budget of terms that is spent leaves other ways, one of time does not
    return {};
  }
}

}  // namespace magicmass::algebraic
