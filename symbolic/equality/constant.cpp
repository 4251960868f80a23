// The bound of separation is that of Burnikel, Funke, Mehlhorn, Schirra and Schmitt (A Separation
// Bound for Real Algebraic Expressions, Algorithmica 55, 2009): a value but 0 is at least
// 1/(u^(D-1) l); u and l bound conjugates of a numerator and a denominator in a field of degree D.
#include <numeric>

#include "equality/normal_form.hpp"

namespace equality {
namespace {
constexpr int first_bits = 128, most_bits = 60000;
constexpr int most_bits_unbounded = 8192;  // where no bound of separation is known

// One walk over a term for all that is computed of it, each part once.
template <class Value>
class Walk {
public:
  Value operator()(Expr e) {
    if (const auto it = known.find(e); it != known.end()) return it->second;
    return known.emplace(e, compute(e)).first->second;
  }

protected:
  explicit Walk(const std::map<Expr, Value>& values = {}) : known(values) {}
  ~Walk() = default;
  virtual Value function(Expr e) = 0;

private:
  std::map<Expr, Value> known;

  Value compute(Expr e) {
    if (e.op() == Op::Num) return Value(e.value());
    if (e.op() == Op::Pow) return power((*this)(e.arg(0)), e.exponent());
    if (e.op() == Op::Fun) return function(e);
    if (e.op() != Op::Add && e.op() != Op::Mul) throw NotCertain("a symbol without a value");
    Value out = (*this)(e.arg(0));
    for (std::size_t i = 1; i < e.size(); ++i) {
      const Value next = (*this)(e.arg(i));
      out = e.op() == Op::Add ? out + next : out * next;
    }
    return out;
  }
};

class Enclosure final : public Walk<Ball> {
public:
  explicit Enclosure(const std::map<Expr, Ball>& values) : Walk(values) {}

private:
  // The sign of what balls with these bits may not tell from 0.
  int sign(Expr e) {
    const Ball value = (*this)(e);
    if (value.low() > 0) return 1;
    if (value.high() < 0) return -1;
    const int bits = Ball::bits;
    const std::optional<int> exact = exact_sign(e);
    Ball::bits = bits;
    if (!exact) throw NotCertain("a sign is not certain");
    return *exact;
  }
  Ball function(Expr e) override {
    const std::string name = e.name();
    if (name == "pi") return Ball::pi();
    if (e.size() == 0) throw NotCertain("the name " + name);
    const Expr x = e.arg(0);
    if (name == "inv") {
      if (sign(x) == 0) throw NotDefined("division by zero");
      return Ball(1) / (*this)(x);
    }
    if (name == "sqrt" || name == "root") return root(x, order_of(e));
    if (name == "raised") return raised(x, e.arg(1));
    if (name == "abs") return sign(x) < 0 ? -(*this)(x) : (*this)(x);
    if (name == "exp") return exp((*this)(x));
    if (name == "log") {
      if (sign(x) <= 0) throw NotDefined("the logarithm of a number that is not positive");
      return log((*this)(x));
    }
    if (name == "sin") return sine(x);
    if (name == "cos") return sine(kernel::pi() / Expr(2) + x);
    if (name == "ceil") return ceil((*this)(x));
    if (name == "atan") return atan((*this)(x));
    if (name == "asin") return arcsine(x);
    if (name == "acos") return (*this)(kernel::pi()) / Ball(2) - arcsine(x);
    throw NotCertain("the function " + name);
  }
  Ball sine(Expr x) {
    const Ball turn = Ball(2) * (*this)(kernel::pi());
    const Ball angle = (*this)(x);
    const cln::cl_I turns = cln::round1((angle / turn).low());
    return sin(angle - Ball(cln::cl_RA(turns)) * turn);
  }
  Ball arcsine(Expr x) {
    const int side = sign(x);
    if (sign(Expr(1) - x) < 0 || sign(Expr(1) + x) < 0)
      throw NotDefined("an inverse sine or cosine of a number beyond 1");
    if (side == 0) return 0;
    const Expr rest = Expr(1) - kernel::power(x, 2);
    if (sign(rest) == 0) return Ball(side) * (*this)(kernel::pi()) / Ball(2);
    return atan((*this)(x) / sqrt((*this)(rest)));
  }
  Ball root(Expr x, int order) {
    const int side = sign(x);
    if (side < 0 && order % 2 == 0)
      throw NotDefined(order == 2 ? "the square root of a negative number"
                                  : "an even root of a negative number");
    if (side == 0) return 0;
    const Ball value = side < 0 ? -(*this)(x) : (*this)(x);
    return order == 2 ? sqrt(value) : Ball(side) * nth_root(value, order);
  }
  Ball raised(Expr base, Expr exponent) {
    auto value = notation::rational_value(exponent);
    if (!value && sign(base) < 0) {
      const Ball power = (*this)(exponent);
      if (power.high() - power.low() > 1) throw NotCertain("whether an exponent is whole");
      value = near_fraction(power.low(), 1);
      if (value && sign(exponent - Expr(*value)) != 0) value.reset();
    }
    const cln::cl_I above = value ? cln::numerator(*value) : 0;
    const cln::cl_I below = value ? cln::denominator(*value) : 0;
    const bool is_short = value && cln::abs(above) * below <= 10000;
    const auto short_power = [&](const Ball& of) {
      return power(of, cln::cl_I_to_int(abs(above)));
    };
    if (is_short && below == 1 && above > 0) return short_power((*this)(base));
    const int side = sign(base);
    if (side < 0 && below != 1) throw NotDefined("a power of a negative number");
    if (side == 0 && sign(exponent) <= 0) throw NotDefined("a power of 0 that has no value");
    if (side == 0) return 0;
    if (is_short) {
      const Ball of = (*this)(base);
      const Ball size = short_power(below == 1 ? of : nth_root(of, cln::cl_I_to_int(below)));
      return above < 0 ? Ball(1) / size : size;
    }
    const Ball size = side < 0 ? -(*this)(base) : (*this)(base);
    const bool is_negative = side < 0 && cln::oddp(above);
    return Ball(is_negative ? -1 : 1) * exp((*this)(exponent)*log(size));
  }
};

double log2_of(const cln::cl_I& n) { return double(cln::integer_length(n)); }
// Logarithms to base 2 of u and l, rounded up.
struct Bounds {
  Bounds(double the_u, double the_l) : u(the_u), l(the_l) {}
  explicit Bounds(const cln::cl_RA& q)
      : u(log2_of(cln::abs(cln::numerator(q)))), l(log2_of(cln::denominator(q))) {}
  Bounds inverse() const { return {l, u}; }
  double u, l;
};
Bounds operator+(Bounds a, Bounds b) { return {std::max(a.u + b.l, a.l + b.u) + 1, a.l + b.l}; }
Bounds operator*(const Bounds& a, const Bounds& b) { return {a.u + b.u, a.l + b.l}; }
Bounds power(const Bounds& base, int exponent) { return {base.u * exponent, base.l * exponent}; }

class Separation final : public Walk<Bounds> {
public:
  std::optional<double> bits(Expr e) try {
    const Bounds bounds = (*this)(e);
    double degree = 1;
    for (const auto& [root, order] : roots)
      if (order != 2 || !is_in_circle(root.arg(0))) degree *= order;
    // The angles' cosines and sines lie in the real part of the field of one root of unity.
    degree *= double(circle) / (circle > 2 ? 2 : 1);
    return (degree - 1) * std::max(bounds.u, 0.0) + bounds.l + 2;
  } catch (const NotCertain&) {
    return {};
  }

private:
  std::map<Expr, int> roots;
  std::int64_t circle = 1;

  // sqrt(m) for a whole m without squares lies in the field of the root of unity of order 4 m.
  bool is_in_circle(Expr radicand) const {
    const auto value = notation::rational_value(radicand);
    if (!value || cln::denominator(*value) != 1 || *value > 1000000) return false;
    std::int64_t m = cln::cl_I_to_int(cln::numerator(*value));
    for (std::int64_t p = 2; p * p <= m; ++p)
      while (m % (p * p) == 0) m /= p * p;
    return m <= 1 || circle % (4 * m) == 0;
  }
  static void need(bool is_small_and_algebraic) {
    if (!is_small_and_algebraic) throw NotCertain("no bound of separation");
  }

  Bounds function(Expr e) override {
    const std::string name = e.name();
    need(e.size() > 0);
    if (name == "sin" || name == "cos") {
      const auto q = multiple_of_pi(e.arg(0));
      need(q && cln::denominator(*q) <= 250000);
      circle = std::lcm(circle, 4 * cln::cl_I_to_int(cln::denominator(*q)));  // of i, too
      need(circle <= 1000000000);
      return {1, 1};
    }
    const Bounds x = (*this)(e.arg(0));
    if (name == "inv") return x.inverse();
    if (name == "abs") return x;
    const auto value = root_exponent(e);
    need(value && cln::abs(cln::numerator(*value)) <= 10000 && cln::denominator(*value) <= 1000);
    if (order_of(e) > 1) roots.emplace(e, order_of(e));
    const double k = order_of(e);
    const auto [u, l] = *value < 0 ? x.inverse() : x;
    const Bounds one = u >= l ? Bounds{(u + (k - 1) * l) / k, l} : Bounds{u, (l + (k - 1) * u) / k};
    return power(one, std::abs(whole(*value)));
  }
};
}  // namespace

std::optional<cln::cl_RA> root_exponent(Expr root) {
  if (is_call(root, "sqrt")) return cln::cl_RA(1) / 2;
  if (is_call(root, "root")) return 1 / root.arg(1).value();
  return is_call(root, "raised") ? notation::rational_value(root.arg(1)) : std::nullopt;
}
int order_of(Expr root) { return cln::cl_I_to_int(cln::denominator(*root_exponent(root))); }

std::optional<cln::cl_RA> multiple_of_pi(Expr e) try {
  const kernel::Polynomial p = kernel::polynomial(e);
  const cln::cl_RA q = of_part(p, {{kernel::pi(), 1}});
  return p == times_pi(q) ? std::optional(q) : std::nullopt;
} catch (const kernel::Refused&) {  // too long
  return {};
}

std::optional<cln::cl_RA> near_fraction(const cln::cl_RA& value, int largest_denominator) {
  for (int below = 1; below <= largest_denominator; ++below) {
    const cln::cl_RA guess = cln::cl_RA(cln::round1(value * below)) / below;
    if (cln::abs(guess - value) < cln::cl_RA(1) / 1000000000) return guess;
  }
  return {};
}

bool is_algebraic(Expr constant) { return Separation().bits(constant).has_value(); }

Ball enclosure(Expr constant, int bits) {
  Ball::bits = bits;
  return Enclosure({})(constant);
}
Ball enclosure(Expr term, const std::map<Expr, Ball>& values) { return Enclosure(values)(term); }

std::optional<int> exact_sign(Expr constant) {
  const auto separation = Separation().bits(constant);
  const bool is_bounded = separation && *separation < most_bits;
  const int most = is_bounded ? 2 * int(*separation) + 1024 : most_bits_unbounded;
  for (int bits = first_bits; bits <= most; bits *= 2) {
    try {
      const Ball value = enclosure(constant, bits);
      if (value.low() > 0) return 1;
      if (value.high() < 0) return -1;
      if (value.low() == value.high()) return 0;
      if (is_bounded && bits > *separation) {
        const cln::cl_RA least = cln::cl_RA(1) / cln::ash(cln::cl_I(1), int(*separation) + 1);
        if (value.high() < least && value.low() > -least) return 0;
      }
    } catch (const NotCertain&) {
    }
    if (!is_bounded && bits == 4 * first_bits && is_zero_constant(constant)) return 0;
  }
  return {};
}
}  // namespace equality
