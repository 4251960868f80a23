// SPDX-License-Identifier: GPL-2.0-or-later
// Signs that are certain all over a domain.
#include "equality/normal_form.hpp"

namespace equality {
using kernel::Op;
namespace {
constexpr int deepest = 8;
// 2: positive, 1: not negative, 0: not known, -1 and -2 likewise.
int product(int a, int b) {
  if (a == 0 || b == 0) return 0;
  const int size = std::min(std::abs(a), std::abs(b));
  return (a > 0) == (b > 0) ? size : -size;
}
int sign_on(const Range& range) {
  const int strength = range.contains(0) ? 1 : 2;
  if (range.low && range.low->value >= 0) return strength;
  if (range.high && range.high->value <= 0) return -strength;
  return 0;
}
}  // namespace

int Forms::sign_of_atom(Expr atom) {
  if (atom.op() == Op::Num) return 2;
  if (atom == kernel::pi() || atom == euler()) return 2;
  if (is_complex(atom)) return 0;
  if (const auto it = assumed_signs.find(atom); it != assumed_signs.end()) return it->second;
  const auto is_not_zero = [&](Expr e) { return assumed_not_zero.contains(e); };
  int sign = 0;
  if (const auto it = where.ranges.find(atom); it != where.ranges.end()) {
    sign = sign_on(it->second);
  } else if (is_function(atom, "abs")) {
    sign = is_not_zero(atom.arg(0)) ? 2 : 1;
  } else if (composites.contains(atom)) {
    sign = sign_of_composite(composites.at(atom));
  } else if (depth < deepest) {
    ++depth;
    if (is_function(atom, "log")) sign = sign_of(of(atom.arg(0)) - number(1));
    if (is_inverse_angle(atom)) sign = sign_of(of(atom.arg(0)));
    --depth;
  }
  return std::abs(sign) == 1 && is_not_zero(atom) ? 2 * sign : sign;
}

int Forms::sign_of(const Sum& sum) {
  for (int sign : {2, -2, 1, -1})
    if (has_sign(sum, sign > 0 ? 1 : -1, std::abs(sign) == 2)) return sign;
  return 0;
}
int Forms::sign_of_powers(const Product& powers) {
  int sign = 2;
  for (const auto& [atom, e] : powers) {
    if (is_complex(atom)) return 0;
    const auto k = number_of(e);
    const bool is_integer = k && is_whole(*k);
    int one = sign_of_atom(atom);
    if (is_integer && is_even(*k))
      one = std::abs(one) == 2 || assumed_not_zero.contains(atom) ? 2 : 1;
    else if (k && cln::evenp(cln::denominator(*k)))
      one = std::max(one, 1);  // a root is not negative
    else if (one < 0 && !is_integer)
      one = 0;
    sign = product(sign, one);
    if (sign == 0) return 0;
  }
  return sign;
}
bool Forms::has_sign(const Sum& sum, int sign, bool strictly) {
  if (sum.empty()) return !strictly;
  const auto fits = [&](int found) { return found * sign >= (strictly ? 2 : 1); };
  for (const auto& [known, strength] : assumed) {
    const cln::cl_RA ratio = sum.begin()->second / known.begin()->second;
    if (scaled(known, ratio) == sum && fits(ratio > 0 ? strength : -strength)) return true;
  }
  const Factors f = factors(sum);
  if (fits(product(sign_of_powers(f.powers), f.number > 0 ? 2 : -2))) return true;
  return fits(sign_of_composite(sum));
}

int Forms::sign_of_composite(const Sum& sum) {
  if (depth >= deepest) return 0;
  const auto known = signs.find(sum);  // not known from as deep is not known from here
  if (known != signs.end() && (known->second.first != 0 || known->second.second <= depth))
    return known->second.first;
  ++depth;
  int sign = 0;
  for (int (Forms::*rule)(const Sum&) :
       {&Forms::sign_by_terms, &Forms::sign_of_number, &Forms::sign_of_trigonometric,
        &Forms::sign_of_cosine, &Forms::sign_by_shift, &Forms::sign_of_two})
    if (sign == 0) sign = (this->*rule)(sum);
  --depth;
  signs[sum] = {sign, depth};
  return sign;
}
int Forms::sign_by_terms(const Sum& sum) {
  const auto constant = [](Expr atom, const Exponent& e) {  // pi/2 - 1 of pi/2 s - s
    const bool is_number = atom != circle() && kernel::free_variables(atom).empty() && number_of(e);
    return is_number ? e : Exponent();
  };
  int total = 0;
  for (const auto& [powers, coefficient] : coefficients(sum, constant)) {
    const int sign = product(sign_of_powers(powers), sign_of_number(coefficient));
    if (sign == 0 || product(total, sign) < 0) return 0;
    total = std::abs(sign) > std::abs(total) ? sign : total;
  }
  return total;
}
int Forms::sign_of_number(const Sum& sum) {
  const std::optional<Expr> e = real_expression(sum);
  if (!e || !kernel::free_variables(*e).empty()) return 0;
  return 2 * exact_sign(*e).value_or(0);
}
// c + sum of c_i z^u_i is at least c - sum of |c_i|, where it is real.
int Forms::sign_of_trigonometric(const Sum& sum) {
  cln::cl_RA constant = 0;
  cln::cl_RA others = 0;
  for (const auto& [powers, q] : sum) {
    if (powers.empty())
      constant = q;
    else if (powers.size() == 1 && powers.begin()->first == circle())
      others = others + cln::abs(q);
    else
      return 0;
  }
  if (cln::abs(constant) < others || constant == 0) return 0;
  return (constant > 0 ? 1 : -1) * (cln::abs(constant) > others ? 2 : 1);
}
// z^u + z^-u is positive for u between -pi/2 and pi/2; z^(u + pi) is -z^u.
int Forms::sign_of_cosine(const Sum& sum) {
  if (sum.size() != 2) return 0;
  Product there = sum.begin()->first, back = sum.rbegin()->first;
  const cln::cl_RA q = sum.begin()->second;
  const Exponent u = there[circle()], both = u + back[circle()];
  const cln::cl_RA turns = both.empty() ? cln::cl_RA(0) : both.begin()->second;  // by pi
  if (!is_whole(turns) || both != times_pi(turns)) return 0;
  there.erase(circle());
  back.erase(circle());
  if (there != back || sum.rbegin()->second != (is_even(turns) ? q : -q)) return 0;
  const Sum quarter = scaled(atom(kernel::pi()), cln::cl_RA(1) / 2);
  for (int shift : {0, 1, -1}) {
    const Sum angle = sum_of(u) + scaled(quarter, 2 * shift);
    const int sign = product(sign_of(quarter - angle), sign_of(quarter + angle));
    if (sign > 0) return product(sign_of_powers(there), (q > 0) == (shift == 0) ? sign : -sign);
  }
  return 0;
}
// a - b for positive a and b has the sign of log(a/b).
int Forms::sign_of_two(const Sum& sum) {
  if (sum.size() != 2) return 0;
  const auto& [first, q] = *sum.begin();
  const auto& [second, r] = *std::next(sum.begin());
  const int strength = std::min(sign_of_powers(first), sign_of_powers(second));
  if ((q > 0) == (r > 0) || strength < 1) return 0;
  Product ratio = first;
  for (const auto& [atom, e] : second) multiply(ratio, atom, kernel::scaled(e, -1));
  const int sign = sign_of(logarithm({{ratio, -q / r}}));
  return product(product(sign, strength), q > 0 ? 2 : -2);
}
// x = low + s, high - s or (low + high s)/(1 + s) for s >= 0 shows signs term by term.
int Forms::sign_by_shift(const Sum& sum) {
  const std::optional<Expr> e = real_expression(sum);
  if (!e) return 0;
  for (const Expr& x : kernel::free_variables(*e)) {
    const auto it = where.ranges.find(x);
    if (it == where.ranges.end()) continue;
    const Range& range = it->second;
    if (!range.high && (!range.low || range.low->value == 0)) continue;
    const End& start = range.low ? *range.low : *range.high;
    const bool is_bounded = range.low && range.high;
    // Of an integer, so that its powers stay powers.
    if (range.is_integer && (is_bounded || !is_whole(start.value))) continue;
    const Expr s = kernel::real("above_" + x.name());  // which nobody can type
    Domain inner = where;
    inner.ranges.erase(x);
    inner.further.clear();
    inner.ranges[s] = {.is_integer = range.is_integer, .low = End{0, start.is_inside}};
    Expr value = range.low ? Expr(start.value) + s : Expr(start.value) - s;
    if (is_bounded) value = (Expr(start.value) + Expr(range.high->value) * s) / (Expr(1) + s);
    Forms forms_of_s(inner);
    forms_of_s.depth = depth + 1;
    const int sign = forms_of_s.sign_of(forms_of_s.of(kernel::substitute(*e, {{x, value}})));
    const bool is_end_left_out = is_bounded && range.high->is_inside;
    if (sign != 0) return is_end_left_out ? product(sign, 1) : sign;
  }
  return 0;
}

void Forms::assume(const Requirement& requirement) {
  const Sum sum = of(requirement.term);
  if (sum.empty()) return;
  const Factors f = factors(sum);
  if (requirement.kind == Requirement::Kind::NotZero) {
    for (const auto& [atom, e] : f.powers) assumed_not_zero.insert(atom);
  } else {
    const bool strictly = requirement.kind == Requirement::Kind::Positive;
    const int strength = strictly ? 2 : 1;
    assumed.emplace_back(sum, strength);
    Product known = f.powers;
    Exprs unknown;
    for (const auto& [atom, e] : f.powers) {
      const bool is_odd = whole_number(e).value_or(0) % 2 != 0;
      if (!is_odd || is_complex(atom) || sign_of_atom(atom) != 0) continue;
      unknown.push_back(atom);
      known.erase(atom);
    }
    const int rest = product(sign_of_powers(known), f.number > 0 ? 2 : -2);
    const bool is_certain = strictly ? rest != 0 : std::abs(rest) == 2;
    const int sign = rest > 0 ? 1 : -1;
    if (unknown.size() == 1 && is_certain) assumed_signs[unknown[0]] = sign * strength;
    if (unknown.size() > 1 && is_certain) signed_products.emplace_back(unknown, sign);
  }
  forms.clear();
  factored.clear();
  signs.clear();
}
bool Forms::holds(const Requirement& requirement) {
  const Sum sum = of(requirement.term);
  if (requirement.kind == Requirement::Kind::NotZero)
    return is_positive(sum) || has_sign(sum, -1, true);
  return has_sign(sum, 1, requirement.kind == Requirement::Kind::Positive);
}
}  // namespace equality
