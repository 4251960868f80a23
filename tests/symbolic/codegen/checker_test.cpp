// SPDX-License-Identifier: GPL-2.0-or-later
// An independent check of the printed bounds of all tiers and of MPFR, outputs and signs. At random
// points of a case it walks the theorems' terms itself, in outward intervals of exact rationals,
// and lets each operation lose what the table of operations allows; of the analysis it sees the
// printed text alone. A printed bound below what is found is too small. A named value is checked
// and then taken to be as far off as is printed: the next step's bound has to hold for that, and
// parts of one sum that are largest at different points do not hide that it is halved.
#include <algorithm>
#include <map>
#include <random>

#include "catch.hpp"
#include "codegen/emit_evaluator.hpp"
#include "codegen/exact.hpp"
#include "codegen/operations.hpp"
#include "enclosure.hpp"
#include "generate/quantities.hpp"
#include "printed.hpp"

namespace {
using codegen::NumberType;
using kernel::Expr;
using kernel::Op;
using test::Enclosure;
using test::Printed;
constexpr double u = 0x1p-53;
constexpr double clear = 0x1p23;      // a divisor is tested to be so many times its error
constexpr double printed_up = 0.933;  // exponents are printed up to the next 0.1

struct Value {
  Enclosure x;
  double off = 0;      // how far a computed value may be from x
  double loose = 0;    // its low part is at most that, relative
  bool exact = false;  // a plain double
  double size() const { return test::size(x); }
};
Value just(const cln::cl_RA& x) { return {{x, x}, 0, 0, true}; }
const Value one = just(1);
class Point {
public:
  std::map<Expr, Value> known;
  std::map<std::string, double> sizes;  // of named values
  std::map<std::string, Value> signs;
  std::map<std::string, Value> named;  // as far off as is printed
  std::map<Expr, Expr> squares;        // what an arctangent's argument squared is

  explicit Point(const NumberType& type) : t(type) {}
  Value of(Expr e) {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    return known[e] = computed(e);
  }
  /// Returns what is found; from then on the value is off by what is printed, if that is more.
  Value define(const kernel::Theorem& theorem, const Printed& steps) {
    const Expr name = theorem.conclusion().arg(0);
    const Value found = of(theorem.conclusion().arg(1));
    Value& v = known[name] = found;
    sizes[name.name()] = v.size();
    if (const auto step = steps.find("STEP " + name.name()); step != steps.end()) {
      v.off = std::max(v.off, test::evaluated(step->second, sizes, v.size()) * printed_up);
    }
    named[name.name()] = v;
    return found;
  }

private:
  NumberType t;

  static Value lossy(const Enclosure& x, double off, codegen::Loss l) {
    return {x, off + l.loss * size(x), l.loose};
  }
  static bool is_power_of_2(const Value& v) {
    return v.exact && v.size() > 0 && std::exp2(std::round(std::log2(v.size()))) == v.size();
  }
  static bool is_whole(const Value& v) { return v.exact && cln::denominator(v.x.low) == 1; }
  Value plus(const Value& x, const Value& y) const {
    const Enclosure sum = x.x + y.x;
    if (is_whole(x) && is_whole(y)) return {sum, 0, 0, true};
    if (x.exact && y.exact) return lossy(sum, 0, t.exact_sum());
    const bool alike = (x.x.low >= 0 && y.x.low >= 0) || (x.x.high <= 0 && y.x.high <= 0);
    const NumberType::Cancelling c = t.cancelling_sum(x.loose, y.loose);
    double loss = c.of_x * x.size() + c.of_y * y.size() + c.of_result * size(sum);
    double loose = c.loose;
    if (alike) {  // which sum is taken is not known here: the better of both
      const codegen::Loss l = t.sum(x.loose, y.loose);
      loss = std::min(loss, l.loss * size(sum));
      loose = std::min(loose, l.loose);
    }
    return lossy(sum, x.off + y.off + loss, {0, loose});
  }
  Value times(const Value& x, const Value& y) const {
    const Enclosure product = x.x * y.x;
    if (size(product) == 0) return just(0);
    if (is_power_of_2(x)) return {product, x.size() * y.off, y.loose, y.exact};
    if (is_power_of_2(y)) return {product, y.size() * x.off, x.loose, x.exact};
    const double off = x.size() * y.off + y.size() * x.off + x.off * y.off;
    if (y.exact) return lossy(product, off, t.product(x.loose));
    return lossy(product, off, x.exact ? t.product(y.loose) : t.product(x.loose, y.loose));
  }
  Value over(const Value& x, const Value& y) const {
    if (is_power_of_2(y)) return {x.x * inverse(y.x), x.off / y.size(), x.loose, x.exact};
    const double size = y.size();
    const double off = x.off / size + x.size() * y.off / (size * (size - y.off));
    return lossy(x.x * inverse(y.x), off, t.quotient(x.loose, y.loose));
  }
  Value per_root(const Value& x) const {
    const Enclosure r = inverse(of_function(cln::sqrt, x.x, 1 / cln::min(x.x.low, 1)));
    return lossy(r, size(r) * x.off / (2 * x.size()), t.reciprocal_root(x.loose));
  }
  static bool is(Expr e, const char* name) { return e.op() == Op::Fun && e.name() == name; }
  Value computed(Expr e) {
    if (e.op() == Op::Num) {
      const bool exact = codegen::is_double(e.value());
      const Enclosure x = test::outward(e.value(), e.value());
      return exact ? Value{x, 0, 0, true} : lossy(x, 0, t.constant(0));
    }
    if (e.op() == Op::Fun) return function(e);
    Value r = of(e.arg(0));
    if (e.op() == Op::Pow) {
      for (int k = 1; k < e.exponent(); ++k) r = times(r, of(e.arg(0)));
      return r;
    }
    if (e.op() != Op::Add && e.op() != Op::Mul) throw std::logic_error("no rule for a term");
    if (e.op() == Op::Mul && is(e.arg(0), "inv")) r = one;
    for (std::size_t k = is(e.arg(0), "inv") ? 0 : 1; k < e.size(); ++k) {
      const Expr a = e.arg(k);
      const bool divides = e.op() == Op::Mul && is(a, "inv") && !is(a.arg(0), "sqrt");
      r = divides ? over(r, of(a.arg(0))) : e.op() == Op::Mul ? times(r, of(a)) : plus(r, of(a));
    }
    return r;
  }
  Value function(Expr e) {
    if (e.name() == "pi") {
      const cln::cl_RA pi = cln::rational(cln::pi(cln::float_format(75)));
      return lossy(Enclosure{pi, pi} * Enclosure{1 - cln::expt(cln::cl_RA(2), -test::bits), 1}, 0,
                   t.constant(0));
    }
    if (e.name() == "ceil") return ceiling(e.arg(0));
    if (e.name() == "pow") return power(of(e.arg(0)), of(e.arg(1)));
    const Expr inner = e.arg(0);
    if (e.name() == "sqrt" && inner.op() == Op::Pow) {
      Value x = of(inner.arg(0));
      x.x = magnitude(x.x);
      return x;
    }
    if (e.name() == "inv" && is(inner, "sqrt")) return per_root(of(inner.arg(0)));
    const Value x = of(inner);
    if (e.name() == "inv") return over(one, x);
    if (e.name() == "turn") return just(cln::evenp(cln::numerator(x.x.low)) ? 1 : -1);
    if (e.name() == "sqrt") return times(x, per_root(x));
    if (e.name() == "atan") {
      const Value z = of(squares.at(inner));
      const double off = x.off / (1 + z.size());
      const codegen::Loss loss = t.arc_tangent(x.loose, z.loose, z.off / z.size());
      return lossy(of_function(cln::atan, x.x, 1), off, loss);
    }
    const bool is_small = x.size() <= 0.52359905;
    const NumberType::SineCosine f =
        is_small ? t.small_sine_cosine(x.loose) : t.sine_cosine(x.loose);
    const Enclosure sine = of_function(cln::sin, x.x, 1);
    const Enclosure cosine = of_function(cln::cos, x.x, 1);
    const double angle = x.off + f.angle * x.size();
    if (e.name() == "sin") return lossy(sine, size(cosine) * angle, f.sine);
    if (e.name() == "cos") return lossy(cosine, size(sine) * angle + f.absolute, f.cosine);
    throw std::logic_error("no rule for " + e.name());
  }
  /// By squaring; what is below 2^-200, or for MPFR 2^-480, may be anything up to there.
  Value power(Value x, const Value& n) const {
    const cln::cl_RA least = cln::expt(cln::cl_RA(2), t.is_pair() ? -200 : -480);
    const cln::cl_I k = cln::numerator(n.x.low);
    Enclosure r = one.x;
    Enclosure square = x.x;
    for (cln::cl_I left = k; left > 0; left = left >> 1) {
      if (cln::oddp(left)) r = r * square;
      square = square * square;
      for (Enclosure* y : {&r, &square})
        if (y->low < least) *y = {0, cln::max(y->high, least)};
    }
    // A loss of t's own for each product, and each x is off: together less than 2^-22.
    const double share =
        cln::double_approx(k) * (x.off / x.size() + (t.is_pair() ? 6 * u * u : t.u));
    return {r, share * size(r) + 2 * cln::double_approx(least), t.exact_sum().loose};
  }
  /// ceil(p/q + c), whose signs are those of |p - q k| and q/2 - |p - q k|, k nearest to p/q.
  Value ceiling(Expr x) {
    const bool is_sum = x.op() == Op::Add;
    const cln::cl_RA c = is_sum ? x.args().back().value() : 0;
    Value p = one;
    Value q = one;
    for (Expr f : is_sum ? x.arg(0).args() : x.args()) {
      (is(f, "inv") ? q : p) = is(f, "inv") ? times(q, of(f.arg(0))) : times(p, of(f));
    }
    const Enclosure whole = p.x * inverse(q.x);
    const cln::cl_I k = cln::round1(whole.low);
    const Value left = plus(p, times(q, just(-k)));
    Value size = left;
    size.x = magnitude(left.x);
    Value minus = size;
    minus.x = -size.x;
    signs["to_next"] = plus(times(q, just(cln::cl_RA(1) / 2)), minus);
    if (cln::denominator(c) == 1) signs["distance"] = size;
    return just(cln::ceiling1(whole.low + c));
  }
};

/// A ball at which inelastic collapse is so far: share = 1 - (1 - e)^2/(4 e m (1 + w (1 + m))).
cln::cl_RA near_collapse(const cln::cl_RA& e, const cln::cl_RA& w, const cln::cl_RA& share) {
  const cln::cl_RA x = (1 - e) * (1 - e) / (4 * e * (1 - share)), b = 1 + w;
  return 2 * x / (test::by_float(cln::sqrt, b * b + 4 * w * x) + b);
}
/// Draws inputs of a case until its guards hold, and evaluates its definitions there.
Point draw(const codegen::Quantity& q, const codegen::Case& c, const NumberType& type,
           std::mt19937_64& random, const Printed& steps, const auto& seen) {
  const auto number = [&] { return double(random() >> 11) * 0x1p-53; };
  while (true) {
    Point p(type);
    for (const auto& [unit, value] : q.units) p.known[unit] = just(value.value());
    for (const codegen::Fact& f : c.facts) {
      const bool is_square = f.formula.op() == Op::Eq;
      if (is_square) p.squares[f.formula.arg(0).arg(0)] = f.formula.arg(1);
    }
    for (const codegen::Input& i : q.inputs) {
      codegen::Interval r = i.range;
      for (const codegen::Condition& w : c.where) {
        if (w.name == i.variable.name())
          r = {std::max(r.low, w.range.low), std::min(r.high, w.range.high)};
      }
      const double low = std::max(r.low, 0x1p-40);
      double x = low * std::pow(std::min(r.high, 0x1p40) / low, number());
      if (i.variable.sort() == kernel::Sort::Int) x = std::max(r.low, std::floor(x));
      p.known[i.variable] = just(codegen::exact(x));
    }
    if (q.name == "restitution") {
      const double e =
          random() % 2 == 0 ? std::exp2(-40 * number()) : 1 - std::exp2(-30 * number());
      const cln::cl_RA part =
          codegen::exact(std::exp2((type.is_pair() ? -30 : -80) * std::sqrt(number())));
      const cln::cl_RA share = random() % 2 == 0 ? part : 1 - part;
      const double w = c.name == "wall" ? 0 : std::exp2(40 * number() - 20);
      const cln::cl_RA ball = near_collapse(codegen::exact(e), codegen::exact(w), share);
      p.known[kernel::real("e")] = just(codegen::exact(e));
      p.known[kernel::real("w_B")] = just(codegen::exact(w));
      p.known[kernel::real("M_C")] =
          just(type.is_pair() ? codegen::exact(codegen::nearest(ball)) : ball);
    }
    for (const codegen::Input& i : q.inputs)
      p.sizes[i.variable.name()] = p.known.at(i.variable).size();
    const bool holds =
        std::all_of(c.definitions.begin(), c.definitions.end(), [&](const kernel::Theorem& t) {
          const Value found = p.define(t, steps);
          const std::string name = t.conclusion().arg(0).name();
          for (const codegen::Condition& g : c.guards) {
            const codegen::Interval range = g.of(!type.is_pair());
            if (g.name == name && !(found.x.low > codegen::exact(range.low) &&
                                    found.x.high < codegen::exact(range.high)))
              return false;
          }
          for (const std::string& d : c.divisors) {
            if (d == name && !(found.x.low > codegen::exact(clear * p.named.at(d).off)))
              return false;
          }
          seen("STEP " + name, found, p);
          return true;
        });
    if (holds) return p;
  }
}
/// The least printed bound over error found, by step, output or sign.
std::map<std::string, double> margins(const codegen::Quantity& q, const codegen::Case& c,
                                      const NumberType& type, const Printed& bounds) {
  std::map<std::string, double> r;
  std::mt19937_64 random(3);
  const auto seen = [&](const std::string& name, const Value& found, const Point& p) {
    const auto bound = bounds.find(name);
    if (found.off == 0 || bound == bounds.end()) return;
    const double margin = test::evaluated(bound->second, p.sizes, found.size()) / found.off;
    double& least = r.insert({name, margin}).first->second;
    least = std::min(least, margin);
  };
  for (int row = 0; row < (c.divisors.empty() ? 150 : 1000); ++row) {
    Point p = draw(q, c, type, random, bounds, seen);
    for (const kernel::Theorem& t : c.outputs) {
      const Expr output = t.conclusion().arg(0);
      const std::string name = output.name() == "c'" ? "c_prime" : output.name();
      Value v = p.known[output] = p.of(t.conclusion().arg(1));
      if (output.sort() == kernel::Sort::Int) continue;
      const bool is_rounded = type.is_pair() ? v.off > 0 || v.loose > u : !v.exact;
      if (is_rounded) v.off += type.rounding_test(v.loose) * v.size();
      seen("OUTPUT " + name, v, p);
    }
    for (const std::string& name : c.divisors) {
      Value v = p.named.at(name);
      v.off *= clear;
      seen("SIGN " + name, v, p);
    }
    for (auto [name, v] : p.signs) {
      v.off += (type.is_pair() ? v.loose : type.u) * v.size();
      seen("SIGN " + name, v, p);
    }
  }
  for (const auto& [name, bound] : bounds) {
    if (!name.starts_with("STEP ") && bound != "0" && !bound.starts_with("0 "))
      CHECK(r.count(name) == 1);
  }
  return r;
}
/// What the paper's quantities lack: a sum of two values of one sign that are both off by a share,
/// and an output that loses no more than its rounding test.
codegen::Quantity sum_and_square() {
  const Expr alpha = kernel::real("alpha");
  const kernel::Theorem x = kernel::define("checked_x", {alpha}, (2 + alpha) * (3 + alpha));
  const Expr of_x = x.conclusion().arg(0);
  codegen::Case c{"only", {}, {x}, {}, {}, {}};
  c.outputs = {kernel::define("checked_sum", {alpha}, of_x + of_x * of_x),
               kernel::define("checked_square", {alpha}, alpha * alpha)};
  return {"sum", "none", {{alpha, {0.01, 0.52}, {0.01, 0.52}}}, {c}};
}
}  // namespace

TEST_CASE("the independent checker finds no printed bound too small, and sees each one halved") {
  generate::Source source;
  std::vector<codegen::Quantity> all = generate::evaluators(source);
  all.push_back(sum_and_square());
  std::vector<NumberType> types{{0x1p-180, nullptr}};  // what its bounds are printed for
  for (const codegen::Tier& tier : codegen::tiers()) types.push_back({u, &tier});
  for (const codegen::Quantity& q : all) {
    const std::string errors = codegen::emit_evaluator(q).errors;
    for (const codegen::Case& c : q.cases) {
      for (const NumberType& type : types) {
        const std::string heading =
            codegen::capital(q.name) + codegen::capital(c.name) + ", " + type.name();
        const Printed bounds = test::bounds_in(errors, heading);
        REQUIRE_FALSE(bounds.empty());
        for (const auto& [name, margin] : margins(q, c, type, bounds)) {
          INFO(heading << ", " << name << ": printed over found: " << margin);
          CHECK(margin >= 1 - 0x1p-40);  // its own roundings
          // Terms that are largest at other points are taken into these: a longer sum.
          CHECK(margin < (q.name == "restitution" && name.starts_with("OUTPUT") ? 8 : 2));
        }
      }
    }
  }
}
