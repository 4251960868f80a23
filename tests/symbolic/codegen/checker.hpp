// An independent check of what each term of a theorem may be off by, in all tiers and MPFR: it sees
// nothing of the generator, nor of its table. At a point of a case it walks the theorems' terms
// itself, in balls, and counts the roundings of the runtime's operations, each at most half an ulp,
// in the order of double_double.hpp and functions.hpp; functions as at their domain's worst end.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "balls/ball.hpp"
#include "kernel/theorem.hpp"
#include "magicmass/evaluators/polynomials.hpp"

namespace checker {
using balls::Ball;
using cln::cl_RA;
using kernel::Expr;
using kernel::Op;
namespace generated = magicmass::generated;

inline Ball magnitude(const Ball& x) { return x.high() <= 0 ? -x : x; }
/// A double that is at most `size`, and so far off.
struct Rounded {
  double size, off = 0;
  Rounded operator*(double by) const { return {by * size, by * off}; }
};
/// What is computed for x; as far off as is said of its low part.
struct Value {
  Ball x;
  Rounded low = {0};
  bool exact = false;  // a plain double
  double size = x.size();
  double loose() const { return size == 0 ? 0 : low.size / size; }
  bool is_power_of_2() const { return exact && size > 0 && std::exp2(std::ilogb(size)) == size; }
  bool is_whole() const { return exact && cln::denominator(x.low()) == 1; }
};
inline Value magnitude(const Value& v) { return {magnitude(v.x), v.low, v.exact}; }
inline bool is_double(const cl_RA& x) { return balls::exact(cln::double_approx(x)) == x; }
inline Value just(const cl_RA& x) { return {x, {0}, true}; }
inline Value with_low(double x, double low) { return {Ball(x), {low}}; }

/// In DoubleDouble with a tier's polynomials, or in MPFR, which Ziv stands for.
template <class Tier>
class Point {
public:
  static constexpr bool is_pair = !std::is_same_v<Tier, generated::Ziv>;
  static constexpr double u = is_pair ? 0x1p-53 : 0;  // of a pair's doubles
  static constexpr double unit =
      is_pair ? 0 : 0x1p-180;  // of MPFR: what its bounds are printed for
  std::map<Expr, Value> known;
  std::map<std::string, Value> named;  // inputs; other values as far off as is printed
  std::map<std::string, Value> signs;
  std::map<Expr, Expr> squares;  // what an arctangent's argument squared is

  void put(Expr input, const cl_RA& x) { named[input.name()] = known[input] = just(x); }
  Value of(Expr e) {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    return known[e] = computed(e);
  }

private:
  static Rounded fused(Rounded x, Rounded y, Rounded z) {
    const double size = x.size * y.size + z.size;
    return {size, x.size * y.off + x.off * (y.size + y.off) + z.off + u * size};
  }
  static Rounded sum(Rounded x, Rounded y) { return fused({1}, x, y); }
  static Value pair(const Ball& x, Rounded low) {
    return {x, {low.size, low.off + unit * x.size()}};
  }
  static Value plus(const Value& x, const Value& y) {
    const Ball exactly = x.x + y.x;
    const double size = exactly.size();
    if (x.is_whole() && y.is_whole()) return just(exactly.low());
    if (x.exact && y.exact) return pair(exactly, {u * size});
    const Rounded low = sum(sum(x.low, y.low), {u * size});
    // Which sum is taken is not known here: where signs are alike, the better of both.
    if ((x.x.low() >= 0 && y.x.low() >= 0) || (x.x.high() <= 0 && y.x.high() <= 0))
      return pair(exactly, {std::min(low.size, 3 * u * size), low.off});
    // fast_two_sum loses something only where the high parts' sum is below that of the low ones.
    return pair(exactly, {2 * u * size, low.off + u * (x.low.size + y.low.size)});
  }
  static Value times(const Value& x, const Value& y) {
    const Ball product = x.exact && y.exact ? Ball(cl_RA(x.x.low() * y.x.low())) : x.x * y.x;
    const double size = product.size();
    if (size == 0) return just(0);
    if (x.is_power_of_2()) return {product, y.low * x.size, y.exact};
    if (y.is_power_of_2() || (x.exact && !y.exact)) return times(y, x);
    Rounded low = fused(x.low, {y.size}, {u * size});
    if (!y.exact) low = fused({x.size}, y.low, low);
    low.off += (x.low.size + x.low.off) * (y.low.size + y.low.off);  // dropped
    return pair(product, low);
  }
  /// q = x (1/y) is within two roundings: so large is the rest, before the low parts come.
  static Value over(const Value& x, const Value& y) {
    const double by = 1 / y.size;
    if (y.is_power_of_2()) return {x.x / y.x, x.low * by, x.exact};
    const Rounded of_y = fused({x.size * by}, y.low, {0});
    const Rounded rest = sum(sum({2 * u * x.size, 2 * u * u * x.size}, x.low), of_y);
    return pair(x.x / y.x, fused(rest, {by, by * (u + by * y.low.size)}, {0}));
  }
  /// 1/sqrt(y) is within three roundings; 1 - y r^2, e, is twice that and y's low part.
  static Value per_root(const Value& y) {
    const Ball r = Ball(1) / sqrt(y.x);
    const Rounded low = y.low * (1 / y.size);
    const Rounded of_low = fused({1}, fused(low, {1}, {u}), {0});
    const double e = 6 * u + low.size;
    const double off = (7 * u * u + of_low.off + u * e) / 2 + u * e / 2 + 0.375 * e * e;
    return pair(r, Rounded{e / 2, off} * r.size());
  }
  static Rounded plain(std::span<const double> c, double z) {
    if (c.size() == 1) return {std::fabs(c[0])};
    const std::size_t half = std::min<std::size_t>(std::bit_ceil(c.size()) / 2, 8);
    Rounded power{z};
    for (std::size_t k = 1; k < half; k *= 2) power = fused(power, power, {0});
    return fused(plain(c.subspan(half), z), power, plain(c.first(half), z));
  }
  /// Of z, less the polynomial's centre; slope: of the function.
  static Value polynomial(const auto& p, const Value& z, double slope) {
    constexpr std::size_t m = std::decay_t<decltype(p)>::pairs;
    const Rounded tail = plain(std::span(p.high).subspan(m), z.size);
    Ball value = 0;
    double of_slope = 0;  // the tail takes z's high part for z, but for its first coefficient
    for (std::size_t k = p.size; k-- > 0;) {
      value = value * z.x + Ball(p.high[k]) + Ball(k < m ? p.low[k] : 0.0);
      if (k > m) of_slope += double(k - m + 1) * std::fabs(p.high[k]) * std::pow(z.size, k - m);
    }
    double high = tail.size;
    Rounded low{0, tail.off + u * high + z.low.size / z.size * of_slope};
    for (std::size_t k = m; k-- > 0;) {
      const double c = std::fabs(p.high[k]), size = c + z.size * high;
      const double dropped = z.low.size * low.size;
      const Rounded of_low = fused({z.low.size}, {high}, {u * c});
      low = fused({z.size}, low, sum({u * size, u * u * size}, of_low));
      low.off += dropped;
      high = size;
    }
    return {value, {low.size, low.off + slope * z.low.off}};
  }
  /// y p(y^2) in place of the sine, or p(y^2) of the cosine.
  static Rounded odd(const auto& p, const Value& y) {
    return in_place_of(sin(y.x), times(y, polynomial(p, times(y, y), 1.0 / 6)));
  }
  static Rounded even(const auto& p, const Value& y) {
    return in_place_of(cos(y.x), polynomial(p, times(y, y), 1.0 / 2));
  }
  /// Relative to f.
  static Rounded in_place_of(const Ball& f, const Value& v) {
    return Rounded{v.low.size, v.low.off + (f - v.x).size()} * (1 / f.size());
  }
  static Value arc_tangent(const Value& x, const Value& z) {
    Value r{atan(x.x), {0, x.low.off / (1 + z.size)}};
    if constexpr (is_pair) {
      constexpr auto p = Tier::arc_tangent;
      const double top = 2 * p.centre, root = std::sqrt(top);
      const Value end = with_low(root, root * x.loose());
      const Rounded low = sum({u * p.centre}, z.low * (top / z.size));
      const Value instead = polynomial(p, {end.x * end.x - Ball(p.centre), low}, 1.0 / 3);
      add(r, in_place_of(atan(end.x), times(end, instead)) * r.size);
    }
    return pair(r.x, r.low);
  }
  static void add(Value& v, Rounded low) { v.low = {v.low.size + low.size, v.low.off + low.off}; }
  static Value sine_or_cosine(bool is_sine, const Value& x) {
    const Ball sine = x.size == 0 ? 0 : sin(x.x), cosine = cos(x.x);
    const double slope = (is_sine ? cosine : sine).size();
    Value r{is_sine ? sine : cosine, {0, slope * x.low.off}};
    if constexpr (is_pair) {
      if (x.size <= 0.52359905) {
        const Value end = with_low(0.523599, 0.523599 * x.loose());
        add(r, (is_sine ? odd(Tier::small_sine, end) : even(Tier::small_cosine, end)) * r.size);
        return r;
      }
      // A quarter turn may be taken off, and may not: the worse of both.
      const double top = 0.7853981, spill = 3 * top * x.loose() + 0x1.1a7p-54;
      const Value end = with_low(top, spill);
      const Rounded turned = even(Tier::cosine, end);
      const Rounded as_is = odd(Tier::sine, with_low(top, top * x.loose()));
      add(r, Rounded{std::max(turned.size, as_is.size), std::max(turned.off, as_is.off)} * r.size);
      r.low.off += slope * u * (top * x.loose() + 0x1.1a7p-54 + u / 2) / top * x.size;
      // The cosine near 0 is a small y, with that low part, times the polynomial.
      const Value p = polynomial(Tier::sine, times(end, end), 0);
      if (!is_sine) add(r, times(with_low(0x1p-99, spill), p).low);
    }
    return pair(r.x, r.low);
  }
  Value computed(Expr e) {
    if (e.op() == Op::Num)
      return is_double(e.value()) ? just(e.value()) : pair(e.value(), {u * Ball(e.value()).size()});
    if (e.op() == Op::Fun) return function(e);
    Value r = of(e.arg(0));
    if (e.op() == Op::Pow) {
      for (int k = 1; k < e.exponent(); ++k) r = times(r, of(e.arg(0)));
      return r;
    }
    if (e.op() != Op::Add && e.op() != Op::Mul) throw std::logic_error("no rule for a term");
    for (std::size_t k = 1; k < e.size(); ++k) {
      const Expr a = e.arg(k);
      const bool divides = e.op() == Op::Mul && is_call(a, "inv") && !is_call(a.arg(0), "sqrt");
      r = divides ? over(r, of(a.arg(0))) : e.op() == Op::Mul ? times(r, of(a)) : plus(r, of(a));
    }
    return r;
  }
  Value function(Expr e) {
    if (e.name() == "pi") return pair(Ball::pi(), {u * 3.1416});
    if (e.name() == "ceil") return ceiling(e.arg(0));
    if (e.name() == "pow") return raised(of(e.arg(0)), of(e.arg(1)));
    const Expr inner = e.arg(0);
    if (e.name() == "sqrt" && inner.op() == Op::Pow) return magnitude(of(inner.arg(0)));
    if (e.name() == "inv" && is_call(inner, "sqrt")) return per_root(of(inner.arg(0)));
    const Value x = of(inner);
    if (e.name() == "inv") return over(just(1), x);
    if (e.name() == "turn") return just(cln::evenp(cln::numerator(x.x.low())) ? 1 : -1);
    if (e.name() == "sqrt") return times(x, per_root(x));
    if (e.name() == "atan") return arc_tangent(x, of(squares.at(inner)));
    if (e.name() == "sin" || e.name() == "cos") return sine_or_cosine(e.name() == "sin", x);
    throw std::logic_error("no rule for " + e.name());
  }
  /// By squaring: 2^-200, or for MPFR 2^-480, is in place of less, and counts twice.
  static Value raised(const Value& x, const Value& n) {
    const Ball least(is_pair ? 0x1p-200 : 0x1p-480);
    const cln::cl_I k = cln::numerator(n.x.low());
    Ball r = power(x.x, cln::cl_I_to_long(k));
    if (r.low() < least.low()) r = least;
    // A loss of t's own for each product, and each x is off: together less than 2^-22.
    const double share = cln::double_approx(k) * (x.low.off / x.size + 6 * u * u + unit);
    return {r, {u * r.size(), share * r.size() + 2 * least.size()}};
  }
  /// ceil(p/q + c), whose signs are those of |p - q k| and q/2 - |p - q k|, k nearest to p/q.
  Value ceiling(Expr x) {
    const bool is_sum = x.op() == Op::Add;
    const cl_RA c = is_sum ? x.args().back().value() : 0;
    Value p = just(1), q = p;
    for (Expr f : is_sum ? x.arg(0).args() : x.args())
      (is_call(f, "inv") ? q : p) = is_call(f, "inv") ? times(q, of(f.arg(0))) : times(p, of(f));
    const cl_RA whole = (p.x / q.x).low();
    const Value size = magnitude(plus(p, times(q, just(-cln::round1(whole)))));
    if (cln::denominator(c) == 1) signs["distance"] = size;
    signs["to_next"] = plus(times(q, just(cl_RA(1) / 2)), {-size.x, size.low});
    return just(cln::ceiling1(whole + c));
  }
};
}  // namespace checker
