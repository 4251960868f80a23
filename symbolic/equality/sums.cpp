// Sums of products of powers: arithmetic, and how they are written as terms again.
#include <limits>

#include "equality/normal_form.hpp"
#include "kernel/names.hpp"

namespace equality {
namespace {
constexpr std::size_t most_products = 200000;

void add(Sum& into, const Product& product, const cln::cl_RA& q) {
  if (q == 0) return;
  cln::cl_RA& sum = into[product];
  sum = sum + q;
  if (sum == 0) into.erase(product);
}
Expr raised(Expr base, const Exponent& e) {
  if (e == exponent(cln::cl_RA(1) / 2)) return kernel::sqrt(base);
  const int k = whole_number(e).value_or(0);
  return k > 0 ? kernel::power(base, k) : notation::raised(base, kernel::expression(e));
}
}  // namespace

Expr circle() {
  if (!kernel::signature("unit_circle")) kernel::declare("unit_circle", {});
  return kernel::fun("unit_circle", {});
}
Sum imaginary() { return atom(circle(), times_pi(cln::cl_RA(1) / 2)); }
Sum operator+(const Sum& a, const Sum& b) {
  Sum out = a;
  for (const auto& [product, q] : b) add(out, product, q);
  return out;
}
Sum scaled(const Sum& a, const cln::cl_RA& q) {
  Sum out;
  for (const auto& [product, coefficient] : a) add(out, product, coefficient * q);
  return out;
}
Exponent exponent(const cln::cl_RA& q) { return q == 0 ? Exponent() : Exponent{{{}, q}}; }
Exponent times_pi(const cln::cl_RA& q) { return exponent(q) * kernel::polynomial(kernel::pi()); }
std::optional<cln::cl_RA> number_of(const Exponent& e) {
  const cln::cl_RA q = constant_part(e);
  return e == exponent(q) ? std::optional(q) : std::nullopt;
}
std::optional<int> whole_number(const Exponent& e) {
  const auto k = number_of(e);
  if (!k || !is_whole(*k) || cln::abs(*k) > std::numeric_limits<int>::max()) return {};
  return cln::cl_I_to_int(cln::numerator(*k));
}
bool is_arcus(Expr e) { return is_call(e, "atan") || is_call(e, "asin") || is_call(e, "acos"); }
void multiply(Product& into, Expr atom, const Exponent& exponent) {
  Exponent& e = into[atom];
  e = e + exponent;
  if (e.empty()) into.erase(atom);
}

Sum Forms::times(const Sum& a, const Sum& b) {
  if (a.size() * b.size() > most_products) throw TooLarge("too many products");
  Sum out;
  for (const auto& [left, q] : a)
    for (const auto& [right, r] : b) {
      Product product = left;
      for (const auto& [atom, e] : right) multiply(product, atom, e);
      cln::cl_RA coefficient = q * r;
      reduce(product, coefficient);
      add(out, product, coefficient);
    }
  return out;
}

// p^1 is a number, |a| |b| is a b where that is not negative.
void Forms::reduce(Product& product, cln::cl_RA& number) {
  for (const auto& [atom, e] : Product(product))
    if (is_call(atom, "abs")) reduce_modulus(product, number, atom, e);
  for (const auto& [atoms, others, sign] : signed_products) {
    const auto is_there = [&](Expr atom) {
      return constant_part(exponent_in(product, absolute(atom))) >= 1;
    };
    const auto is_0_with = [&](const auto& power) {  // the product, where that power is
      const auto& [atom, there] = power;
      const Exponent e = exponent_in(product, atom) + exponent_in(product, absolute(atom));
      const cln::cl_RA ratio = of_part(e, there.begin()->first) / there.begin()->second;
      return ratio > 0 && e == kernel::scaled(there, ratio);
    };
    if (!std::ranges::all_of(atoms, is_there) || !std::ranges::all_of(others, is_0_with)) continue;
    if (sign < 0) number = -number;
    for (Expr atom : atoms) {
      multiply(product, absolute(atom), exponent(-1));
      multiply(product, atom, exponent(1));
    }
  }
  for (const auto& [atom, e] : Product(product)) {
    if (atom == circle()) reduce_turns(product, number, e);
    if (atom.op() != Op::Num) continue;
    const cln::cl_I whole = cln::floor1(constant_part(e));
    if (whole == 0) continue;
    if (cln::abs(whole) > 10000) throw TooLarge("a number of too many digits");
    number = number * cln::expt(atom.value(), whole);
    multiply(product, atom, exponent(-whole));
  }
}
// |a|^2 is a times its conjugate.
void Forms::reduce_modulus(Product& product, cln::cl_RA& number, Expr atom, const Exponent& e) {
  const Expr inner = atom.arg(0);
  const int sign = sign_of_atom(inner);
  if (sign > 0) {
    product.erase(atom);
    return multiply(product, inner, e);
  }
  Exponent part;  // whole, or even where no sign is known
  for (const auto& [monomial, q] : e) {
    const cln::cl_RA whole = sign < 0 ? cln::floor1(q) : 2 * cln::floor1(q / 2);
    if (whole != 0 && (monomial.empty() || (!is_complex(inner) && is_integer({{monomial, 1}}))))
      part[monomial] = whole;
  }
  if (part.empty()) return;
  multiply(product, atom, kernel::scaled(part, -1));
  if (sign < 0) multiply(product, circle(), part * times_pi(1));
  if (!is_complex(inner)) return multiply(product, inner, part);
  const Exponent half = kernel::scaled(part, cln::cl_RA(1) / 2);
  multiply(product, inner, half);
  const Factors conjugate = factors(conjugated(composites.at(inner)));
  number = number * cln::expt(conjugate.number, cln::numerator(constant_part(half)));
  for (const auto& [other, k] : conjugate.powers) multiply(product, other, k * half);
}
void Forms::reduce_turns(Product& product, cln::cl_RA& number, const Exponent& e) const {
  for (const auto& [monomial, q] : Exponent(e)) {
    kernel::Monomial others = monomial;  // pi times an integer?
    if (std::erase(others, std::pair(kernel::pi(), 1)) == 0) continue;
    if (!is_integer({{others, 1}})) continue;
    cln::cl_RA turns = 2 * cln::floor1(q / 2);
    if (monomial == kernel::Monomial{{kernel::pi(), 1}} && q - turns >= 1) {
      turns = turns + 1;
      number = -number;
    }
    if (turns != 0) multiply(product, circle(), {{monomial, -turns}});
  }
}
bool Forms::is_complex(Expr atom) {
  if (atom == circle()) return true;
  return composites.contains(atom) && conjugated(composites.at(atom)) != composites.at(atom);
}
Sum Forms::conjugated(const Sum& sum) {
  Sum out;
  for (const auto& [product, q] : sum) {
    Product turned = product;
    multiply(turned, circle(), kernel::scaled(exponent_in(product, circle()), -2));
    for (const auto& [powers, coefficient] : reduced(turned, q)) add(out, powers, coefficient);
  }
  return out;
}

bool Forms::is_integer(Expr e) {
  return is_proved([&] { return is_integer(exponent_of(of(e))); });
}
bool Forms::is_integer(const Exponent& exponent) const {
  for (const auto& [monomial, q] : exponent) {
    if (!is_whole(q)) return false;
    for (const auto& [atom, k] : monomial)
      if (!of_part(where.ranges, atom).is_integer) return false;
  }
  return true;
}
Exponent Forms::exponent_of(const Sum& sum) {
  Exponent out;
  for (const auto& [product, q] : sum) {
    kernel::Monomial monomial;
    Product rest;  // what is no polynomial becomes one atom
    for (const auto& [atom, e] : product) {
      const int k = whole_number(e).value_or(0);
      if (k > 0 && k < 1000 && atom != circle())
        monomial.emplace_back(atom, k);
      else
        rest[atom] = e;
    }
    if (!rest.empty()) {
      const Sum power{{rest, 1}};
      const Expr whole = expression(power);
      forms[whole] = power;
      monomial.emplace_back(whole, 1);
      std::ranges::sort(monomial);
    }
    out = out + Exponent{{monomial, q}};
  }
  return out;
}

Expr Forms::expression(const Sum& sum) {
  Exprs terms;
  for (const auto& [product, q] : sum) {
    Exprs factors;
    for (const auto& [atom, e] : product) factors.push_back(raised(atom, e));
    if (q != 1 || factors.empty()) factors.insert(factors.begin(), q);
    terms.push_back(factors.size() == 1 ? factors[0] : kernel::product(factors));
  }
  return terms.empty() ? Expr(0) : terms.size() == 1 ? terms[0] : kernel::sum(terms);
}
std::optional<Expr> Forms::real_expression(const Sum& sum) {
  if (conjugated(sum) != sum) return {};
  Exprs terms{0};
  for (const auto& [product, q] : sum) {
    Exprs factors{Expr(q)};
    for (const auto& [atom, e] : product) {
      const auto base =
          composites.contains(atom) ? real_expression(composites.at(atom)) : std::optional(atom);
      if (!base) return {};
      factors.push_back(atom == circle() ? kernel::cos(kernel::expression(e)) : raised(*base, e));
    }
    terms.push_back(kernel::product(factors));
  }
  const Expr out = kernel::sum(terms);
  const bool is_real = kernel::replace(out, circle(), 0) == out;
  return is_real ? std::optional(out) : std::nullopt;
}
}  // namespace equality
