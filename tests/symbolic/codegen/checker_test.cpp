// SPDX-License-Identifier: GPL-2.0-or-later
// An independent check of the printed bounds of all tiers, outputs and signs. At random points of a
// case it walks the theorems' terms itself, in outward intervals of exact rationals, and lets each
// operation lose what the table of operations allows; of the analysis it sees the printed text
// alone. A printed bound below what is found is too small.
#include <algorithm>
#include <map>
#include <random>
#include <sstream>

#include "catch.hpp"
#include "codegen/emit_evaluator.hpp"
#include "codegen/exact.hpp"
#include "codegen/operations.hpp"
#include "enclosure.hpp"
#include "quantities.hpp"

namespace {
using codegen::NumberType;
using kernel::Expr;
using kernel::Op;
using test::Enclosure;
constexpr double u = 0x1p-53;

struct Value {
  Enclosure x;
  double off = 0;      // how far a computed value may be from x
  double loose = 0;    // its low part is at most that, relative
  bool exact = false;  // a plain double
  double size() const { return test::size(x); }
};
class Point {
public:
  std::map<Expr, Value> known;
  std::map<std::string, double> sizes;  // of named values
  std::map<std::string, Value> signs;
  std::map<Expr, Expr> squares;  // what an arctangent's argument squared is

  explicit Point(const NumberType& type) : t(type) {}
  Value of(Expr e) {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    return known[e] = computed(e);
  }
  void define(const kernel::Theorem& theorem) {
    const Value v = of(theorem.conclusion().arg(1));
    known[theorem.conclusion().arg(0)] = v;
    sizes[theorem.conclusion().arg(0).name()] = v.size();
  }

private:
  NumberType t;

  static Value lossy(const Enclosure& x, double off, codegen::Loss l) {
    return {x, off + l.loss * test::size(x), l.loose};
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
    double loss = c.of_x * x.size() + c.of_y * y.size() + c.of_result * test::size(sum);
    double loose = c.loose;
    if (alike) {  // which sum is taken is not known here: the better of both
      const codegen::Loss l = t.sum(x.loose, y.loose);
      loss = std::min(loss, l.loss * test::size(sum));
      loose = std::min(loose, l.loose);
    }
    return lossy(sum, x.off + y.off + loss, {0, loose});
  }
  Value times(const Value& x, const Value& y) const {
    const Enclosure product = x.x * y.x;
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
    const Enclosure r = inverse(root(x.x));
    return lossy(r, test::size(r) * x.off / (2 * x.size()), t.reciprocal_root(x.loose));
  }
  static bool is(Expr e, const char* name) { return e.op() == Op::Fun && e.name() == name; }
  Value computed(Expr e) {
    if (e.op() == Op::Num) {
      const bool exact = codegen::is_double(e.value());
      return {test::outward(e.value(), e.value()), 0, exact ? 0 : u, exact};
    }
    if (e.op() == Op::Fun) return function(e);
    Value r = of(e.arg(0));
    if (e.op() == Op::Pow) {
      for (int k = 1; k < e.exponent(); ++k) r = times(r, of(e.arg(0)));
      return r;
    }
    if (e.op() != Op::Add && e.op() != Op::Mul) throw std::logic_error("no rule for a term");
    if (e.op() == Op::Mul && is(e.arg(0), "inv")) r = {{1, 1}, 0, 0, true};
    for (std::size_t k = is(e.arg(0), "inv") ? 0 : 1; k < e.size(); ++k) {
      const Expr a = e.arg(k);
      const bool divides = e.op() == Op::Mul && is(a, "inv") && !is(a.arg(0), "sqrt");
      r = divides ? over(r, of(a.arg(0))) : e.op() == Op::Mul ? times(r, of(a)) : plus(r, of(a));
    }
    return r;
  }
  Value function(Expr e) {
    if (e.name() == "pi") return {test::pi(), 0, u};
    if (e.name() == "ceil") return ceiling(e.arg(0));
    const Expr inner = e.arg(0);
    if (e.name() == "sqrt" && inner.op() == Op::Pow) {
      Value x = of(inner.arg(0));
      x.x = magnitude(x.x);
      return x;
    }
    if (e.name() == "inv" && is(inner, "sqrt")) return per_root(of(inner.arg(0)));
    const Value x = of(inner);
    if (e.name() == "inv") return over({{1, 1}, 0, 0, true}, x);
    if (e.name() == "sqrt") return times(x, per_root(x));
    if (e.name() == "atan") {
      const Value z = of(squares.at(inner));
      const double off = x.off / (1 + z.size());
      const codegen::Loss loss = t.arc_tangent(x.loose, z.loose, z.off / z.size());
      return lossy(test::arc_tangent(x.x), off, loss);
    }
    const bool is_small = x.size() <= 0.5235;
    const NumberType::SineCosine f =
        is_small ? t.small_sine_cosine(x.loose) : t.sine_cosine(x.loose);
    const Enclosure sine = test::sine(x.x);
    const Enclosure cosine = test::cosine(x.x);
    const double angle = x.off + f.angle * x.size();
    if (e.name() == "sin") return lossy(sine, test::size(cosine) * angle, f.sine);
    if (e.name() == "cos") return lossy(cosine, test::size(sine) * angle + f.absolute, f.cosine);
    throw std::logic_error("no rule for " + e.name());
  }
  /// ceil(p/q + c), whose signs are those of |p - q k| and q/2 - |p - q k|, k nearest to p/q.
  Value ceiling(Expr x) {
    Exprs rest = x.args();
    const cln::cl_RA c = rest.back().value();
    const Expr ratio = rest.front();
    Value p{{1, 1}, 0, 0, true}, q = p;
    for (Expr f : ratio.args()) {
      (is(f, "inv") ? q : p) = is(f, "inv") ? times(q, of(f.arg(0))) : times(p, of(f));
    }
    const Enclosure whole = p.x * inverse(q.x);
    const cln::cl_I k = cln::round1(whole.low);
    const Value left = plus(p, times(q, {{-k, -k}, 0, 0, true}));
    Value size = left;
    size.x = magnitude(left.x);
    const Value half{{cln::cl_RA(1) / 2, cln::cl_RA(1) / 2}, 0, 0, true};
    Value minus = size;
    minus.x = -size.x;
    signs["to_next"] = plus(times(q, half), minus);
    if (cln::denominator(c) == 1) signs["distance"] = size;
    const cln::cl_I value = cln::ceiling1(whole.low + c);
    return {{value, value}, 0, 0, true};
  }
  using Exprs = kernel::Exprs;
};

/// "2^-73.7 |P| + 2^-147.4" with the sizes at a point; an unnamed one is that of the value itself.
double printed(const std::string& bound, const std::map<std::string, double>& sizes, double own) {
  std::istringstream words(bound + " +");
  double sum = 0;
  double product = 0;
  for (std::string word; words >> word;) {
    if (word == "+") {
      sum += product;
    } else if (word.substr(0, 2) == "2^") {
      product = std::exp2(std::stod(word.substr(2)));
    } else {
      const auto found = sizes.find(word.substr(1, word.size() - 2));
      product *= found == sizes.end() ? own : found->second;
    }
  }
  return sum;
}
/// A tier's printed bounds: "OUTPUT a", "SIGN distance".
std::map<std::string, std::string> bounds_in(const std::string& errors, const std::string& tier) {
  std::map<std::string, std::string> r;
  const std::size_t from = errors.find(", " + tier + "\n");
  std::istringstream lines(errors.substr(from, errors.find("\n\n", from) - from));
  for (std::string line; std::getline(lines, line);) {
    const bool is_bound = line.starts_with("  OUTPUT ") || line.starts_with("  SIGN ");
    const std::size_t colon = line.find(": ");
    if (is_bound) r[line.substr(2, colon - 2)] = line.substr(colon + 2);
  }
  return r;
}
/// Draws inputs of a case until its guards hold, and evaluates its definitions there.
Point draw(const codegen::Quantity& q, const codegen::Case& c, const NumberType& type,
           std::mt19937_64& random) {
  while (true) {
    Point p(type);
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
      const double share = double(random() >> 11) * 0x1p-53;
      double x = low * std::pow(std::min(r.high, 0x1p40) / low, share);
      if (i.variable.sort() == kernel::Sort::Int) x = std::max(r.low, std::floor(x));
      p.known[i.variable] = {{codegen::exact(x), codegen::exact(x)}, 0, 0, true};
    }
    bool holds = true;
    for (const kernel::Theorem& t : c.definitions) {
      if (!holds) break;
      p.define(t);
      for (const codegen::Condition& g : c.guards) {
        if (p.sizes.count(g.name) > 0) holds = holds && p.sizes.at(g.name) < g.range.high;
      }
    }
    if (holds) return p;
  }
}
/// The least printed bound over error found, by tier and output or sign.
std::map<std::string, double> margins(const codegen::Quantity& q, const std::string& errors) {
  std::map<std::string, double> r;
  const codegen::Case& c = q.cases[0];
  for (const codegen::Tier& tier : codegen::tiers()) {
    std::mt19937_64 random(3);
    const std::map<std::string, std::string> bounds = bounds_in(errors, tier.name);
    REQUIRE_FALSE(bounds.empty());
    for (int row = 0; row < 150; ++row) {
      Point p = draw(q, c, {u, &tier}, random);
      std::map<std::string, Value> values;
      for (const kernel::Theorem& t : c.outputs) {
        const Expr output = t.conclusion().arg(0);
        const std::string name = output.name() == "c'" ? "c_prime" : output.name();
        const Value v = p.of(t.conclusion().arg(1));
        if (output.sort() == kernel::Sort::Int) continue;
        values["OUTPUT " + name] = v;
        values["OUTPUT " + name].off += u * v.loose * v.size();
      }
      for (const auto& [name, v] : p.signs) {
        values["SIGN " + name] = v;
        values["SIGN " + name].off += v.loose * v.size();
      }
      for (const auto& [name, v] : values) {
        if (v.off == 0) continue;
        const double margin = printed(bounds.at(name), p.sizes, v.size()) / v.off;
        double& least = r.insert({tier.name + " " + name, margin}).first->second;
        least = std::min(least, margin);
      }
    }
    CHECK(std::count_if(r.begin(), r.end(), [&](const auto& m) {
            return m.first.starts_with(tier.name + " ");
          }) == long(bounds.size()));
  }
  return r;
}
/// Outputs of one or two operations, so that what operands are off by shows.
codegen::Quantity short_ones() {
  const Expr alpha = kernel::real("alpha");
  const auto named = [&](const char* name, Expr term) {
    return kernel::define(std::string("checked_") + name, {alpha}, term);
  };
  const kernel::Theorem two = named("two", (2 + alpha) * (3 + alpha));
  const Expr x = two.conclusion().arg(0);
  codegen::Case c{"only", {}, {two}, {}, {}, {}};
  c.outputs = {named("root", 1 / kernel::sqrt(x)),
               named("quotient", x / (x + 1)),
               named("product", x * x),
               named("times", x * alpha),
               named("sum", x + x * x),
               named("cosine", kernel::cos(kernel::sin(alpha)))};
  return {"short_ones", "none", {{alpha, {0.01, 0.52}, {0.01, 0.52}}}, {c}};
}
}  // namespace

TEST_CASE("the independent checker finds no printed bound too small, and sees each one halved") {
  // Bounds of these are constants times one size, made of parts that are largest at other points.
  const std::map<std::string, double> wider{
      {"OUTPUT a", 2.1}, {"OUTPUT c", 2.1}, {"OUTPUT c_prime", 2.9}, {"OUTPUT a_t", 2.4}};
  std::vector<codegen::Quantity> all = test::quantities();
  all.push_back(short_ones());
  for (const codegen::Quantity& q : all) {
    for (const auto& [name, margin] : margins(q, codegen::emit_evaluator(q).errors)) {
      INFO(q.name << ", " << name << ": printed over found: " << margin);
      const auto found = wider.find(name.substr(name.find(' ') + 1));
      CHECK(margin >= 1);
      CHECK(margin < (found == wider.end() ? 2 : found->second));
    }
  }
}
