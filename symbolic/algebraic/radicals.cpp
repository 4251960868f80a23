// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/radicals.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <ginac/ginac.h>

#include "algebraic/constant.hpp"
#include "algebraic/cosine_field.hpp"
#include "algebraic/surd.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::algebraic {
namespace {

constexpr long largest_split_degree = 8;

using cln::cl_RA;
using Element = CosineField::Element;

/// Shortest is best, but less nesting comes first.
std::pair<long, std::size_t> cost(const Surd& surd) {
  std::pair<long, std::size_t> result{0, to_text(surd).size()};
  for (const SurdTerm& term : surd.terms)
    result.first = std::max(result.first, 1 + cost(term.radicand).first);
  return result;
}

/// Writes elements of a field whose automorphisms form a 2-group in square roots. Let H be the automorphisms that fix
/// x, and t another one with t t in H. Then (x + t x)/2 and ((x - t x)/2)^2 are fixed by t too, and
/// x = (x + t x)/2 +- sqrt(((x - t x)/2)^2): halving of an angle and Gauss's periods are cases of this. All t are
/// tried, and the best form is kept.
class Splitting {
public:
  explicit Splitting(const CosineField& field) : field_(field) {}

  const Surd& of(const Element& x) {
    if (const auto found = known_.find(x); found != known_.end()) return found->second;
    return known_.emplace(x, best(x)).first->second;
  }

private:
  struct Less {
    bool operator()(const Element& x, const Element& y) const {
      return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    }
  };

  Surd best(const Element& x) {
    std::optional<Surd> result;
    std::vector<Element> tried = {x};
    for (const long t : field_.automorphisms()) {
      const Element image = field_.image(t, x);
      if (std::find(tried.begin(), tried.end(), image) != tried.end()) continue;
      if (field_.image(t, image) != x) continue;
      tried.push_back(image);
      const cl_RA half = cl_RA(1) / 2;
      const Element middle = CosineField::combination(half, x, half, image);
      const Element distance = CosineField::combination(half, x, -half, image);
      const Surd root = square_root(of(field_.product(distance, distance)), field_.sign(distance));
      Surd form = sum(of(middle), root);
      if (!result || cost(form) < cost(*result)) result = std::move(form);
    }
    return result ? *result : Surd{x[0], {}};  // fixed by all: a rational number
  }

  const CosineField& field_;
  std::map<Element, Surd, Less> known_;
};

/// sec(pi/n) - 1 as text and as a number.
struct Form {
  std::string text;
  GiNaC::ex value;
};

Form by_sum(const CosineField& field, Splitting& splitting) {
  const Surd form =
      splitting.of(CosineField::combination(2, field.generator_inverse(), -1, field.number(1)));
  return {to_text(form), expression(form)};
}

Form by_division(const Surd& twice_cosine) {
  const bool sum = twice_cosine.terms.size() > 1 || !cln::zerop(twice_cosine.rational);
  const std::string below = to_text(twice_cosine);
  return {"2/" + (sum ? "(" + below + ")" : below) + " - 1", 2 / expression(twice_cosine) - 1};
}

/// Halving alone: 2 cos(x/2) = sqrt(2 + 2 cos x).
Surd half_angle(const Surd& twice_cosine) { return square_root(sum(Surd{2, {}}, twice_cosine), 1); }

/// phi(2n)/2, n >= 3, if that is a power of 2, else 0: n must be a power of 2 times different primes 2^(2^i) + 1.
long constructible_degree(long n) {
  long totient = 1;
  for (; n % 2 == 0; n /= 2) totient *= 2;
  for (const long prime : {3L, 5L, 17L, 257L, 65537L})
    if (n % prime == 0) {
      n /= prime;
      totient *= prime - 1;
    }
  return n == 1 ? totient / 2 : 0;
}

void require_polygon(long n) {
  if (n < 3)
    throw InvalidInput("sec(pi/n) is asked for with n = " + std::to_string(n) +
                       "; n must be 3 or more");
}

/// 2 cos(pi/n), constructible: halvings of the last angle whose field is small enough to be split.
std::optional<Surd> twice_cosine(long n) {
  if (constructible_degree(n) > largest_split_degree) {
    const std::optional<Surd> twice = n % 2 == 0 ? twice_cosine(n / 2) : std::nullopt;
    return twice ? std::optional(half_angle(*twice)) : std::nullopt;
  }
  const CosineField field(2 * n);
  return Splitting(field).of(field.generator());
}

std::optional<Form> shortest(long n) {
  if (constructible_degree(n) > largest_split_degree) {
    const std::optional<Surd> below = twice_cosine(n);
    return below ? std::optional(by_division(*below)) : std::nullopt;
  }
  const CosineField field(2 * n);
  Splitting splitting(field);
  Form divided = by_division(splitting.of(field.generator()));
  Form summed = by_sum(field, splitting);
  return divided.text.size() < summed.text.size() ? divided : summed;
}

}  // namespace

// A Fermat prime beyond the five known ones has more than 10^9 digits, so constructible_degree misses no long.
bool real_radicals_exist(long n) {
  require_polygon(n);
  return constructible_degree(n) > 0;
}

std::optional<std::string> secant_radicals(long n) {
  require_polygon(n);
  if (n == 3) return "1";
  // Each halving nests the roots once more.
  const long degree = constructible_degree(n);
  if (degree == 0 || degree > largest_radical_degree) return {};
  const std::optional<Form> form = shortest(n);
  if (!form || form->text.size() > longest_radicals) return {};
  if (sign_of(form->value - (1 / GiNaC::cos(GiNaC::Pi / n) - 1)).sign != 0)
    throw std::logic_error("not proved: sec(pi/" + std::to_string(n) + ") - 1 = " + form->text);
  return form->text;
}

std::optional<std::string> magic_radicals(long k) { return secant_radicals(2 * k + 1); }
std::optional<std::string> deficient_radicals(long k) { return secant_radicals(2 * (k + 1)); }

}  // namespace magicmass::algebraic
