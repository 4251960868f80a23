// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/text.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/names.hpp"
#include "proof/text_order.hpp"

namespace magicmass::proof {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

// What is around an expression, and so which of them need parentheses.
enum Precedence { sum, product, factor, power };

std::string print(const ex& e, Precedence outer);

std::string number(const numeric& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string parenthesised(bool needed, const std::string& inside) {
  return needed ? "(" + inside + ")" : inside;
}

struct Term {
  TermKey key;
  bool negative;
  std::string shown;  // without its sign
  std::string with_sign =
      {};  // with a minus, if that can go into one of its factors: -(x - y) as y - x

  bool needs_minus() const { return negative && with_sign.empty(); }
  const std::string& text() const { return negative && !with_sign.empty() ? with_sign : shown; }
};
using Terms = std::vector<Term>;

struct Power {
  ex base;
  numeric exponent;
};

Power as_power(const ex& e) {
  const bool numeric_exponent = is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1));
  return numeric_exponent ? Power{e.op(0), ex_to<numeric>(e.op(1))} : Power{e, 1};
}

Terms sorted_terms(const ex& sum_of_terms);

// A sum whose first term is negative leads with another one, if there is one that is not.
std::string join(const Terms& terms) {
  const auto first = std::find_if(terms.begin(), terms.end(),
                                  [](const Term& term) { return !term.needs_minus(); });
  std::string result;
  if (first != terms.end()) result = first->text();
  for (auto term = terms.begin(); term != terms.end(); ++term) {
    if (term == first) continue;
    const char* sign = term->needs_minus() ? (result.empty() ? "-" : " - ") : " + ";
    result += sign + term->text();
  }
  return result;
}

// base^exponent, exponent > 0.
std::string print_power(const std::string& base, const numeric& exponent) {
  if (exponent.is_equal(1)) return base;
  return base + "^" + parenthesised(!exponent.is_integer(), number(exponent));
}

std::string join(std::vector<OrderedFactor> factors) {
  std::sort(factors.begin(), factors.end());
  std::string result;
  for (const OrderedFactor& each : factors) result += (result.empty() ? "" : "*") + each.shown;
  return result;
}

// A product, a quotient or a power with a numeric exponent, on its way to be printed.
class Product {
public:
  explicit Product(std::vector<ex> parts) {
    share_scale(parts);
    for (const ex& part : parts)
      if (!is_a<numeric>(part)) add(part);
    if (scale_.is_negative()) negative_ = !negative_;
    scale_ = GiNaC::abs(scale_);
  }

  bool is_negative() const { return negative_; }
  // Nothing but one factor, so that a product around it needs no parentheses.
  bool is_single() const { return above_.size() == 1 && below_.empty() && scale_.is_equal(1); }

  std::string text() const { return text(above_, below_); }

  // The product times -1, where a sum in it can take the minus: -(x - y) z as (y - x) z. Empty if none can;
  // 1 - alpha and n - 1 stay as they are.
  std::string negative_text() const {
    for (const bool in_front : {true, false}) {
      std::vector<OrderedFactor> above = above_;
      std::vector<OrderedFactor> below = below_;
      std::vector<OrderedFactor>& factors = in_front ? above : below;
      std::sort(factors.begin(), factors.end());
      for (OrderedFactor& each : factors) {
        const auto found = reversed_.find(each.shown);
        if (found == reversed_.end()) continue;
        each.shown = found->second;
        return text(above, below);
      }
    }
    return "";
  }

  TermKey key() const {
    TermKey key;
    for (const auto* factors : {&above_, &below_})
      for (const OrderedFactor& each : *factors)
        (each.place >= Place::element ? key.functions : key.names).push_back(each);
    std::sort(key.functions.begin(), key.functions.end());
    key.mixed = !key.functions.empty() && key.functions.front().place == Place::element &&
                key.functions.back().place != Place::element;
    for (OrderedFactor& each : key.names)
      if (each.place == Place::angle) each.place = Place::name;  // x - y, though n x
    std::sort(key.names.begin(), key.names.end());
    key.degree = degree_;
    return key;
  }

private:
  std::string text(std::vector<OrderedFactor> above, std::vector<OrderedFactor> below) const {
    if (!scale_.is_rational()) {
      above.push_back({Place::number, 0, number(scale_)});
    } else {
      if (!scale_.numer().is_equal(1)) above.push_back({Place::number, 0, number(scale_.numer())});
      if (!scale_.denom().is_equal(1)) below.push_back({Place::number, 0, number(scale_.denom())});
    }
    std::string result = above.empty() ? "1" : join(above);
    if (!below.empty()) result += "/" + parenthesised(below.size() > 1, join(below));
    return result;
  }

  numeric scale_ = 1;
  bool negative_ = false;
  double degree_ = 0;
  std::vector<OrderedFactor> above_;
  std::vector<OrderedFactor> below_;
  std::map<std::string, std::string>
      reversed_;  // a sum as it is shown, and with its sign turned round

  // (2 n + 1) psi/4, as GiNaC holds it, is (n + 1/2) psi/2 to a physicist.
  void share_scale(std::vector<ex>& parts) {
    ex* of_indices = nullptr;
    for (ex& part : parts) {
      if (is_a<numeric>(part)) scale_ = ex_to<numeric>(part);
      if (place(part) == Place::index_sum && is_a<GiNaC::add>(part)) of_indices = &part;
    }
    if (of_indices == nullptr || !scale_.is_rational() || parts.size() < 3) return;
    numeric shared = scale_.denom();
    for (const ex& term : *of_indices) {
      if (is_a<numeric>(term)) continue;
      const bool scaled = is_a<GiNaC::mul>(term) && is_a<numeric>(term.op(term.nops() - 1)) &&
                          ex_to<numeric>(term.op(term.nops() - 1)).is_integer();
      shared = GiNaC::gcd(shared, scaled ? ex_to<numeric>(term.op(term.nops() - 1)) : numeric(1));
    }
    *of_indices = *of_indices / shared;
    scale_ = scale_ * shared;
  }

  void add(const ex& part) {
    const Power power = as_power(part);
    const bool inverse = power.exponent.is_negative();
    const numeric exponent = GiNaC::abs(power.exponent);
    std::string shown;
    if (exponent.denom().is_equal(2)) {
      shown = print_power("sqrt(" + print(power.base, Precedence::sum) + ")", exponent.numer());
    } else if (is_a<GiNaC::add>(power.base)) {
      Terms terms = sorted_terms(power.base);
      if (terms.front().negative && exponent.is_integer()) {  // x - y where GiNaC holds -(y - x)
        for (Term& term : terms) term.negative = !term.negative;
        if (exponent.is_odd()) negative_ = !negative_;
      }
      shown = print_power("(" + join(terms) + ")", exponent);
      const auto minus =
          std::count_if(terms.begin(), terms.end(), [](const Term& term) { return term.negative; });
      const bool plain = std::none_of(terms.begin(), terms.end(),
                                      [](const Term& term) { return term.key.constant != 0; });
      if (plain && exponent.is_equal(1) && 2 * minus >= static_cast<std::ptrdiff_t>(terms.size())) {
        for (Term& term : terms) term.negative = !term.negative;
        reversed_[shown] = "(" + join(terms) + ")";
      }
    } else {
      shown = print_power(print(power.base, exponent.is_equal(1) ? factor : Precedence::power),
                          exponent);
    }
    if (is_a<GiNaC::symbol>(power.base)) degree_ += power.exponent.to_double();
    (inverse ? below_ : above_).push_back(ordered(part, std::move(shown)));
  }
};

Product as_product(const ex& e) {
  return Product(is_a<GiNaC::mul>(e) ? std::vector<ex>(e.begin(), e.end()) : std::vector<ex>{e});
}

Terms sorted_terms(const ex& sum_of_terms) {
  const bool of_indices = is_sum_of_indices(sum_of_terms);
  Terms terms;
  for (const ex& term : sum_of_terms) {
    if (is_a<numeric>(term)) {
      const numeric value = ex_to<numeric>(term);
      TermKey key;
      key.constant = of_indices ? 1 : -1;
      terms.push_back({key, value.is_negative(), number(value.is_negative() ? -value : value)});
    } else {
      const Product product = as_product(term);
      terms.push_back(
          {product.key(), product.is_negative(), product.text(), product.negative_text()});
    }
  }
  std::sort(terms.begin(), terms.end(), [](const Term& x, const Term& y) {
    return std::tie(x.key, x.shown) < std::tie(y.key, y.shown);
  });
  return terms;
}

std::string print_product(const Product& shown, Precedence outer) {
  const std::string absorbed = shown.is_negative() ? shown.negative_text() : "";
  const bool minus = shown.is_negative() && absorbed.empty();
  const std::string inside = minus              ? "-" + shown.text()
                             : absorbed.empty() ? shown.text()
                                                : absorbed;
  return parenthesised((outer > product && (minus || !shown.is_single())) || (minus && outer > sum),
                       inside);
}

std::string print_matrix(const GiNaC::matrix& m) {
  std::string result = "[";
  for (unsigned row = 0; row < m.rows(); ++row) {
    result += row == 0 ? "[" : ", [";
    for (unsigned column = 0; column < m.cols(); ++column)
      result += (column == 0 ? "" : ", ") + print(m(row, column), sum);
    result += "]";
  }
  return result + "]";
}

// v_A(n), or v_A(n; 1/2, 1, e) at other parameters than the general ones.
std::string print(const ex& e, Precedence outer) {
  if (is_a<numeric>(e)) {
    const numeric value = ex_to<numeric>(e);
    const bool compound = value.is_negative() || !value.is_integer();
    return parenthesised(compound && outer > (value.is_negative() ? sum : product), number(value));
  }
  if (is_a<GiNaC::symbol>(e)) return ex_to<GiNaC::symbol>(e).get_name();
  if (e.is_equal(GiNaC::Pi)) return "pi";
  if (is_a<GiNaC::add>(e)) return parenthesised(outer > sum, join(sorted_terms(e)));
  if (is_a<GiNaC::mul>(e)) return print_product(as_product(e), outer);
  if (is_a<GiNaC::power>(e)) {
    if (!is_a<numeric>(e.op(1)))
      return parenthesised(outer == Precedence::power, print(e.op(0), Precedence::power) + "^" +
                                                           print(e.op(1), Precedence::power));
    const Product shown = as_product(e);  // x^2 as the base of a power is not closed, sqrt(x) is
    const bool open = shown.is_single() && !as_power(e).exponent.is_equal(numeric(1, 2));
    return parenthesised(outer == Precedence::power && open, print_product(shown, outer));
  }
  if (is_a<GiNaC::matrix>(e)) return print_matrix(ex_to<GiNaC::matrix>(e));
  if (is_family(e)) return family_text(e);
  if (is_a<GiNaC::function>(e)) {
    std::string arguments;
    for (const ex& argument : e)
      arguments += (arguments.empty() ? "" : ", ") + print(argument, sum);
    return function_name(e) + "(" + arguments + ")";
  }
  std::ostringstream out;  // anything else prints as GiNaC has it
  out << e;
  return out.str();
}

}  // namespace

bool leads_with_minus(const ex& sum_of_terms) {
  return sorted_terms(sum_of_terms).front().negative;
}

std::string to_text(const ex& e) { return print(e, sum); }

}  // namespace magicmass::proof
