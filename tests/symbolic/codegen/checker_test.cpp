// SPDX-License-Identifier: GPL-2.0-or-later
// What the checker finds at random points of each case, against the bounds that are printed.
#include "checker.hpp"

#include <random>

#include "catch.hpp"
#include "generate/quantities.hpp"

namespace {
using namespace checker;

/// A ball at which inelastic collapse is so far: share = 1 - (1 - e)^2/(4 e m (1 + w (1 + m))).
cl_RA near_collapse(const cl_RA& e, const cl_RA& w, const cl_RA& share) {
  const cl_RA x = (1 - e) * (1 - e) / (4 * e * (1 - share)), b = 1 + w;
  return 2 * x / (sqrt(Ball(cl_RA(b * b + 4 * w * x))).low() + b);
}
bool is_inside(const Value& v, codegen::Interval r) {
  return v.x.low() > codegen::exact(r.low) && v.x.high() < codegen::exact(r.high);
}
Point drawn(const codegen::Quantity& q, const codegen::Case& c, const NumberType& type,
            std::mt19937_64& random) {
  const auto number = [&] { return double(random() >> 11) * 0x1p-53; };
  Point p(type);
  for (const auto& [unit, value] : q.units) p.known[unit] = just(value.value());
  for (const codegen::Fact& f : c.facts)
    if (f.formula.op() == Op::Eq) p.squares[f.formula.arg(0).arg(0)] = f.formula.arg(1);
  for (const codegen::Input& i : q.inputs) {
    codegen::Interval r = i.range;
    for (const codegen::Condition& w : c.where)
      if (w.name == i.variable.name()) r = codegen::meet(r, w.range);
    const double low = std::max(r.low, 0x1p-40);
    const double x = low * std::pow(std::min(r.high, 0x1p40) / low, number());
    p.put(i.variable, codegen::exact(i.is_whole() ? std::max(r.low, std::floor(x)) : x));
  }
  if (q.name != "restitution") return p;
  const double e = random() % 2 == 0 ? std::exp2(-40 * number()) : 1 - std::exp2(-30 * number());
  const cl_RA part = codegen::exact(std::exp2((type.is_pair() ? -30 : -80) * std::sqrt(number())));
  const cl_RA share = random() % 2 == 0 ? part : 1 - part;
  const double w = random() % 8 == 0 ? 0 : std::exp2(40 * number() - 20);  // 0: a wall
  const cl_RA ball = near_collapse(codegen::exact(e), codegen::exact(w), share);
  p.put(kernel::real("e"), codegen::exact(e));
  p.put(kernel::real("w_B"), codegen::exact(w));
  p.put(kernel::real("M_C"), type.is_pair() ? codegen::exact(codegen::nearest(ball)) : ball);
  return p;
}
/// The least printed bound over error found, by step, output or sign.
std::map<std::string, double> margins(const codegen::Quantity& q, const codegen::Case& c,
                                      const NumberType& type, const Printed& bounds) {
  std::map<std::string, double> r;
  std::mt19937_64 random(3);
  const auto seen = [&](const std::string& name, const Value& found, const Point& p) {
    const auto bound = bounds.find(name);
    if (found.off == 0 || bound == bounds.end()) return;
    const double margin = bound->second.evaluated(p.named, found.size) / found.off;
    double& least = r.insert({name, margin}).first->second;
    least = std::min(least, margin);
  };
  /// With definitions, as far as guards hold.
  const auto defines = [&](Point& p, const kernel::Theorem& t) {
    const Value found = p.define(t, bounds);
    const std::string name = t.conclusion().arg(0).name();
    for (const codegen::Condition& g : c.guards)
      if (g.name == name && !is_inside(found, g.of(!type.is_pair()))) return false;
    for (const std::string& d : c.divisors)
      if (d == name && found.x.low() <= codegen::exact(clear * p.named.at(d).off)) return false;
    seen("STEP " + name, found, p);
    return true;
  };
  int left = c.divisors.empty() ? 150 : 1000;
  while (left > 0) {
    Point p = drawn(q, c, type, random);
    if (!std::ranges::all_of(c.definitions, [&](const auto& t) { return defines(p, t); })) continue;
    --left;
    for (const kernel::Theorem& t : c.outputs) {
      const Expr output = t.conclusion().arg(0);
      Value v = p.known[output] = p.of(t.conclusion().arg(1));
      if (output.sort() == kernel::Sort::Int) continue;
      const bool is_rounded = type.is_pair() ? v.off > 0 || v.loose > u : !v.exact;
      if (is_rounded) v.off += type.rounding_test(v.loose) * v.size;
      seen("OUTPUT " + codegen::identifier(output.name()), v, p);
    }
    for (const std::string& name : c.divisors) {
      Value v = p.named.at(name);
      v.off *= clear;
      seen("SIGN " + name, v, p);
    }
    for (auto [name, v] : p.signs) {
      v.off += (type.is_pair() ? v.loose : type.u) * v.size;
      seen("SIGN " + name, v, p);
    }
  }
  for (const auto& [name, bound] : bounds)
    if (!name.starts_with("STEP ") && !bound.text.starts_with("0")) CHECK(r.count(name) == 1);
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
/// The constants that a header's case has for the k-th type are those printed: how many.
std::size_t check_constants(const codegen::Emitted& emitted, const std::string& name, std::size_t k,
                            double unit, const Printed& bounds, bool is_tested) {
  const std::regex lists("struct " + name + " \\{[\\s\\S]*?bounds[^{]*\\{([^{;]*\\{){" +
                         std::to_string(k + 1) + "}([^};]*)");
  std::multiset<std::string> in_code, in_text;
  std::smatch found;
  std::regex_search(emitted.header, found, lists);
  std::istringstream numbers(found[2]);
  for (std::string number; std::getline(numbers, number, ',');)
    if (std::stod(number) > 0)  // other types have an error there
      in_code.insert(codegen::as_power_of_2(std::stod(number) * unit));
  for (const auto& [of, bound] : bounds) {
    if (!of.starts_with("SIGN ") && !(is_tested && of.starts_with("OUTPUT "))) continue;
    std::istringstream words(bound.text);
    for (std::string word; words >> word;)
      if (word.starts_with("2^")) in_text.insert(word);
  }
  CHECK(in_code == in_text);
  return in_text.size();
}
}  // namespace

TEST_CASE("printed bounds are the header's; none is too small, and each one halved is seen") {
  Ball::set_bits(520);
  std::vector<codegen::Quantity> all = generate::evaluators();
  all.push_back(sum_and_square());
  std::vector<NumberType> types;
  for (const codegen::Tier& tier : codegen::tiers()) types.push_back({u, &tier});
  types.push_back({0x1p-180, nullptr});  // what its bounds are printed for
  std::size_t constants = 0;
  for (const codegen::Quantity& q : all) {
    const codegen::Emitted emitted = codegen::emit_evaluator(q);
    for (const codegen::Case& c : q.cases) {
      for (std::size_t k = 0; k < types.size(); ++k) {
        const NumberType& type = types[k];
        const std::string name = codegen::capital(q.name) + codegen::capital(c.name);
        const std::string heading = name + ", " + type.name();
        const Printed bounds = bounds_in(emitted.errors, heading);
        REQUIRE_FALSE(bounds.empty());
        const double unit = type.is_pair() ? 1 : type.u;
        INFO(heading);
        constants += check_constants(emitted, name, k, unit, bounds, q.is_tested);
        for (const auto& [bound, margin] : margins(q, c, type, bounds)) {
          INFO(bound << ": printed over found: " << margin);
          CHECK(margin >= 1 - 0x1p-40);  // its own roundings
          // Terms that are largest at other points are taken into these: a longer sum.
          CHECK(margin < (q.name == "restitution" && bound.starts_with("OUTPUT") ? 8 : 2));
        }
      }
    }
  }
  CHECK(constants > 100);
}
