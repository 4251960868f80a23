// Whether a normal form is 0, and signs that are certain all over a domain.
#include "equality/normal_form.hpp"

namespace equality {
namespace {
constexpr int deepest = 8, few_deep = 2;
constexpr std::size_t most_asked = 1000;  // terms, of all that one question leads to
constexpr int highest_power = 3000;
constexpr int most_roots = 12;  // x^(1/12) is compared by its twelfth power
int product(int a, int b) {
  const int size = std::min(std::abs(a), std::abs(b));
  return (a > 0) == (b > 0) ? size : -size;
}
/// The sum as one of different functions, each times a constant.
std::map<Product, Sum> coefficients(const Sum& sum, const auto& constant_part) {
  std::map<Product, Sum> out;
  for (const auto& [product, q] : sum) {
    Product function = product, constant;
    for (const auto& [atom, e] : product) {
      const Exponent part = constant_part(atom, e);
      multiply(constant, atom, part);
      multiply(function, atom, kernel::scaled(part, -1));
    }
    out[function][constant] = q;
  }
  return out;
}
}  // namespace

// The sum without its composite atoms, but for roots, to be multiplied by `divisor`.
Sum Forms::expanded(Sum sum, Product* divisor) {
  for (;;) {
    Expr newest;  // it holds older ones
    for (const auto& [product, q] : sum)
      for (const auto& [atom, e] : product)
        if (composites.contains(atom) && cln::floor1(constant_part(e)) != 0 &&
            (!newest || newest < atom))
          newest = atom;
    if (!newest) return sum;
    const auto whole = [&](const Product& product) {
      return cln::floor1(constant_part(exponent_in(product, newest)));
    };
    cln::cl_I least = whole(sum.begin()->first);
    for (const auto& [product, q] : sum) least = cln::min(least, whole(product));
    if (divisor) multiply(*divisor, newest, exponent(cln::cl_RA(least)));
    std::map<cln::cl_I, Sum> by_power;
    for (const auto& [product, q] : sum) {
      const cln::cl_I k = whole(product);
      Product rest = product;
      multiply(rest, newest, exponent(-cln::cl_RA(k)));
      by_power[k - least][rest] = q;
    }
    Sum out;  // Horner's scheme from the highest power
    cln::cl_I at = by_power.rbegin()->first;
    if (at > highest_power) throw TooLarge("a power above 3000 to be multiplied out");
    for (; at >= 0; at = at - 1) {
      out = times(out, composites.at(newest));
      if (const auto it = by_power.find(at); it != by_power.end()) out = out + it->second;
    }
    sum = out;
  }
}
// What of a power is a constant: z^(pi/3) of z^(x + pi/3).
Exponent Forms::constant(Expr atom, const Exponent& e) {
  if (atom == circle()) return times_pi(of_part(e, {{kernel::pi(), 1}}));
  const bool is_number = number_of(e) && kernel::free_variables(atom).empty() &&
                         !is_complex(atom) && is_algebraic(atom);
  return is_number ? e : Exponent();
}
bool Forms::is_zero(const Sum& sum) {
  const auto constant_of = [&](Expr a, const Exponent& e) { return constant(a, e); };
  for (const auto& [product, coefficient] : coefficients(expanded(sum), constant_of)) {
    if (coefficient.size() == 1) return false;
    const Sum other = conjugated(coefficient);
    for (const Sum& part : {coefficient + other, times(imaginary(), coefficient - other)}) {
      const std::optional<Expr> real = real_expression(part);
      if (!real || exact_sign(*real) != 0) return false;
    }
  }
  return true;
}

bool is_zero_constant(Expr constant) {
  static int depth = 0;
  if (depth > 2) return false;
  ++depth;
  Forms forms({});
  const bool is_zero = is_proved([&] { return forms.is_zero(forms.of(constant)); });
  --depth;
  return is_zero;
}

int Forms::sign_of_atom(Expr atom) {
  if (atom.op() == Op::Num || atom == kernel::pi() || atom == euler()) return 2;
  if (is_complex(atom)) return 0;
  if (const auto it = assumed_signs.find(atom); it != assumed_signs.end()) return it->second;
  const auto is_not_zero = [&](Expr e) { return assumed_not_zero.contains(e); };
  int sign = 0;
  if (const auto it = where.ranges.find(atom); it != where.ranges.end()) {
    const auto& [is_integer, low, high] = it->second;
    const int side = low && low->value >= 0 ? 1 : high && high->value <= 0 ? -1 : 0;
    sign = it->second.contains(0) ? side : 2 * side;
  } else if (is_call(atom, "abs")) {
    sign = is_not_zero(atom.arg(0)) ? 2 : 1;
  } else if (composites.contains(atom)) {
    sign = sign_of_composite(composites.at(atom));
  } else if (const bool is_log = is_call(atom, "log");
             depth < deepest && (is_log || is_arcus(atom))) {
    ++depth;
    is_proved([&] { return sign = sign_of(of(atom.arg(0)) - number(is_log ? 1 : 0)), true; });
    --depth;
  }
  return std::abs(sign) == 1 && is_not_zero(atom) ? 2 * sign : sign;
}

int Forms::sign_of(const Sum& sum) {
  for (int s : {2, -2, 1, -1})
    if (has_sign(sum, s > 0 ? 1 : -1, std::abs(s) == 2)) return s;
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
  asked = depth == 0 ? 0 : asked;
  if (asked > most_asked) return false;
  const auto fits = [&](int found) { return found * sign >= (strictly ? 2 : 1); };
  for (const auto& [known, strength] : assumed) {
    const cln::cl_RA ratio = sum.begin()->second / known.begin()->second;
    if (scaled(known, ratio) == sum && fits(ratio > 0 ? strength : -strength)) return true;
    // z - y of z - x, where y - x is known, or x - y
    const Sum rest = sum - scaled(known, strength * sign > 0 ? 1 : -1);
    if (rest.size() > sum.size() || depth >= few_deep) continue;
    ++depth;
    const bool is_strict = strictly && std::abs(strength) == 1;
    const bool is_sum = is_proved([&] { return has_sign(rest, sign, is_strict); });
    --depth;
    if (is_sum) return true;
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
  if ((asked += sum.size()) > most_asked) return 0;
  ++depth;
  int sign = 0;
  for (Rule Forms::*rule : {&Forms::sign_of_number, &Forms::sign_by_terms, &Forms::sign_by_bounds,
                            &Forms::sign_of_cosine, &Forms::sign_by_shift, &Forms::sign_of_root,
                            &Forms::sign_of_two, &Forms::sign_of_quadratic})
    if (sign == 0) is_proved([&] { return sign = (this->*rule)(sum), true; });
  --depth;
  signs[sum] = {sign, depth};
  return sign;
}
int Forms::sign_by_terms(const Sum& sum) {
  const auto part = [](Expr atom, const Exponent& e) {  // pi/2 - 1 of pi/2 s - s
    Exponent fixed;
    for (const auto& [term, q] : e)
      if (kernel::free_variables(kernel::expression({{term, 1}})).empty()) fixed[term] = q;
    if (atom == circle()) return fixed;
    return kernel::free_variables(atom).empty() && number_of(e) ? e : Exponent();
  };
  int total = 0;
  for (const auto& [powers, coefficient] : coefficients(sum, part)) {
    const int sign = product(sign_of_powers(powers), sign_of_number(coefficient));
    if (sign == 0 || product(total, sign) < 0) return 0;
    total = std::abs(sign) > std::abs(total) ? sign : total;
  }
  return total;
}
int Forms::sign_of_number(const Sum& sum) {
  const std::optional<Expr> e = real_expression(sum);
  return e && kernel::free_variables(*e).empty() ? 2 * exact_sign(*e).value_or(0) : 0;
}
// c + sum of c_i z^u_i is at least c - sum of |c_i|, where it is real; angles are at most pi/2.
int Forms::sign_by_bounds(const Sum& sum) {
  Sum constant, most;  // of the others
  for (const auto& [powers, q] : sum) {
    const Expr e = powers.size() == 1 ? powers.begin()->first : Expr(0);
    if (e == circle())
      most = most + number(cln::abs(q));
    else if (is_arcus(e) && powers.begin()->second == exponent(1))
      most = most + scaled(atom(kernel::pi()), cln::abs(q) / 2);
    else
      constant.insert({powers, q});
  }
  for (int side : {1, -1})
    if (const Sum least = scaled(constant, side) - most; least.empty() || sign_of_number(least) > 0)
      return side * (least.empty() ? 1 : 2);
  return 0;
}
// c z^u and its conjugate are 2 |c| cos(u + arg(c)), positive for an angle between -pi/2 and pi/2.
int Forms::sign_of_cosine(const Sum& sum) {
  const auto parts = coefficients(sum, [&](Expr a, const Exponent& e) { return constant(a, e); });
  if (parts.size() != 2) return 0;
  Product others = parts.begin()->first;
  const Sum c = parts.begin()->second, conjugate = conjugated(c);
  const Exponent u = exponent_in(others, circle());
  Product turned = others;
  multiply(turned, circle(), kernel::scaled(u, -2));
  if (turned != parts.rbegin()->first || parts.rbegin()->second != conjugate) return 0;
  others.erase(circle());
  const Sum quarter = scaled(atom(kernel::pi()), cln::cl_RA(1) / 2);
  const Sum real = c + conjugate, imaginary_part = times(imaginary(), conjugate - c);
  const int side = sign_of_number(real), above = sign_of_number(imaginary_part);
  if (side == 0 && (above == 0 || !is_zero(real))) return 0;
  const Sum argument = side == 0
                           ? scaled(quarter, above / 2)
                           : inverse_angle("atan", times(imaginary_part, integer_power(real, -1)));
  for (int shift : {0, 1, -1, 2, -2, 3, -3, 4, -4}) {
    const Sum angle = sum_of(u) + argument + scaled(quarter, 2 * shift);
    const int sign = product(sign_of(quarter - angle), sign_of(quarter + angle));
    if (sign > 0)
      return product(sign_of_powers(others), (side >= 0) == (shift % 2 == 0) ? sign : -sign);
  }
  return 0;
}
// |b| + b >= 0. A root a plus b of the other sign has the sign of +-(a^d - b^d), d even.
int Forms::sign_of_root(const Sum& sum) {
  for (const auto& [powers, q] : sum) {
    cln::cl_I order = 1;
    for (const auto& [atom, e] : powers)
      order = cln::lcm(order, cln::denominator(constant_part(e)));
    const Sum root{{powers, q}}, rest = sum - root;
    const int side = product(sign_of_powers(powers), q > 0 ? 2 : -2);
    if (rest.size() == 1 && side != 0 && integer_power(root, 2) == integer_power(rest, 2))
      return side > 0 ? 1 : -1;
    if (order == 1 || side == 0 || order > most_roots || side * sign_of(rest) >= 0) continue;
    const int d = cln::cl_I_to_int(cln::lcm(order, 2));
    if (d > 2 && depth >= few_deep) continue;  // powers of powers take long
    const int sign = sign_of(integer_power(root, d) - integer_power(rest, d));
    if (sign != 0) return side > 0 ? sign : -sign;
  }
  return 0;
}
// a - b for a and b from 0 on has the sign of log(a/b).
int Forms::sign_of_two(const Sum& sum) {
  if (sum.size() != 2) return 0;
  const auto& [first, q] = *sum.begin();
  const auto& [second, r] = *std::next(sum.begin());
  const int strength = std::min(sign_of_powers(first), sign_of_powers(second));
  if ((q > 0) == (r > 0) || strength < 1) return 0;
  Product ratio = first;
  for (const auto& [atom, e] : second) multiply(ratio, atom, kernel::scaled(e, -1));
  return product(product(sign_of(logarithm({{ratio, -q / r}})), strength), q > 0 ? 2 : -2);
}
// x = low + s, high - s or (low + high s)/(1 + s) for s >= 0 shows signs term by term.
int Forms::sign_by_shift(const Sum& sum) {
  const std::optional<Expr> e = real_expression(sum);
  if (!e) return 0;
  for (const Expr& x : kernel::free_variables(*e)) {
    const Range range = of_part(where.ranges, x);
    if (!range.high && (!range.low || range.low->value == 0)) continue;
    const End& start = range.low ? *range.low : *range.high;
    const bool is_bounded = range.low && range.high;
    // Of an integer, so that its powers stay powers; not of an angle.
    const auto has_x = [&](Expr p) { return is_sine(p) && kernel::free_variables(p).contains(x); };
    if (range.is_integer && (is_bounded || !is_whole(start.value))) continue;
    if (std::ranges::any_of(parts_of(*e), has_x)) continue;
    const Expr s = kernel::real("above_" + x.name());  // which nobody can type
    Domain inner = where;
    inner.ranges.erase(x);
    inner.further.clear();
    inner.ranges[s] = {.is_integer = range.is_integer, .low = End{0, start.is_inside}};
    Expr value = range.low ? Expr(start.value) + s : Expr(start.value) - s;
    if (is_bounded) value = (Expr(start.value) + Expr(range.high->value) * s) / (Expr(1) + s);
    Forms forms_of_s(inner);
    forms_of_s.depth = depth + 1;
    forms_of_s.asked = asked;
    const int sign = forms_of_s.sign_of(forms_of_s.of(kernel::substitute(*e, {{x, value}})));
    asked = forms_of_s.asked;
    if (sign != 0) return is_bounded && range.high->is_inside ? product(sign, 1) : sign;
  }
  return 0;
}
// a u^2 + b u + c, u a power of an atom, has the sign of a where 4 a c - b^2 is not negative.
int Forms::sign_of_quadratic(const Sum& sum) {
  std::set<Expr> atoms;
  for (const auto& [powers, q] : sum)
    for (const auto& [atom, e] : powers)
      if (!is_complex(atom)) atoms.insert(atom);
  for (Expr atom : atoms) {
    std::map<cln::cl_RA, Sum> parts;
    bool has_numbers = true;
    for (const auto& [powers, q] : sum) {
      const auto k = number_of(exponent_in(powers, atom));
      has_numbers = has_numbers && k;
      Product rest = powers;
      rest.erase(atom);
      parts[k.value_or(0)][rest] = q;
    }
    const cln::cl_RA top = parts.rbegin()->first;
    const Sum a = parts[top], b = parts[top / 2], c = parts[0];
    if (!has_numbers || top <= 0 || parts.size() != 3 || b.empty() || c.empty()) continue;
    const int sign = sign_of(a);
    const int rest = std::abs(sign) == 2 ? sign_of(scaled(times(a, c), 4) - times(b, b)) : 0;
    if (rest > 0) return product(sign, rest);
  }
  return 0;
}
void Forms::assume(const Requirement& requirement) {
  const Sum sum = of(requirement.term);
  if (is_nothing(sum)) return;
  const Factors f = factors(sum);
  if (requirement.kind == Need::NotZero) {
    for (const auto& [atom, e] : f.powers) assumed_not_zero.insert(atom);
  } else {
    const int strength = requirement.kind == Need::Positive ? 2 : 1;
    assumed.emplace_back(sum, strength);
    Product known = f.powers;
    SignedProduct is;
    for (const auto& [atom, e] : f.powers) {
      const bool is_odd = whole_number(e).value_or(0) % 2 != 0;
      if (!is_odd || is_complex(atom) || sign_of_atom(atom) != 0) continue;
      is.atoms.push_back(atom);
      known.erase(atom);
    }
    const int rest = product(sign_of_powers(known), f.number > 0 ? 2 : -2);
    if (strength == 1 && std::abs(rest) == 1) is.others = known;
    is.sign = rest > 0 ? 1 : -1;
    if (is.atoms.size() == 1 && is.others.empty() && rest != 0)
      assumed_signs[is.atoms[0]] = is.sign * strength;
    else if (!is.atoms.empty() && rest != 0)
      signed_products.push_back(is);
  }
  forms.clear();
  factored.clear();
  signs.clear();
}
bool Forms::holds(const Requirement& requirement) {
  const Sum sum = of(requirement.term);
  if (requirement.kind == Need::NotZero) return is_positive(sum) || has_sign(sum, -1, true);
  return has_sign(sum, 1, requirement.kind == Need::Positive);
}
}  // namespace equality
