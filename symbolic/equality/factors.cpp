// Sums as products: what all terms share, then the factors of a polynomial in what is left.
#include "equality/normal_form.hpp"

namespace equality {
namespace {
using kernel::Monomial;
using kernel::Polynomial;
constexpr std::size_t most_terms = 60;  // of a polynomial that GiNaC factors
constexpr int highest_degree = 60, highest_power = 12;

cln::cl_RA common_divisor(const cln::cl_RA& a, const cln::cl_RA& b) {
  return cln::cl_RA(cln::gcd(cln::numerator(a) * cln::denominator(b),
                             cln::numerator(b) * cln::denominator(a))) /
         (cln::denominator(a) * cln::denominator(b));
}

// An atom to the power of a monomial: the exponents of all terms are least + step * (0, 1, 2, ...).
struct Generator {
  Expr atom;
  Monomial monomial;
  cln::cl_RA least, step;
};
cln::cl_RA coefficient(const Product& product, Expr atom, const Monomial& monomial) {
  return of_part(exponent_in(product, atom), monomial);
}
std::map<Expr, Generator> generators(const Sum& sum) {
  std::set<std::pair<Expr, Monomial>> seen;
  for (const auto& [product, q] : sum)
    for (const auto& [atom, e] : product)
      for (const auto& [monomial, r] : e) seen.emplace(atom, monomial);
  std::map<Expr, Generator> out;
  for (const auto& [atom, monomial] : seen) {
    std::set<cln::cl_RA> exponents;
    for (const auto& [product, q] : sum) exponents.insert(coefficient(product, atom, monomial));
    const cln::cl_RA least = *exponents.begin(), greatest = *exponents.rbegin();
    Generator g{atom, monomial, least, 0};
    for (const cln::cl_RA& e : exponents) g.step = common_divisor(g.step, e - least);
    // e^(2x) - 1 has the factor e^x - 1, e^(2000x) - 1 at least e^(1000x) - 1.
    if (g.step != 0) {
      const cln::cl_RA finest = cln::cl_RA(1) / cln::denominator(g.step);
      const bool is_fine = greatest - least <= finest * highest_degree;
      // x^61 has no root of a factor: x may be negative.
      const bool can_halve = atom == circle() || atom == euler() || is_whole(g.step / 2);
      g.step = is_fine ? finest : can_halve ? g.step / 2 : g.step;
    }
    out.emplace(kernel::real("generator_" + std::to_string(out.size())), g);
  }
  return out;
}
cln::cl_RA content(const Sum& sum) {
  cln::cl_RA out = 0;
  for (const auto& [product, q] : sum) out = common_divisor(out, q);
  return sum.begin()->second < 0 ? -out : out;
}
}  // namespace

int whole(const cln::cl_RA& q) {
  if (cln::abs(q) > 100000) throw TooLarge("an exponent above 100000");
  return cln::cl_I_to_int(cln::numerator(q));
}
std::vector<std::pair<Polynomial, int>> factorized(const Polynomial& p) {
  int degree = 0;
  for (const auto& [monomial, q] : p) {
    int total = 0;
    for (const auto& [atom, k] : monomial) total += k;
    degree = std::max(degree, total);
  }
  if (degree <= 1 || degree > highest_degree || p.size() > most_terms) return {{p, 1}};
  std::set<Expr> atoms;
  for (const auto& [monomial, q] : p)
    for (const auto& [atom, k] : monomial) atoms.insert(atom);
  kernel::Substitution names;  // no root or quotient is more than a name here
  Expr sum = kernel::expression(p);
  for (auto atom = atoms.rbegin(); atom != atoms.rend(); ++atom) {  // what holds others first
    const Expr name = kernel::real("factor_" + std::to_string(names.size()));
    names.emplace(name, *atom);
    sum = kernel::replace(sum, *atom, name);
  }
  const Expr product = kernel::substitute(algebra::simplified(sum), names);
  std::vector<std::pair<Polynomial, int>> out;
  Polynomial check{{Monomial(), 1}};
  for (Expr factor : product.op() == Op::Mul ? product.args() : Exprs{product}) {
    const bool is_power = factor.op() == Op::Pow;
    out.emplace_back(kernel::polynomial(is_power ? factor.arg(0) : factor),
                     is_power ? factor.exponent() : 1);
    for (int i = 0; i < out.back().second; ++i) check = check * out.back().first;
  }
  if (check != p) return {{p, 1}};  // GiNaC proposes
  return out;
}

const Forms::Factors& Forms::factors(const Sum& sum) {
  if (const auto it = factored.find(sum); it != factored.end()) return it->second;
  return factored.emplace(sum, factors_of(sum)).first->second;
}
Forms::Factors Forms::factors_of(const Sum& sum) {
  if (sum.size() == 1) return {sum.begin()->second, sum.begin()->first};
  Factors out;
  if (const auto typed = products.extract(sum)) {  // (sqrt(2) - x)^3, which GiNaC cannot factor
    const Expr e = typed.mapped();
    const int k = e.op() == Op::Pow ? e.exponent() : 1;
    for (Expr arg : e.args()) {
      const Factors f = factors(of(arg));
      out.number = out.number * cln::expt(f.number, k);
      for (const auto& [atom, power] : f.powers)
        multiply(out.powers, atom, kernel::scaled(power, k));
    }
    return out;
  }
  const Sum plain = expanded(sum, &out.powers);
  if (plain.empty()) throw NotDefined("0, written as a sum");
  const std::map<Expr, Generator> all = generators(plain);
  Polynomial p;
  for (const auto& [product, q] : plain) {
    Monomial monomial;
    for (const auto& [variable, g] : all) {
      const cln::cl_RA over = coefficient(product, g.atom, g.monomial) - g.least;
      if (over != 0) monomial.emplace_back(variable, whole(over / g.step));
    }
    p = p + Polynomial{{monomial, q}};
  }
  for (const auto& [variable, g] : all)
    if (g.least != 0) multiply(out.powers, g.atom, {{g.monomial, g.least}});
  for (const auto& [factor, times_taken] : factorized(p)) {
    Sum part;
    for (const auto& [monomial, q] : factor) {
      Product product;
      for (const auto& [variable, k] : monomial) {
        const Generator& g = all.at(variable);
        multiply(product, g.atom, {{g.monomial, g.step * cln::cl_RA(k)}});
      }
      part = part + reduced(product, q);
    }
    take_factor(out, part, times_taken);
  }
  return out;
}
// A sum that its conjugate is a multiple of is real but for a power of z: that is taken out.
void Forms::take_factor(Factors& into, Sum part, int times_taken) {
  if (part.empty()) throw NotDefined("0, written as a sum");
  const auto take_content = [&] {
    const cln::cl_RA inside = content(part);
    into.number = into.number * cln::expt(inside, times_taken);
    part = scaled(part, 1 / inside);
  };
  take_content();
  const Sum other = conjugated(part);
  if (part.size() > 1 && other != part) {
    // conj(f) = +-z^m f: f z^(m/2) is real, or imaginary
    for (const auto& [product, q] : other) {
      const auto m = exponent_in(product, circle()) - exponent_in(part.begin()->first, circle());
      for (int sign : {1, -1}) {
        Product turn;
        multiply(turn, circle(), m);
        if (times(part, {{turn, sign}}) != other) continue;
        Exponent half = kernel::scaled(m, cln::cl_RA(1) / 2);
        if (sign < 0) half = half + times_pi(cln::cl_RA(1) / 2);
        if (half.empty()) continue;
        part = times(part, atom(circle(), half));
        multiply(into.powers, circle(), kernel::scaled(half, -times_taken));
        take_content();
        return take_real(into, part, times_taken);
      }
    }
  }
  take_real(into, part, times_taken);
}
// Of an earlier number, if it is one: 2 + sqrt(5) is ((1 + sqrt(5))/2)^3.
std::pair<Expr, cln::cl_RA> Forms::as_power(const Sum& part) {
  const Expr number = expression(part);
  const auto is_number = [](Expr e) {
    return kernel::free_variables(e).empty() && is_algebraic(e);
  };
  const auto raised = [](Expr e, const cln::cl_I& k) { return notation::raised(e, cln::cl_RA(k)); };
  cln::cl_RA power = 1;
  const auto is_power_of = [&](Expr base) {
    const Expr ratio = notation::call("log", number) / notation::call("log", base);
    const auto q = near_fraction(enclosure(ratio, 128).low(), highest_power);
    power = q.value_or(0);
    const Expr left = raised(number, cln::denominator(power));
    return q && exact_sign(left - raised(base, cln::numerator(power))) == 0;
  };
  for (const auto& earlier : is_number(number) ? composites : std::map<Expr, Sum>())
    if (earlier.first != number && is_number(earlier.first) &&
        is_proved([&] { return is_power_of(earlier.first); }))
      return {earlier.first, power};
  return {composite(part), 1};
}
void Forms::take_real(Factors& into, Sum part, int times_taken) {
  if (part.size() > 1) {
    // Of 1 + sqrt(2) and sqrt(2) - 1, whose product is rational, the greater one is the atom.
    if (const auto inverse = rationalized(part)) {
      const cln::cl_RA inside = content(*inverse);
      const Sum other = scaled(*inverse, 1 / inside);
      const Expr gap = kernel::power(expression(other), 2) - kernel::power(expression(part), 2);
      if (exact_sign(gap) == 1) {
        into.number = into.number * cln::expt(inside, -times_taken);
        part = other;
        times_taken = -times_taken;
      }
      if (cln::cl_RA root = 0;
          cln::sqrtp(cln::abs(inside), &root)) {  // (1 + sqrt(5))/2 of 1 + sqrt(5)
        into.number = into.number * cln::expt(root, -times_taken);
        part = scaled(part, root);
      }
    }
    const auto [base, power] = as_power(part);
    return multiply(into.powers, base, exponent(times_taken * power));
  }
  for (const auto& [atom, e] : part.begin()->first)
    multiply(into.powers, atom, kernel::scaled(e, times_taken));
}
Sum Forms::reduced(Product product, cln::cl_RA number) {
  reduce(product, number);
  return {{product, number}};
}
}  // namespace equality
