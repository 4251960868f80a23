// SPDX-License-Identifier: GPL-2.0-or-later
// An independent check of the printed bounds. At random points of a case it walks the theorems'
// terms itself, in floats of 90 digits, with its own rules for errors; each function and operation
// may lose what it is known to lose at its worst. Nothing of the analysis is used but its text. A
// printed bound below what is found here is too small.
#include <cmath>
#include <map>
#include <random>
#include <sstream>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include "catch.hpp"
#include "codegen/emit_evaluator.hpp"
#include "quantities.hpp"

namespace {
using cln::cl_R;
using kernel::Expr;
using kernel::Op;

// Accurate's worst functions, and an operation of DoubleDouble, lose this.
const double of_function = std::exp2(-77);
const double of_operation = 0x1p-106;

struct Value {
  cl_R exact;
  double off = 0;  // how far a computed value may be from it
  double size() const { return std::fabs(cln::double_approx(exact)); }
};
class Point {
public:
  std::map<Expr, Value> known;
  std::map<std::string, double> sizes;  // of named values

  Value of(Expr e) {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    const Value v = computed(e);
    known[e] = v;
    return v;
  }
  void define(const kernel::Theorem& t) {
    const Value v = of(t.conclusion().arg(1));
    known[t.conclusion().arg(0)] = v;
    sizes[t.conclusion().arg(0).name()] = v.size();
  }

private:
  static Value lossy(const cl_R& exact, double off, double loss) {
    Value v{exact, off};
    v.off += loss * v.size();
    return v;
  }
  static bool is_dyadic(const cln::cl_RA& q) {
    const cln::cl_I below = cln::denominator(q);
    return cln::logand(below, below - 1) == 0;
  }
  static Value plus(const Value& x, const Value& y) {
    const bool exact = x.off == 0 && y.off == 0;
    return lossy(x.exact + y.exact, x.off + y.off, exact ? 0 : of_operation);
  }
  static Value times(const Value& x, const Value& y) {
    const double off = x.size() * y.off + y.size() * x.off + x.off * y.off;
    return lossy(x.exact * y.exact, off, off == 0 ? 0 : of_operation);
  }
  Value computed(Expr e) {
    const cln::float_format_t digits = cln::float_format(90);
    switch (e.op()) {
      case Op::Num: {
        const cl_R q = cln::cl_float(e.value(), digits);
        return lossy(q, 0, is_dyadic(e.value()) ? 0 : of_operation);
      }
      case Op::Add: {
        Value s = of(e.arg(0));
        for (std::size_t k = 1; k < e.size(); ++k) s = plus(s, of(e.arg(k)));
        return s;
      }
      case Op::Mul: {
        Value p = of(e.arg(0));
        for (std::size_t k = 1; k < e.size(); ++k) p = times(p, of(e.arg(k)));
        return p;
      }
      case Op::Pow: {
        const Value base = of(e.arg(0));
        Value p = base;
        for (int k = 1; k < e.exponent(); ++k) p = times(p, base);
        return p;
      }
      default:
        return function(e);
    }
  }
  Value function(Expr e) {
    if (e.name() == "pi") return lossy(cln::pi(cln::float_format(90)), 0, of_operation);
    const Expr inner = e.arg(0);
    if (e.name() == "sqrt" && inner.op() == Op::Pow) {
      const Value x = of(inner.arg(0));
      return {cln::abs(x.exact), x.off};
    }
    const Value x = of(inner);
    const double size = x.size();
    if (e.name() == "inv") return lossy(1 / x.exact, x.off / (size * (size - x.off)), of_operation);
    if (e.name() == "sqrt") {
      return lossy(cln::sqrt(x.exact), x.off / (2 * std::sqrt(size)), of_operation);
    }
    const double sine = std::fabs(std::sin(size));
    const double cosine = std::fabs(std::cos(size));
    const double twice = x.off * x.off;
    if (e.name() == "sin") return lossy(cln::sin(x.exact), cosine * x.off, of_function);
    if (e.name() == "cos") return lossy(cln::cos(x.exact), sine * x.off + twice / 4, of_function);
    if (e.name() == "atan")
      return lossy(cln::atan(x.exact), x.off / (1 + size * size), of_function);
    if (e.name() == "ceil") {
      return {cln::cl_float(cln::ceiling1(x.exact), cln::float_format(90)), 0};
    }
    throw std::logic_error("no rule for " + e.name());
  }
};

/// "2^-73.7 |P| + 2^-147.4" with the sizes at a point.
double printed(const std::string& bound, const std::map<std::string, double>& sizes) {
  std::istringstream words(bound);
  double sum = 0;
  double product = 0;
  for (std::string word; words >> word;) {
    if (word == "+") {
      sum += product;
    } else if (word.substr(0, 2) == "2^") {
      product = std::exp2(std::stod(word.substr(2)));
    } else {
      product *= sizes.at(word.substr(1, word.size() - 2));
    }
  }
  return sum + product;
}
/// Accurate's printed bounds, by output.
std::map<std::string, std::string> bounds_in(const std::string& errors) {
  std::map<std::string, std::string> r;
  std::istringstream lines(errors.substr(0, errors.find(", Fast")));
  const std::string mark = "  OUTPUT ";
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (line.substr(0, mark.size()) != mark) continue;
    r[line.substr(mark.size(), colon - mark.size())] = line.substr(colon + 2);
  }
  return r;
}
/// Draws inputs of a case until its guards hold, and evaluates its definitions there.
Point draw(const codegen::Quantity& q, const codegen::Case& c, std::mt19937_64& random) {
  while (true) {
    Point p;
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
      p.known[i.variable] = {cln::cl_float(cln::rational(cln::cl_float(x)), cln::float_format(90)),
                             0};
    }
    for (const kernel::Theorem& t : c.definitions) p.define(t);
    bool holds = true;
    for (const codegen::Condition& g : c.guards) {
      holds = holds && p.sizes.at(g.name) > g.range.low && p.sizes.at(g.name) < g.range.high;
    }
    if (holds) return p;
  }
}
/// Outputs whose printed bound is too small at one of many points; the least bound over error.
std::map<std::string, double> too_small(const codegen::Quantity& q, const std::string& errors) {
  std::mt19937_64 random(3);
  std::map<std::string, double> r;
  const std::map<std::string, std::string> bounds = bounds_in(errors);
  REQUIRE_FALSE(bounds.empty());
  const codegen::Case& c = q.cases[0];
  for (int row = 0; row < 400; ++row) {
    Point p = draw(q, c, random);
    for (const kernel::Theorem& t : c.outputs) {
      const Expr output = t.conclusion().arg(0);
      if (output.sort() == kernel::Sort::Int) continue;
      const std::string name = output.name() == "c'" ? "c_prime" : output.name();
      const Value v = p.of(t.conclusion().arg(1));
      p.sizes["of_" + name] = v.size();
      const double ratio = printed(bounds.at(name), p.sizes) / v.off;
      if (ratio < 1 && (r.count(name) == 0 || ratio < r[name])) r[name] = ratio;
    }
  }
  return r;
}
/// A function of functions, so that what an operand is off weighs more than the last function. The
/// square that it claims is near the right one, and of no error.
codegen::Quantity chain() {
  const Expr alpha = kernel::real("alpha");
  codegen::Case c{"only", {}, {}, {}, {}, {}};
  Expr x = alpha;
  for (const char* name :
       {"chain_1", "chain_2", "chain_3", "chain_4", "chain_5", "chain_6", "chain_7"}) {
    c.definitions.push_back(kernel::define(name, {alpha}, kernel::sin(x)));
    x = c.definitions.back().conclusion().arg(0);
  }
  c.definitions.push_back(kernel::define("chain_square", {alpha}, alpha * alpha));
  const Expr square = c.definitions.back().conclusion().arg(0);
  c.facts = {{kernel::eq(kernel::power(x, 2), square), "about"}};
  c.outputs = {kernel::define("chain", {alpha}, kernel::atan(x))};
  return {"chain", "none", {{alpha, {0.1, 0.5}, {0.1, 0.5}}}, {c}};
}
std::vector<codegen::Quantity> all_quantities() {
  static const codegen::Quantity last = chain();
  std::vector<codegen::Quantity> all = test::quantities();
  all.push_back(last);
  return all;
}
}  // namespace

TEST_CASE("the independent checker finds no printed bound too small") {
  for (const codegen::Quantity& q : all_quantities()) {
    INFO(q.name);
    for (const auto& [name, ratio] : too_small(q, codegen::emit_evaluator(q).errors)) {
      FAIL_CHECK(name << " may be off by " << 1 / ratio << " times its printed bound");
    }
  }
}
TEST_CASE("the independent checker sees every bound that is eight times too small") {
  for (const codegen::Quantity& q : all_quantities()) {
    INFO(q.name);
    const std::string errors = codegen::emit_evaluator(q).errors;
    std::string smaller;
    for (std::size_t at = 0; at < errors.size(); ++at) {
      smaller += errors[at];
      if (smaller.ends_with("2^-")) {
        std::size_t used = 0;
        smaller += std::to_string(std::stod(errors.substr(at + 1), &used) + 3);
        at += used;
      }
    }
    CHECK(too_small(q, smaller).size() == bounds_in(errors).size());
  }
}
