// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/translation.hpp"

#include <algorithm>

#include <cln/integer.h>

#include "equality/angle.hpp"
#include "equality/constant.hpp"
#include "equality/evaluate.hpp"
#include "equality/point.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::equality {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using proof::NotInClass;

namespace {

constexpr int sign_digits = 200;
constexpr std::size_t most_names = 300;  // new symbols for constants and powers, named before the kernel starts

bool is_simple_constant(const Tree& tree) {
  if (is_number(tree) || tree->kind == Kind::pi) return true;
  if (tree->kind == Kind::root)
    return tree->value == 2 && is_number(tree->parts[0]) && tree->parts[0]->value > 0;
  return tree->kind == Kind::product &&
         std::all_of(tree->parts.begin(), tree->parts.end(), is_simple_constant);
}

std::string constant_name(std::size_t index) { return "constant_" + std::to_string(index); }

}  // namespace

Translation::Translation(const Domain& domain, const Manner& manner) : manner_(manner) {
  for (const auto& [name, range] : domain.ranges) {
    const ex symbol = proof::symbol(name);
    values_[name] = symbol;
    variables_.push_back(symbol);
    if (range.is_integer) {
      integers_.insert(symbol);
      if (!range.low) continue;
      cln::cl_I first = cln::ceiling1(*range.low);
      if (first == *range.low && !range.has_low) first = first + 1;
      if (cln::integer_length(first) > 30) continue;
      domain_.integer[name] = cln::cl_I_to_long(first);
      continue;
    }
    if (manner.view == View::wide) {
      if (range.low && (*range.low > 0 || (*range.low == 0 && !range.has_low)))
        domain_.positive.insert(name);
      continue;
    }
    if (!range.low && !range.high) continue;
    domain_.positive.insert(name);  // t
    if (range.low && range.high)
      values_[name] = (numeric(*range.low) + numeric(*range.high) * symbol) / (1 + symbol);
    else if (range.low)
      values_[name] = numeric(*range.low) + symbol;
    else
      values_[name] = numeric(*range.high) - symbol;
  }
  for (std::size_t i = 0; i < most_names; ++i) domain_.positive.insert(constant_name(i));
  form_ = std::make_unique<proof::NormalForm>(domain_, proof::Definitions{});
}

ex Translation::operator()(const Tree& tree) {
  try {
    return translated(tree);
  } catch (const GiNaC::pole_error& error) {
    throw NotInClass(error.what());
  }
}

ex Translation::named(const std::string& key, const Tree& value) {
  if (const auto known = keys_.find(key); known != keys_.end()) return proof::symbol(known->second);
  if (keys_.size() >= most_names) throw NotInClass("too many different constants and powers");
  const std::string name = constant_name(keys_.size());
  keys_[key] = name;
  if (value) named_[name] = value;
  return proof::symbol(name);
}

ex Translation::translated(const Tree& tree) {
  if (tree->is_constant && (manner_.named_constants || is_simple_constant(tree)))
    return translated_constant(at({}, tree));
  switch (tree->kind) {
    case Kind::symbol:
      return values_.at(tree->name);
    case Kind::sum: {
      ex total = 0;
      for (const Tree& part : tree->parts) total += translated(part);
      return total;
    }
    case Kind::product: {
      ex total = 1;
      for (const Tree& part : tree->parts) total *= translated(part);
      return total;
    }
    case Kind::quotient: {
      const ex below = translated(tree->parts[1]);
      if (form_->is_zero(below)) throw NotInClass("division by zero: " + text(tree));
      return translated(tree->parts[0]) / below;
    }
    case Kind::power:
      return power(tree);
    case Kind::root:
      return root(tree);
    default:
      return function(tree);
  }
}

ex Translation::translated_constant(const Tree& tree) {
  if (is_simple_constant(tree)) {
    if (is_number(tree)) return numeric(tree->value);
    if (tree->kind == Kind::pi) return GiNaC::Pi;
    if (tree->kind == Kind::root) return sqrt(ex(numeric(tree->parts[0]->value)));
    ex total = 1;
    for (const Tree& part : tree->parts) total *= translated_constant(part);
    return total;
  }
  std::optional<int> sign;
  try {
    sign = equality::sign(evaluate_to(tree, sign_digits, exact_sign_or_nothing));
  } catch (const NotCertain&) {
  } catch (const NotDefined& error) {
    throw NotInClass(error.what());
  }
  if (!sign) sign = exact_sign_or_nothing(tree);
  if (!sign) throw NotInClass("the sign of a constant is not certain: " + text(tree));
  if (*sign == 0) return 0;
  const Tree positive = *sign > 0 ? tree : product({number(-1), tree});
  for (const auto& [name, value] : named_) {  // the same number in another form
    if (identical(value, positive)) return *sign * proof::symbol(name);
    const Tree rest = difference(value, positive);
    try {
      if (equality::sign(evaluate_to(rest, 60, {}))) continue;
    } catch (const NotCertain&) {
    }
    const auto exact = exact_sign_or_nothing(rest);
    if (exact && *exact == 0) return *sign * proof::symbol(name);
  }
  return *sign * named(text(positive), positive);
}

ex Translation::power(const Tree& tree) {
  const Tree& base = tree->parts[0];
  const Tree exponent = at({}, tree->parts[1]);
  if (is_number(exponent)) {
    const numeric n(exponent->value);
    if (!n.is_integer() && n.denom() > 2) throw NotInClass("a root of order 3 or more");
    const ex below = translated(base);
    if (n.is_negative() && form_->is_zero(below))
      throw NotInClass("division by zero: " + text(tree));
    return GiNaC::pow(below, n);
  }
  const ex above = translated(exponent).expand();
  if (is_number(base) && base->value < 0) {  // defined for whole exponents: (-r)^m = r^m cos(m pi)
    if (!is_integer_valued(above)) throw NotInClass("a power of a negative number: " + text(tree));
    const ex sign = cos(without_full_turns((above * GiNaC::Pi).expand()));
    const Tree positive = number(-base->value);
    return sign * (is_number(positive, 1) ? ex(1) : exponential(text(positive), positive, above));
  }
  const ex below = translated(base);
  if (!form_->is_positive(below)) throw NotInClass("a power of an unknown sign: " + text(tree));
  return exponential(proof::text(form_->simplified(below)), base, above);
}

// base^exponent for base > 0: base^(a + b) = base^a base^b, and one positive generator for base^(monomial/2).
ex Translation::exponential(const std::string& base, const Tree& tree, const ex& exponent) {
  ex total = 1;
  const auto multiply = [&](const ex& monomial) {
    if (is_a<numeric>(monomial)) {
      const numeric n = ex_to<numeric>(monomial);
      const ex below = tree ? translated(tree) : ex(named("exp(1)", equality::function("exp", number(1))));
      if (!n.is_rational() || n.denom() > 2) throw NotInClass("a root of order 3 or more");
      total *= GiNaC::pow(below, n);
      return;
    }
    numeric factor = 1;
    if (is_a<GiNaC::mul>(monomial))
      for (const ex& part : monomial)
        if (is_a<numeric>(part)) factor = ex_to<numeric>(part);
    if (!factor.is_rational()) throw NotInClass("an exponent that is not rational");
    const numeric below = factor.denom().is_equal(1) ? numeric(2) : factor.denom();
    const ex unit = monomial / factor / below;
    const numeric count = factor * below;
    if (GiNaC::abs(count) > 100) throw NotInClass("too large an exponent");
    total *= GiNaC::pow(named(base + "^(" + proof::text(unit) + ")", nullptr), count);
  };
  const ex expanded = form_->simplified(exponent).expand();
  if (is_a<GiNaC::add>(expanded))
    for (const ex& monomial : expanded) multiply(monomial);
  else
    multiply(expanded);
  return total;
}

ex Translation::root(const Tree& tree) {
  if (tree->value != 2) throw NotInClass("a root of order 3 or more: " + text(tree));
  return sqrt(translated(tree->parts[0]));
}

ex Translation::absolute(const Tree& argument) {
  const ex x = translated(argument);
  if (form_->is_positive(x)) return x;
  if (form_->is_positive(-x)) return -x;
  return sqrt(x * x);
}

// For all -1 <= u <= 1.
ex Translation::arcsine(const ex& u) { return 2 * atan(u / (1 + sqrt(1 - u * u))); }

ex Translation::function(const Tree& tree) {
  const Tree& argument = tree->parts[0];
  const std::string& name = tree->name;
  if (name == "abs") return absolute(argument);
  if (name == "cos") return cos(angle(argument));
  if (name == "sin") return sin(angle(argument));
  if (name == "tan") return tan(angle(argument));
  const ex u = translated(argument);
  if (manner_.kept_inverses && name == "asin") return asin(u);
  if (manner_.kept_inverses && name == "acos") return acos(u);
  if (name == "atan") return atan(u);
  if (name == "log") return log(u);  // outside of the class; its derivative is not
  if (name == "asin") return arcsine(u);
  if (name == "acos") {
    // 2 atan(sqrt((1 - u)/(1 + u))) has algebraic halves, but wants u != -1
    if (form_->is_positive(1 + u)) return 2 * atan(sqrt((1 - u) / (1 + u)));
    return GiNaC::Pi / 2 - arcsine(u);
  }
  if (name == "exp") return exponential("exp(1)", nullptr, u.expand());
  throw NotInClass("no normal form for " + name);
}

ex Translation::angle_of_constant(const Tree& tree) {
  const LinearForm linear = linear_form(at({}, tree));
  ex total = numeric(linear.of_pi) * GiNaC::Pi;
  for (const auto& [factor, inverse] : linear.terms) {
    if (inverse->name == "log") throw NotInClass("a logarithm in an angle");
    total += numeric(factor) * translated(inverse);
  }
  for (const Tree& rest : linear.rest) {  // an identity for every such angle holds for this one
    const Tree folded = at({}, rest);
    total += is_number(folded) ? ex(numeric(folded->value)) * named("1 radian", number(1))
                               : translated(folded);
  }
  return total;
}

ex Translation::angle(const Tree& tree) {
  const auto sum_of_parts = [this](const auto& self, const Tree& part) -> ex {
    if (part->is_constant) return angle_of_constant(part);
    if (part->kind == Kind::sum) {
      ex total = 0;
      for (const Tree& summand : part->parts) total += self(self, summand);
      return total;
    }
    return translated(part);
  };
  return without_full_turns(sum_of_parts(sum_of_parts, tree).expand());
}

bool Translation::is_integer_valued(const ex& expanded) const {
  if (is_a<numeric>(expanded)) return ex_to<numeric>(expanded).is_integer();
  if (is_a<GiNaC::symbol>(expanded)) return integers_.contains(expanded);
  if (is_a<GiNaC::power>(expanded))
    return is_integer_valued(expanded.op(0)) && expanded.op(1).info(GiNaC::info_flags::posint);
  return (is_a<GiNaC::add>(expanded) || is_a<GiNaC::mul>(expanded)) &&
         std::all_of(expanded.begin(), expanded.end(),
                     [this](const ex& part) { return is_integer_valued(part); });
}

// cos and sin do not see 2 pi n m for integers n, m.
ex Translation::without_full_turns(const ex& angle) const {
  ex rest = 0;
  const auto keep = [&](const ex& monomial) {
    bool has_pi = false;
    bool has_integer = false;
    bool is_even = false;
    bool other = false;
    const auto inspect = [&](const ex& part) {
      if (part.is_equal(GiNaC::Pi)) {
        other = other || has_pi;
        has_pi = true;
      } else if (is_a<numeric>(part)) {
        is_even = ex_to<numeric>(part).is_even();
        other = other || !ex_to<numeric>(part).is_integer();
      } else if (integers_.contains(part)) {
        has_integer = true;
      } else if (is_a<GiNaC::power>(part) && integers_.contains(part.op(0)) &&
                 part.op(1).info(GiNaC::info_flags::posint)) {
        has_integer = true;
      } else {
        other = true;
      }
    };
    if (is_a<GiNaC::mul>(monomial))
      for (const ex& part : monomial) inspect(part);
    else
      inspect(monomial);
    if (!(has_pi && has_integer && is_even && !other)) rest += monomial;
  };
  if (is_a<GiNaC::add>(angle))
    for (const ex& monomial : angle) keep(monomial);
  else
    keep(angle);
  return rest;
}

}  // namespace magicmass::equality
