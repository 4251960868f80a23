// SPDX-License-Identifier: GPL-2.0-or-later
// An independent check of the printed bounds of all tiers and of MPFR, outputs and signs. At random
// points of a case it walks the theorems' terms itself, in balls, and lets each operation lose what
// the table of operations allows; of the analysis it sees the printed text alone. A printed bound
// below what is found is too small. A named value is checked and then taken to be as far off as is
// printed: the next step's bound has to hold for that, and parts of one sum that are largest at
// different points do not hide that it is halved.
#pragma once
#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "balls/ball.hpp"
#include "codegen/lower.hpp"
#include "codegen/operations.hpp"

namespace checker {
using balls::Ball;
using cln::cl_RA;
using codegen::NumberType;
using kernel::Expr;
using kernel::Op;
/// An error bound as it is printed for a reader: "2^-73.7 |P| + 2^-147.4".
struct Bound {
  std::string text;
  double share = 1;  // what the unnamed value whose size it may have is of the value: a power of 2

  /// With the sizes of values at a point; an unnamed one is a share of the value's own.
  double evaluated(const auto& values, double own) const {
    std::istringstream words(text + " +");
    double sum = 0;
    double product = 1;
    for (std::string word; words >> word;) {
      if (word == "+") {
        sum += product;
        product = 1;
      } else if (word[0] != '|') {
        product *= word == "0" ? 0 : std::exp2(std::stod(word.substr(2)));
      } else {
        const auto found = values.find(word.substr(1, word.size() - 2));
        product *= found == values.end() ? own * share : found->second.size;
      }
    }
    return sum;
  }
};
using Printed = std::map<std::string, Bound>;
/// The bounds below a heading: "STEP plus", "OUTPUT a", "SIGN distance".
inline Printed bounds_in(const std::string& errors, const std::string& heading) {
  Printed r;
  const std::size_t from = errors.find(heading + "\n");
  std::istringstream lines(errors.substr(from, errors.find("\n\n", from) - from));
  static const std::regex single("2\\^(\\S+) \\|(t[0-9]+)\\|");
  std::smatch term;
  std::map<std::string, double> exponents, shares;  // of unnamed values
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("  ") || colon == std::string::npos) continue;
    const std::string name = line.substr(2, colon - 2);
    const bool is_step = name.find(' ') == std::string::npos;
    if (!is_step && !name.starts_with("OUTPUT ") && !name.starts_with("SIGN ")) continue;
    std::string text = line.substr(colon + 2, line.find(';') - colon - 2);
    if (text.starts_with("off by ")) text.erase(0, 7);
    Bound& bound = r[(is_step ? "STEP " : "") + name] = {text};
    if (text.size() > 99 || !std::regex_match(text, term, single)) continue;
    const std::string unnamed = term[2];
    const double exponent = std::stod(term[1]);
    if (is_step)
      shares[unnamed] = std::exp2(exponents.insert({unnamed, exponent}).first->second - exponent);
    bound.share = shares.insert({unnamed, 1}).first->second;
  }
  return r;
}

constexpr double u = 0x1p-53;
constexpr double clear = 0x1p23;      // a divisor is tested to be so many times its error
constexpr double printed_up = 0.933;  // exponents are printed up to the next 0.1

inline Ball magnitude(const Ball& x) { return x.high() <= 0 ? -x : x; }
inline double size_of(const Ball& x) {
  return cln::double_approx(cln::max(cln::abs(x.low()), cln::abs(x.high())));
}
struct Value {
  Ball x;
  double off = 0;      // how far a computed value may be from x
  double loose = 0;    // its low part is at most that, relative
  bool exact = false;  // a plain double
  double size = size_of(x);
};
inline Value just(const cl_RA& x) { return {x, 0, 0, true}; }
class Point {
public:
  std::map<Expr, Value> known;
  std::map<std::string, Value> named;  // inputs; other values as far off as is printed
  std::map<std::string, Value> signs;
  std::map<Expr, Expr> squares;  // what an arctangent's argument squared is

  explicit Point(const NumberType& type) : t(type) {}
  void put(Expr input, const cl_RA& x) { named[input.name()] = known[input] = just(x); }
  Value of(Expr e) {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    return known[e] = computed(e);
  }
  /// Returns what is found; from then on the value is off by what is printed, if that is more.
  Value define(const kernel::Theorem& theorem, const Printed& steps) {
    const Expr name = theorem.conclusion().arg(0);
    const Value found = of(theorem.conclusion().arg(1));
    Value v = named[name.name()] = found;
    if (const auto step = steps.find("STEP " + name.name()); step != steps.end())
      v.off = std::max(v.off, step->second.evaluated(named, v.size) * printed_up);
    named[name.name()] = known[name] = v;
    return found;
  }

private:
  NumberType t;

  static Value lossy(const Ball& x, double off, codegen::Loss l) {
    return {x, off + l.loss * size_of(x), l.loose};
  }
  static bool is_power_of_2(const Value& v) {
    return v.exact && v.size > 0 && std::exp2(std::round(std::log2(v.size))) == v.size;
  }
  static bool is_whole(const Value& v) { return v.exact && cln::denominator(v.x.low()) == 1; }
  Value plus(const Value& x, const Value& y) const {
    const Ball sum = x.x + y.x;
    if (is_whole(x) && is_whole(y)) return {sum, 0, 0, true};
    if (x.exact && y.exact) return lossy(sum, 0, t.exact_sum());
    const bool alike = (x.x.low() >= 0 && y.x.low() >= 0) || (x.x.high() <= 0 && y.x.high() <= 0);
    const NumberType::Cancelling c = t.cancelling_sum(x.loose, y.loose);
    double loss = c.of_x * x.size + c.of_y * y.size + c.of_result * size_of(sum);
    double loose = c.loose;
    if (alike) {  // which sum is taken is not known here: the better of both
      const codegen::Loss l = t.sum(x.loose, y.loose);
      loss = std::min(loss, l.loss * size_of(sum));
      loose = std::min(loose, l.loose);
    }
    return lossy(sum, x.off + y.off + loss, {0, loose});
  }
  Value times(const Value& x, const Value& y) const {
    const Ball product = x.exact && y.exact ? Ball(cl_RA(x.x.low() * y.x.low())) : x.x * y.x;
    if (size_of(product) == 0) return just(0);
    if (is_power_of_2(x)) return {product, x.size * y.off, y.loose, y.exact};
    if (is_power_of_2(y)) return times(y, x);
    const double off = x.size * y.off + y.size * x.off + x.off * y.off;
    if (y.exact) return lossy(product, off, t.product(x.loose));
    return lossy(product, off, x.exact ? t.product(y.loose) : t.product(x.loose, y.loose));
  }
  Value over(const Value& x, const Value& y) const {
    const double size = y.size;
    if (is_power_of_2(y)) return {x.x / y.x, x.off / size, x.loose, x.exact};
    const double off = x.off / size + x.size * y.off / (size * (size - y.off));
    return lossy(x.x / y.x, off, t.quotient(x.loose, y.loose));
  }
  Value per_root(const Value& x) const {
    const Ball r = Ball(1) / sqrt(x.x);
    return lossy(r, size_of(r) * x.off / (2 * x.size), t.reciprocal_root(x.loose));
  }
  Value computed(Expr e) {
    if (e.op() == Op::Num)
      return codegen::is_double(e.value()) ? just(e.value()) : lossy(e.value(), 0, t.constant(0));
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
    if (e.name() == "pi") return lossy(Ball::pi(), 0, t.constant(0));
    if (e.name() == "ceil") return ceiling(e.arg(0));
    if (e.name() == "pow") return raised(of(e.arg(0)), of(e.arg(1)));
    const Expr inner = e.arg(0);
    if (e.name() == "sqrt" && inner.op() == Op::Pow) {
      Value x = of(inner.arg(0));
      x.x = magnitude(x.x);
      return x;
    }
    if (e.name() == "inv" && is_call(inner, "sqrt")) return per_root(of(inner.arg(0)));
    const Value x = of(inner);
    if (e.name() == "inv") return over(just(1), x);
    if (e.name() == "turn") return just(cln::evenp(cln::numerator(x.x.low())) ? 1 : -1);
    if (e.name() == "sqrt") return times(x, per_root(x));
    if (e.name() == "atan") {
      const Value z = of(squares.at(inner));
      const codegen::Loss loss = t.arc_tangent(x.loose, z.loose, z.off / z.size);
      return lossy(atan(x.x), x.off / (1 + z.size), loss);
    }
    const bool is_small = x.size <= 0.52359905;
    const auto f = is_small ? t.small_sine_cosine(x.loose) : t.sine_cosine(x.loose);
    const Ball sine = x.size == 0 ? 0 : sin(x.x), cosine = cos(x.x);
    const double angle = x.off + f.angle * x.size;
    if (e.name() == "sin") return lossy(sine, size_of(cosine) * angle, f.sine);
    if (e.name() == "cos") return lossy(cosine, size_of(sine) * angle + f.absolute, f.cosine);
    throw std::logic_error("no rule for " + e.name());
  }
  /// By squaring: 2^-200, or for MPFR 2^-480, is in place of less, and counts twice.
  Value raised(const Value& x, const Value& n) const {
    const double least = t.is_pair() ? 0x1p-200 : 0x1p-480;
    const cln::cl_I k = cln::numerator(n.x.low());
    Ball r = power(x.x, cln::cl_I_to_long(k));
    if (r.low() < codegen::exact(least)) r = Ball(least);
    // A loss of t's own for each product, and each x is off: together less than 2^-22.
    const double share = cln::double_approx(k) * (x.off / x.size + (t.is_pair() ? 6 * u * u : t.u));
    return {r, share * size_of(r) + 2 * least, t.exact_sum().loose};
  }
  /// ceil(p/q + c), whose signs are those of |p - q k| and q/2 - |p - q k|, k nearest to p/q.
  Value ceiling(Expr x) {
    const bool is_sum = x.op() == Op::Add;
    const cl_RA c = is_sum ? x.args().back().value() : 0;
    Value p = just(1), q = p;
    for (Expr f : is_sum ? x.arg(0).args() : x.args())
      (is_call(f, "inv") ? q : p) = is_call(f, "inv") ? times(q, of(f.arg(0))) : times(p, of(f));
    const cl_RA whole = (p.x / q.x).low();
    Value size = plus(p, times(q, just(-cln::round1(whole))));
    size.x = magnitude(size.x);
    if (cln::denominator(c) == 1) signs["distance"] = size;
    Value minus = size;
    minus.x = -size.x;
    signs["to_next"] = plus(times(q, just(cl_RA(1) / 2)), minus);
    return just(cln::ceiling1(whole + c));
  }
};
}  // namespace checker
