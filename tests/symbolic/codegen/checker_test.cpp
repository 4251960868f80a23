// What the checker finds at random points of each case, against the bounds that are printed,
// outputs and signs: one below what is found is too small. A named value is checked and then taken
// to be as far off as is printed: the next step's bound has to hold for that, and parts of one sum
// that are largest at different points do not hide that it is halved.
#include "checker.hpp"

#include <random>
#include <regex>
#include <sstream>

#include "catch.hpp"
#include "generate/quantities.hpp"

namespace {
using namespace checker;

constexpr double clear = 0x1p23;      // a divisor is tested to be so many times its error
constexpr double printed_up = 0.933;  // exponents are printed up to the next 0.1

/// An error bound as it is printed for a reader: "2^-73.7 |P| + 2^-147.4".
struct Bound {
  std::string text;
  double share = 1;  // what the unnamed value whose size it may have is of the value: a power of 2

  /// With the sizes of values at a point; an unnamed one is a share of the value's own.
  double evaluated(const auto& values, double own) const {
    std::istringstream words(text + " +");
    double sum = 0, product = 1;
    for (std::string word; words >> word;)
      if (word == "+") {
        sum += product;
        product = 1;
      } else if (word[0] != '|') {
        product *= word == "0" ? 0 : std::exp2(std::stod(word.substr(2)));
      } else {
        const auto found = values.find(word.substr(1, word.size() - 2));
        product *= found == values.end() ? own * share : found->second.size;
      }
    return sum;
  }
};
using Printed = std::map<std::string, Bound>;
/// The bounds below a heading: "STEP plus", "OUTPUT a", "SIGN distance".
Printed bounds_in(const std::string& errors, const std::string& heading) {
  Printed r;
  const std::size_t from = errors.find(heading + "\n");
  const std::string lines = errors.substr(from, errors.find("\n\n", from) - from);
  static const std::regex line("\n  (OUTPUT |SIGN |)(\\S+): (?:off by )?([^;\n]*)");
  static const std::regex single("2\\^(\\S+) \\|(t[0-9]+)\\|");
  std::smatch term;
  std::map<std::string, double> exponents, shares;  // of unnamed values
  for (std::sregex_iterator found(lines.begin(), lines.end(), line), end; found != end; ++found) {
    const bool is_step = (*found)[1].length() == 0;
    const std::string text = (*found)[3];
    Bound& bound = r[(is_step ? "STEP " : (*found)[1].str()) + (*found)[2].str()] = {text};
    if (text.size() > 99 || !std::regex_match(text, term, single)) continue;
    const std::string unnamed = term[2];
    const double exponent = std::stod(term[1]);
    if (is_step)
      shares[unnamed] = std::exp2(exponents.insert({unnamed, exponent}).first->second - exponent);
    bound.share = shares.insert({unnamed, 1}).first->second;
  }
  return r;
}

/// A ball at which inelastic collapse is so far: share = 1 - (1 - e)^2/(4 e m (1 + w (1 + m))).
cl_RA near_collapse(const cl_RA& e, const cl_RA& w, const cl_RA& share) {
  const cl_RA x = (1 - e) * (1 - e) / (4 * e * (1 - share)), b = 1 + w;
  return 2 * x / (sqrt(Ball(cl_RA(b * b + 4 * w * x))).low() + b);
}
bool is_inside(const Value& v, codegen::Interval r) {
  return v.x.low() > codegen::exact(r.low) && v.x.high() < codegen::exact(r.high);
}
template <class Tier>
Point<Tier> drawn(const codegen::Quantity& q, const codegen::Case& c, std::mt19937_64& random) {
  const auto number = [&] { return double(random() >> 11) * 0x1p-53; };
  Point<Tier> p;
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
  if (q.inputs.back().name() != "e") return p;
  const double e = random() % 2 == 0 ? std::exp2(-40 * number()) : 1 - std::exp2(-30 * number());
  const cl_RA part = codegen::exact(std::exp2((p.is_pair ? -30 : -80) * std::sqrt(number())));
  const cl_RA share = random() % 2 == 0 ? part : 1 - part;
  const double w = random() % 8 == 0 ? 0 : std::exp2(40 * number() - 20);  // 0: a wall
  const cl_RA ball = near_collapse(codegen::exact(e), codegen::exact(w),
                                   q.name == "collapse" ? share / (share - 1) : share);
  p.put(kernel::real("e"), codegen::exact(e));
  p.put(kernel::real("w_B"), codegen::exact(w));
  p.put(kernel::real("M_C"), p.is_pair ? codegen::exact(codegen::nearest(ball)) : ball);
  return p;
}
/// The least printed bound over error found, by step, output or sign.
template <class Tier>
std::map<std::string, double> margins(const codegen::Quantity& q, const codegen::Case& c,
                                      const Printed& bounds) {
  std::map<std::string, double> r;
  std::mt19937_64 random(3);
  const auto seen = [&](const std::string& name, const Value& found, const Point<Tier>& p) {
    const auto bound = bounds.find(name);
    if (found.low.off == 0 || bound == bounds.end()) return;
    const double margin = bound->second.evaluated(p.named, found.size) / found.low.off;
    double& least = r.insert({name, margin}).first->second;
    least = std::min(least, margin);
  };
  /// With definitions, as far as guards hold.
  const auto defines = [&](Point<Tier>& p, const kernel::Theorem& t) {
    const Expr head = t.conclusion().arg(0);
    const std::string name = head.name();
    const Value found = p.of(t.conclusion().arg(1));
    Value& v = p.named[name] = found;
    if (const auto step = bounds.find("STEP " + name); step != bounds.end())
      v.low.off = std::max(v.low.off, step->second.evaluated(p.named, v.size) * printed_up);
    p.known[head] = v;
    for (const codegen::Condition& g : c.guards)
      if (g.name == name && !is_inside(found, g.of(!p.is_pair))) return false;
    for (const std::string& d : c.divisors)
      if (d == name && found.x.low() <= codegen::exact(clear * v.low.off)) return false;
    seen("STEP " + name, found, p);
    return true;
  };
  int left = c.divisors.empty() ? 150 : 1000;
  while (left > 0) {
    Point<Tier> p = drawn<Tier>(q, c, random);
    if (!std::ranges::all_of(c.definitions, [&](const auto& t) { return defines(p, t); })) continue;
    --left;
    for (const kernel::Theorem& t : c.outputs) {
      const Expr output = t.conclusion().arg(0);
      Value v = p.known[output] = p.of(t.conclusion().arg(1));
      if (output.sort() == kernel::Sort::Int) continue;
      const bool is_rounded = v.low.off > 0 || v.low.size > 0x1p-53 * v.size;
      if (is_rounded) v.low.off += p.u * v.low.size + p.unit * v.size;
      seen("OUTPUT " + codegen::identifier(output.name()), v, p);
    }
    for (const std::string& name : c.divisors) {
      Value v = p.named.at(name);
      v.low.off *= clear;
      seen("SIGN " + name, v, p);
    }
    for (auto [name, v] : p.signs) {
      v.low.off += v.low.size + p.unit * v.size;
      seen("SIGN " + name, v, p);
    }
  }
  for (const auto& [name, bound] : bounds)
    if (!name.starts_with("STEP ") && !bound.text.starts_with("0")) CHECK(r.count(name) == 1);
  return r;
}
/// What the paper's quantities lack: a sum of two values of one sign that are both off by a share,
/// one that cancels where the first has the loose low part, functions of exact numbers, and an
/// output that loses no more than its rounding test.
codegen::Quantity sum_and_square(const kernel::Theorems& recursions) {
  const Expr alpha = kernel::real("alpha");
  const kernel::Theorem x = kernel::define("checked_x", {alpha}, (2 + alpha) * (3 + alpha));
  const kernel::Theorem y = kernel::define("checked_y", {alpha}, cos(2 * alpha));
  const kernel::Theorem z = kernel::define("checked_z", {alpha}, cos(3 * alpha));  // near pi/2
  const Expr of_x = x.conclusion().arg(0);
  codegen::Case c{"only", {}, {x, y, z}};
  c.outputs = {kernel::define("checked_sum", {alpha}, of_x + of_x * of_x),
               kernel::define("checked_rest", {alpha}, of_x * of_x - alpha),
               kernel::define("checked_cosine", {alpha}, cos(alpha)),
               kernel::define("checked_sine", {alpha}, sin(4 * alpha)),
               kernel::define("checked_turned", {alpha}, y.conclusion().arg(0) - alpha / 64),
               kernel::define("checked_near_0", {alpha}, z.conclusion().arg(0) - alpha),
               kernel::define("checked_power", {alpha}, kernel::fun("pow", {alpha, 5})),
               kernel::define("checked_square", {alpha}, alpha * alpha)};
  return {.name = "sum",
          .labels = "none",
          .inputs = {{alpha, {0.517, 0.52}, {0.517, 0.52}}},
          .cases = {c},
          .recursions = recursions};
}
/// The constants that a header's case has for the k-th type are those printed: how many.
std::size_t check_constants(const codegen::Emitted& emitted, const std::string& name, std::size_t k,
                            double unit, const Printed& bounds, bool is_tested) {
  const std::string header = emitted.header + "bounds[;";  // also where there are none
  const std::size_t at = header.find("bounds[", header.find("struct " + name + " {"));
  const std::string declared = header.substr(at, header.find(';', at) - at);
  const std::regex lists("[^{]*\\{([^{]*\\{){" + std::to_string(k + 1) + "}([^}]*)");
  std::multiset<std::string> in_code, in_text;
  std::smatch found;
  std::regex_search(declared, found, lists);
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
template <class Tier>
std::size_t check(const codegen::Quantity& q, const codegen::Case& c,
                  const codegen::Emitted& emitted, const std::string& tier) {
  const std::string name = codegen::capital(q.name) + codegen::capital(c.name);
  INFO(name << ", " << tier);
  const Printed bounds = bounds_in(emitted.errors, name + ", " + tier);
  REQUIRE_FALSE(bounds.empty());
  for (const auto& [bound, margin] : margins<Tier>(q, c, bounds)) {
    INFO(bound << ": printed over found: " << margin);
    std::printf("%s, %s, %s: printed over found %.3f\n", name.c_str(), tier.c_str(), bound.c_str(),
                margin);
    CHECK(margin >= 1 - 0x1p-40);  // its own roundings
    // Terms that are largest at other points are taken into these: a longer sum.
    CHECK(margin < (q.inputs.back().name() == "e" && bound.starts_with("OUTPUT") ? 8 : 2));
  }
  const double unit = Point<Tier>::is_pair ? 1 : Point<Tier>::unit;
  return check_constants(emitted, name, Tier::number, unit, bounds, q.is_tested);
}
}  // namespace

TEST_CASE("printed bounds are the header's; none is too small, and each one halved is seen") {
  Ball::bits = 520;
  std::vector<codegen::Quantity> all = generate::evaluators();
  all.push_back(
      sum_and_square(std::ranges::find(all, "restitution", &codegen::Quantity::name)->recursions));
  std::size_t constants = 0;
  for (const codegen::Quantity& q : all) {
    const codegen::Emitted emitted = codegen::emit_evaluator(q);
    for (const codegen::Case& c : q.cases) {
      constants += check<generated::Fast>(q, c, emitted, "Fast");
      constants += check<generated::Accurate>(q, c, emitted, "Accurate");
      constants += check<generated::Slow>(q, c, emitted, "Slow");
      constants += check<generated::Ziv>(q, c, emitted, "Ziv");
    }
  }
  CHECK(constants > 100);
}
