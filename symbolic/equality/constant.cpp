// SPDX-License-Identifier: GPL-2.0-or-later
// The bound of separation is that of Burnikel, Funke, Mehlhorn, Schirra and Schmitt (A Separation
// Bound for Real Algebraic Expressions, Algorithmica 55, 2009): a value that is not 0 is at least
// 1/(u^(D-1) l), where u and l bound the conjugates of a numerator and of a denominator, and D the
// degree of the field.
#include "equality/constant.hpp"

#include <cmath>
#include <map>
#include <numeric>

#include "equality/normal_form.hpp"

namespace equality {
using kernel::Op;
namespace {
constexpr int first_bits = 128;
constexpr int most_bits = 60000;
constexpr int most_bits_unbounded = 8192;  // where no bound of separation is known

class Enclosure {
public:
  explicit Enclosure(const std::map<Expr, Ball>& values) : known(values) {}
  Ball operator()(Expr e) {
    if (const auto it = known.find(e); it != known.end()) return it->second;
    const Ball value = compute(e);
    known.emplace(e, value);
    return value;
  }

private:
  std::map<Expr, Ball> known;

  Ball compute(Expr e) {
    switch (e.op()) {
      case Op::Num:
        return Ball(e.value());
      case Op::Add: {
        Ball sum = 0;
        for (Expr arg : e.args()) sum = sum + (*this)(arg);
        return sum;
      }
      case Op::Mul: {
        Ball product = 1;
        for (Expr arg : e.args()) product = product * (*this)(arg);
        return product;
      }
      case Op::Pow:
        return power((*this)(e.arg(0)), e.exponent());
      case Op::Fun:
        return function(e);
      default:
        throw NotCertain("a symbol without a value");
    }
  }

  // The sign of what balls with these bits may not tell from 0.
  int sign(Expr e) {
    const Ball value = (*this)(e);
    if (value.low() > 0) return 1;
    if (value.high() < 0) return -1;
    const int bits = Ball::bits();
    const std::optional<int> exact = exact_sign(e);
    Ball::set_bits(bits);
    if (!exact) throw NotCertain("a sign is not certain");
    return *exact;
  }
  Ball function(Expr e) {
    const std::string name = e.name();
    if (name == "pi") return Ball::pi();
    if (e.size() == 0) throw NotCertain("the name " + name);
    const Expr x = e.arg(0);
    if (name == "inv") {
      if (sign(x) == 0) throw NotDefined("division by zero");
      return Ball(1) / (*this)(x);
    }
    if (name == "sqrt") return root(x, 2);
    if (name == "nth_root") return root(x, cln::cl_I_to_int(cln::numerator(e.arg(1).value())));
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
    if (order == 2) return sqrt(value);
    return Ball(side) * exp(log(value) / Ball(order));
  }
  Ball raised(Expr base, Expr exponent) {
    const auto value = notation::rational_value(exponent);
    if (value && cln::denominator(*value) == 1 && cln::abs(*value) <= 10000) {
      const int n = cln::cl_I_to_int(cln::numerator(*value));
      if (n <= 0 && sign(base) == 0) throw NotDefined("a power of 0 that has no value");
      const Ball whole = power((*this)(base), std::abs(n));
      return n < 0 ? Ball(1) / whole : whole;
    }
    const int side = sign(base);
    const bool is_whole = value && cln::denominator(*value) == 1;
    if (side < 0 && !is_whole) throw NotDefined("a power of a negative number");
    if (side != 0) {
      const Ball size = side < 0 ? -(*this)(base) : (*this)(base);
      const bool is_negative = side < 0 && cln::oddp(cln::numerator(*value));
      return Ball(is_negative ? -1 : 1) * exp((*this)(exponent)*log(size));
    }
    if (sign(exponent) <= 0) throw NotDefined("a power of 0 that has no value");
    return 0;
  }
};

// Logarithms to base 2 of u and l, rounded up; the degree as its logarithm.
struct Bounds {
  double u = 0;
  double l = 0;
};
class Separation {
public:
  std::optional<double> bits(Expr e) {
    const auto bounds = of(e);
    if (!bounds) return {};
    double degree = 1;
    for (const auto& [root, order] : roots) degree *= order;
    // The angles' cosines and sines lie in the field of one root of unity.
    if (circle > 1) degree *= totient(circle);
    return (degree - 1) * std::max(bounds->u, 0.0) + bounds->l + 2;
  }

private:
  std::map<Expr, int> roots;
  double circle = 1;
  std::map<Expr, std::optional<Bounds>> known;

  static double log2_of(const cln::cl_I& n) { return double(cln::integer_length(cln::abs(n))); }
  static double totient(double n) {
    double left = n;
    double out = n;
    for (double p = 2; p * p <= left; ++p) {
      if (std::fmod(left, p) != 0) continue;
      while (std::fmod(left, p) == 0) left /= p;
      out -= out / p;
    }
    return left > 1 ? out - out / left : out;
  }
  static Bounds product(Bounds a, Bounds b) { return {a.u + b.u, a.l + b.l}; }

  std::optional<Bounds> of(Expr e) {
    if (const auto it = known.find(e); it != known.end()) return it->second;
    const auto found = compute(e);
    known.emplace(e, found);
    return found;
  }
  std::optional<Bounds> compute(Expr e) {
    switch (e.op()) {
      case Op::Num:
        return Bounds{log2_of(cln::numerator(e.value())), log2_of(cln::denominator(e.value()))};
      case Op::Add:
      case Op::Mul: {
        std::optional<Bounds> out;
        for (Expr arg : e.args()) {
          const auto next = of(arg);
          if (!next) return {};
          if (!out)
            out = next;
          else if (e.op() == Op::Mul)
            out = product(*out, *next);
          else
            out = Bounds{std::max(out->u + next->l, out->l + next->u) + 1, out->l + next->l};
        }
        return out;
      }
      case Op::Pow: {
        const auto base = of(e.arg(0));
        if (!base) return {};
        return Bounds{base->u * e.exponent(), base->l * e.exponent()};
      }
      case Op::Fun:
        return function(e);
      default:
        return {};
    }
  }
  std::optional<Bounds> function(Expr e) {
    const std::string name = e.name();
    if (name == "sin" || name == "cos") {
      const auto q = multiple_of_pi(e.arg(0));
      if (!q) return {};
      const double order = 4 * cln::double_approx(cln::denominator(*q));  // of i, too
      if (order > 1e6) return {};
      circle = double(std::lcm(static_cast<long long>(circle), static_cast<long long>(order)));
      if (circle > 1e9) return {};
      return Bounds{1, 1};
    }
    if (e.size() == 0) return {};
    const auto x = of(e.arg(0));
    if (!x) return {};
    if (name == "inv") return Bounds{x->l, x->u};
    if (name == "abs") return x;
    if (name == "sqrt") return root(e, *x, 2, 1);
    if (name == "nth_root")
      return root(e, *x, cln::cl_I_to_int(cln::numerator(e.arg(1).value())), 1);
    const auto value = name == "raised" ? notation::rational_value(e.arg(1)) : std::nullopt;
    if (!value) return {};
    const cln::cl_RA exponent = *value;
    if (cln::abs(cln::numerator(exponent)) > 10000 || cln::denominator(exponent) > 1000) return {};
    const Bounds base = exponent < 0 ? Bounds{x->l, x->u} : *x;
    return root(e, base, cln::cl_I_to_int(cln::denominator(exponent)),
                std::abs(cln::cl_I_to_int(cln::numerator(exponent))));
  }
  Bounds root(Expr e, Bounds x, int order, int exponent) {
    if (order > 1) roots.emplace(e, order);
    const double k = order;
    const Bounds one = x.u >= x.l ? Bounds{(x.u + (k - 1) * x.l) / k, x.l}
                                  : Bounds{x.u, (x.l + (k - 1) * x.u) / k};
    return {one.u * exponent, one.l * exponent};
  }
};
}  // namespace

bool is_function(Expr e, const char* name) { return e.op() == Op::Fun && e.name() == name; }

std::optional<cln::cl_RA> multiple_of_pi(Expr e) {
  if (e == kernel::pi()) return cln::cl_RA(1);
  if (e == Expr(0)) return cln::cl_RA(0);
  if (e.op() == Op::Add) {
    cln::cl_RA total = 0;
    for (Expr arg : e.args()) {
      const auto part = multiple_of_pi(arg);
      if (!part) return {};
      total = total + *part;
    }
    return total;
  }
  if (e.op() != Op::Mul) return {};
  cln::cl_RA factor = 1;
  int pis = 0;
  for (Expr arg : e.args()) {
    const Expr below = is_function(arg, "inv") ? arg.arg(0) : arg;
    if (below == kernel::pi() && below == arg)
      ++pis;
    else if (below.op() == Op::Num && below.value() != 0)
      factor = below == arg ? factor * below.value() : factor / below.value();
    else
      return {};
  }
  if (pis != 1) return {};
  return factor;
}

bool is_algebraic(Expr constant) { return Separation().bits(constant).has_value(); }

Ball enclosure(Expr constant, int bits) {
  Ball::set_bits(bits);
  return Enclosure({})(constant);
}
Ball enclosure(Expr term, const std::map<Expr, Ball>& values) { return Enclosure(values)(term); }

std::optional<int> exact_sign(Expr constant) {
  if (constant.op() == Op::Num) return constant.value() > 0 ? 1 : constant.value() < 0 ? -1 : 0;
  const auto separation = Separation().bits(constant);
  const bool is_bounded = separation && *separation < most_bits;
  const int most = is_bounded ? 2 * int(*separation) + 1024 : most_bits_unbounded;
  for (int bits = first_bits; bits <= most; bits *= 2) {
    try {
      const Ball value = enclosure(constant, bits);
      if (value.low() > 0) return 1;
      if (value.high() < 0) return -1;
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
