#include "equality/normal_form.hpp"

namespace equality {
namespace {
constexpr int written_out = 4;          // powers of sums up to this one are multiplied out
constexpr std::size_t most_surds = 16;  // of a denominator
constexpr int most_multiples = 256;     // of an inverse angle
constexpr int most_angle_parts = 60;    // asin(1/2) is pi/6

// p^v for the primes of a number > 0; what is left beyond 10^5 is taken as it is.
std::vector<std::pair<Expr, int>> primes(cln::cl_I n) {
  std::vector<std::pair<Expr, int>> out;
  for (int p = 2; p < 100000 && n >= cln::cl_I(p) * p; ++p) {
    int times = 0;
    for (; cln::mod(n, p) == 0; ++times) n = cln::exquo(n, p);
    if (times > 0) out.emplace_back(Expr(p), times);
  }
  if (n > 1) out.emplace_back(Expr(cln::cl_RA(n)), 1);
  return out;
}
void multiply_number(Product& into, const cln::cl_RA& q, const Exponent& e) {
  for (const auto& [p, k] : primes(cln::numerator(q))) multiply(into, p, kernel::scaled(e, k));
  for (const auto& [p, k] : primes(cln::denominator(q))) multiply(into, p, kernel::scaled(e, -k));
}
bool has_log(Expr e) { return is_call(e, "log") || std::ranges::any_of(e.args(), has_log); }
}  // namespace

Sum Forms::of(Expr term) {
  if (const auto it = forms.find(term); it != forms.end()) return it->second;
  const Sum out = forms[term] = computed(term);
  if (out.size() > 1 && (term.op() == Op::Mul || term.op() == Op::Pow)) products.emplace(out, term);
  return out;
}
Sum Forms::computed(Expr term) {
  switch (term.op()) {
    case Op::Num:
      return number(term.value());
    case Op::Var:
      return atom(term);
    case Op::Add:
    case Op::Mul: {
      const bool is_sum = term.op() == Op::Add;
      Sum out = number(is_sum ? 0 : 1);
      for (Expr arg : term.args()) out = is_sum ? out + of(arg) : times(out, of(arg));
      return out;
    }
    case Op::Pow:
      return integer_power(of(term.arg(0)), term.exponent());
    case Op::Fun:
      return function(term);
    default:
      throw TooLarge("neither a number nor a function of numbers");
  }
}
Sum Forms::function(Expr term) {
  const std::string name = term.name();
  if (term.size() == 0) return atom(term);
  Sum x = of(term.arg(0));
  if (is_nothing(x)) x = {};
  if (name == "inv") return integer_power(x, -1);
  if (name == "abs") {
    if (x.empty() || is_not_negative(x)) return x;
    return has_sign(x, -1, false) ? scaled(x, -1) : real_power(x, exponent(1));
  }
  if (name == "exp") return exponential(x);
  if (name == "log") return logarithm(x);
  if (name == "sin" || name == "cos") {
    const Sum there = turned(x), back = turned(scaled(x, -1));
    if (name == "cos") return scaled(there + back, cln::cl_RA(1) / 2);
    return scaled(times(imaginary(), back - there), cln::cl_RA(1) / 2);
  }
  if (name == "acos")
    return scaled(atom(kernel::pi()), cln::cl_RA(1) / 2) - inverse_angle("asin", x);
  if (name == "asin" || name == "atan") return inverse_angle(name, x);
  if (name == "sqrt" || name == "root") {
    const Exponent e = exponent(*root_exponent(term));
    return order_of(term) % 2 == 1 ? odd_root(x, e) : real_power(x, e);
  }
  if (name == "raised") {
    const Sum power = divided(of(term.arg(1)));
    const Exponent e = exponent_of(power);
    // As expression() writes it, and no real power.
    if (term.arg(0) == circle()) return reduced({{circle(), e}});
    const auto k = whole_number(e);
    if (k && std::abs(*k) <= 10000) return integer_power(x, *k);
    if (has_log(expression(power)) &&
        is_positive(x))  // 2^(log(x)/log(2)) is x, x^log(y) is y^log(x)
      return exponential(sum_of(multiplied(e, exponent_of(logarithm(x)))));
    return is_integer(e) ? symbolic_power(x, e) : real_power(x, e);
  }
  Exprs args;
  for (Expr arg : term.args()) args.push_back(real_expression(of(arg)).value_or(arg));
  return atom(kernel::fun(name, args));
}

Sum Forms::integer_power(const Sum& base, int k) {
  if (base.empty() && k <= 0) throw NotDefined("division by zero");
  if (base.empty()) return {};
  if (k > 0 && k <= written_out && base.size() <= 30) {
    Sum out = base;
    for (int i = 1; i < k; ++i) out = times(out, base);
    return out;
  }
  if (k < 0)
    if (const auto inverse = rationalized(base)) return integer_power(*inverse, -k);
  Factors f = factors(base);
  const cln::cl_I parts = cln::numerator(f.number) * cln::denominator(f.number);
  if (cln::integer_length(parts) * std::size_t(std::abs(k)) > 1000000)
    throw TooLarge("a number of more than a million bits");
  f.number = cln::expt(f.number, k);
  for (auto& [atom, e] : f.powers) e = kernel::scaled(e, k);
  return reduced(f.powers, f.number);
}
// 1/(u + v sqrt(p)) = (u - v sqrt(p))/(u^2 - p v^2), prime by prime.
std::optional<Sum> Forms::rationalized(const Sum& constant) {
  const Exponent half = exponent(cln::cl_RA(1) / 2);
  Expr prime;
  for (const auto& [product, q] : constant)
    for (const auto& [atom, e] : product) {
      if (atom.op() != Op::Num || e != half) return {};
      if (!prime || prime < atom) prime = atom;
    }
  if (constant.empty() || constant.size() > most_surds) return {};
  if (!prime) return number(1 / constant.begin()->second);
  Sum conjugate;
  for (const auto& [product, q] : constant) conjugate[product] = product.contains(prime) ? -q : q;
  const auto inverse = rationalized(times(constant, conjugate));
  return inverse ? std::optional(times(conjugate, *inverse)) : std::nullopt;
}
// (1 - a) b/(1 - a) is b.
Exponent Forms::multiplied(const Exponent& a, const Exponent& b) {
  if (number_of(a) || number_of(b)) return a * b;
  Product powers;
  Sum out = number(1);
  for (const Exponent& one : {a, b}) {
    const Factors f = factors(sum_of(one));
    out = scaled(out, f.number);
    for (const auto& [atom, e] : f.powers) multiply(powers, atom, e);
  }
  return exponent_of(divided(times(out, multiplied_out(powers))));
}
/// Its sums to whole powers.
Sum Forms::multiplied_out(const Product& powers) {
  Sum out = number(1);
  for (const auto& [atom, e] : powers) {
    const int k = whole_number(e).value_or(0);
    const bool is_power = composites.contains(atom) && k > 0;
    out = times(out, is_power ? integer_power(composites.at(atom), k) : equality::atom(atom, e));
  }
  return out;
}
// sqrt((x - 1)^2) and (x^2 - 1)/(x + 1) are x - 1.
Sum Forms::cancelled(const Sum& sum) {
  Sum plain, others;
  for (const auto& term : sum) {
    const auto is_sum = [&](const auto& power) { return composites.contains(power.first); };
    (std::ranges::any_of(term.first, is_sum) ? others : plain).insert(term);
  }
  if (others.empty() || is_nothing(others)) return plain;
  const Factors f = factors(others);
  return divided(plain + scaled(multiplied_out(f.powers), f.number));
}
Sum Forms::symbolic_power(const Sum& base, const Exponent& k) {
  if (base.empty()) return {};
  const Factors f = factors(base);
  Product out;
  if (f.number < 0) multiply(out, circle(), k * times_pi(1));
  multiply_number(out, cln::abs(f.number), k);
  for (const auto& [atom, e] : f.powers) multiply(out, atom, multiplied(e, k));
  return reduced(out);
}
// What is not negative is its own modulus, a product of moduli: each has a real power.
Sum Forms::real_power(const Sum& base, const Exponent& exponent) {
  return base.empty() ? Sum() : reduced(power_of_modulus(base, exponent));
}
Product Forms::power_of_modulus(const Sum& base, const Exponent& exponent) {
  const Factors f = factors(base);
  Product out;
  multiply_number(out, cln::abs(f.number), exponent);
  for (const auto& [atom, e] : f.powers) {
    if (atom == circle()) continue;
    const bool is_modulus = is_call(atom, "abs") || sign_of_atom(atom) > 0;
    multiply(out, is_modulus ? atom : absolute(atom), multiplied(e, exponent));
  }
  return out;
}
Sum Forms::odd_root(const Sum& base, const Exponent& e) {
  if (is_not_negative(base)) return real_power(base, e);
  if (has_sign(base, -1, false)) return scaled(real_power(scaled(base, -1), e), -1);
  return times(base, real_power(base, e + exponent(-1)));  // x |x|^(1/k - 1)
}
Sum Forms::logarithm(const Sum& sum) {
  if (sum.empty()) throw NotDefined("the logarithm of 0");
  Sum out;
  for (const auto& [base, e] : power_of_modulus(sum, exponent(1)))
    out = out + (base == euler() ? sum_of(e) : times(sum_of(e), atom(notation::call("log", base))));
  return out;
}
Sum Forms::exponential(const Sum& sum) {
  Product out;
  for (const auto& [product, q] : cancelled(sum)) {
    Product rest = product;
    Expr base = euler();
    for (const auto& [atom, e] : product)
      if (is_call(atom, "log") && e == exponent(1)) base = atom;
    if (base != euler()) {
      rest.erase(base);
      base = base.arg(0);
    }
    multiply(out, base, exponent_of({{rest, q}}));
  }
  return reduced(out);
}

// (2 k - 1)/(2 k + 1) is 1 - 2/(2 k + 1): no symbol is left above what divides it.
Sum Forms::divided(Sum sum) {
  for (auto term = sum.begin(); term != sum.end();) {
    const auto [product, q] = *term++;
    const auto is_sum = [&](const auto& power) { return composites.contains(power.first); };
    if (std::ranges::count_if(product, is_sum) > 1) continue;  // each would undo
    for (const auto& [divisor, power] : product) {
      const auto composite = composites.find(divisor);
      if (composite == composites.end() || power != exponent(-1)) continue;
      const Sum& whole = composite->second;
      // One symbol for each divisor, so that this comes to an end.
      const auto above = std::ranges::find_if(whole, [](const auto& part) {
        return part.first.size() == 1 && part.first.begin()->first.op() == Op::Var &&
               part.first.begin()->second == exponent(1);
      });
      if (above == whole.end()) continue;
      const Expr symbol = above->first.begin()->first;
      if (whole_number(exponent_in(product, symbol)).value_or(0) < 1) continue;
      const auto has_symbol = [&](const auto& part) { return part.first.contains(symbol); };
      if (std::ranges::count_if(whole, has_symbol) > 1) continue;
      Product rest = product;
      multiply(rest, divisor, exponent(1));
      multiply(rest, symbol, exponent(-1));
      const Sum others = whole - Sum{*above};
      const Sum quotient = number(1) - times(others, atom(divisor, exponent(-1)));
      return divided(sum - Sum{{product, q}} + times({{rest, q / above->second}}, quotient));
    }
  }
  return sum;
}
Sum Forms::turned(const Sum& whole_angle) {
  Sum out = number(1);
  Product plain;
  for (const auto& [product, q] : cancelled(whole_angle)) {
    const bool is_inverse = product.size() == 1 && is_arcus(product.begin()->first) &&
                            product.begin()->second == exponent(1);
    if (is_inverse && is_whole(2 * q) && cln::abs(q) <= most_multiples)
      out = times(out, turned_by_inverse(product.begin()->first, q));
    else
      multiply(plain, circle(), exponent_of({{product, q}}));
  }
  return times(out, reduced(plain));
}
Sum Forms::turned_by_inverse(Expr inverse, const cln::cl_RA& multiple) {
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  const Sum u = of(inverse.arg(0));
  const bool is_sine = inverse.name() == "asin";
  const Sum square = times(u, u);
  Sum cosine = is_sine ? real_power(number(1) - square, exponent(half))
                       : real_power(number(1) + square, exponent(-half));
  Sum sine = is_sine ? u : times(u, cosine);
  cln::cl_RA times_taken = cln::abs(multiple);
  if (!is_whole(multiple)) {  // the angle is within -pi/2 and pi/2, so half of it has cosine > 0
    cosine = real_power(scaled(number(1) + cosine, half), exponent(half));
    sine = times(scaled(sine, half), integer_power(cosine, -1));
    times_taken = 2 * times_taken;
  }
  const Sum point = cosine + scaled(times(imaginary(), sine), multiple < 0 ? -1 : 1);
  Sum out = number(1);
  for (cln::cl_RA k = 0; k < times_taken; k = k + 1) out = times(out, point);
  return out;
}
Sum Forms::inverse_angle(const std::string& name, const Sum& sum) {
  if (sum.empty()) return {};
  if (sum.begin()->second < 0) return scaled(inverse_angle(name, scaled(sum, -1)), -1);
  const std::optional<Expr> real = real_expression(sum);
  const Expr x = real ? *real : expression(sum);
  const Expr angle = notation::call(name, x);
  if (!real || !kernel::free_variables(x).empty() || !is_algebraic(x)) return atom(angle);
  if (exact_sign(x) == 0) return {};
  cln::cl_RA q = 0;
  const bool is_part_of_pi = is_proved([&] {
    const Ball turns = enclosure(angle / kernel::pi(), 128);
    const auto near = near_fraction(turns.low(), most_angle_parts);
    if (near) q = *near;
    const Expr part = Expr(q) * kernel::pi();
    const Expr sine = name == "atan" ? x * kernel::cos(part) : x;
    return near && exact_sign(kernel::sin(part) - sine) == 0;
  });
  return is_part_of_pi ? scaled(atom(kernel::pi()), q) : atom(angle);
}
}  // namespace equality
