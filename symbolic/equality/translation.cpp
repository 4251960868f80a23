// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/translation.hpp"

#include <algorithm>

#include <cln/integer.h>

#include "equality/constant.hpp"
#include "equality/evaluate.hpp"
#include "equality/point.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::equality {

using GiNaC::ex;
using GiNaC::numeric;
using proof::NotInClass;

namespace {

constexpr int sign_digits = 200;
constexpr std::size_t most_names =
    300;  // new symbols for constants and powers, named before the kernel starts

bool is_simple_constant(const Tree& tree) {
  if (is_number(tree) || tree->kind == Kind::pi) return true;
  if (tree->kind == Kind::root)
    return tree->value == 2 && is_number(tree->parts[0]) && tree->parts[0]->value > 0;
  return tree->kind == Kind::product &&
         std::all_of(tree->parts.begin(), tree->parts.end(), is_simple_constant);
}

// Longer than any name that can be typed (parse.cpp): what is known of it is known of no symbol of the user's.
std::string constant_name(std::size_t index) {
  return "name_of_a_constant_or_power_that_nobody_typed_" + std::to_string(index);
}

std::string unsigned_name(std::size_t index) {
  return "value_of_a_function_of_which_nothing_is_known_" + std::to_string(index);
}

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
      if (range.low && (*range.low > 0 || (*range.low == 0 && !range.has_low))) {
        domain_.positive.insert(name);
        values_[name] = GiNaC::pow(symbol, manner.power);
      }
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
      if (form_->is_zero(below)) throw NotInClass("division by zero: " + to_text(tree));
      return translated(tree->parts[0]) / below;
    }
    case Kind::power:
      return power(tree);
    case Kind::root:
      return root(translated(tree->parts[0]), cln::cl_I_to_long(cln::numerator(tree->value)), tree);
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
  if (!sign) throw NotInClass("the sign of a constant is not certain: " + to_text(tree));
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
  return *sign * named(to_text(positive), positive);
}

ex Translation::absolute(const Tree& argument) {
  const ex x = translated(argument);
  if (form_->is_positive(x)) return x;
  if (form_->is_positive(-x)) return -x;
  return square_root(x * x);
}

// For all -1 <= u <= 1.
ex Translation::arcsine(const ex& u) { return 2 * atan(u / (1 + sqrt(1 - u * u))); }

ex Translation::function(const Tree& tree) {
  const Tree& argument = tree->parts[0];
  const std::string& name = tree->name;
  if (name == "abs") return absolute(argument);
  if (manner_.halved_angles && (name == "cos" || name == "sin")) {
    const ex half = angle(argument) / 2;
    return name == "cos" ? ex(pow(cos(half), 2) - pow(sin(half), 2)) : 2 * sin(half) * cos(half);
  }
  if (name == "cos") return cosine_and_sine(argument).first;
  if (name == "sin") return cosine_and_sine(argument).second;
  if (name == "tan") {
    const auto [cosine, sine] = cosine_and_sine(argument);
    if (form_->is_zero(cosine)) throw NotInClass("division by zero: " + to_text(tree));
    return sine / cosine;
  }
  const ex u = translated(argument);
  if (manner_.kept_inverses && name == "asin") return asin(u);
  if (manner_.kept_inverses && name == "acos") return acos(u);
  if (name == "atan") return atan(u);
  if (name == "log") {
    if (manner_.kept_inverses) return log(u);  // outside of the class; its derivative is not
    const std::string key = "log(" + proof::to_text(form_->simplified(u)) + ")";
    return proof::symbol(keys_.try_emplace(key, unsigned_name(keys_.size())).first->second);
  }
  if (name == "asin") return arcsine(u);
  if (name == "acos") {
    // 2 atan(sqrt((1 - u)/(1 + u))) has algebraic halves, but wants u != -1
    if (form_->is_positive(1 + u)) return 2 * atan(sqrt((1 - u) / (1 + u)));
    return GiNaC::Pi / 2 - arcsine(u);
  }
  if (name == "exp")
    return exponential("exp(1)", named("exp(1)", equality::function("exp", number(1))), u.expand());
  throw NotInClass("no normal form for " + name);
}

}  // namespace magicmass::equality
