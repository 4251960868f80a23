// A Taylor series, economised in Chebyshev's basis, cut, rounded; and its error.
#include "codegen/emit.hpp"
#include "codegen/operations.hpp"

namespace codegen {
namespace {
using cln::cl_RA;
using Series = std::vector<cl_RA>;  // coefficients of powers
/// How many terms of the series are taken: the first one left out is below 2^-120.
int terms(const std::string& name) { return name == "arc_tangent" ? 76 : 32; }

/// c(x) in powers of y, where x = a + b y.
Series substituted(Series c, const cl_RA& a, const cl_RA& b) {
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = c.size() - 1; j-- > i;) c[j] = c[j] + a * c[j + 1];
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = c[k] * cln::expt(b, cln::cl_I(k));
  return c;
}
/// T_k in powers.
const Series& chebyshev(std::size_t k) {
  static std::vector<Series> made{{1}, {0, 1}};
  while (made.size() <= k) {
    const Series& now = made[made.size() - 1];
    const Series& before = made[made.size() - 2];
    Series next(made.size() + 1, 0);
    for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] = 2 * now[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] = next[i] - before[i];
    made.push_back(next);
  }
  return made[k];
}
/// Takes off the multiples of T_k that hold the powers from `first` on; their sizes' sum. The
/// highest power goes first: it is in one T_k alone of those that are left.
cl_RA taken_off(Series& c, std::size_t first) {
  cl_RA sizes = 0;
  for (std::size_t k = c.size(); k-- > first;) {
    const Series& T = chebyshev(k);
    const cl_RA by = c[k] / T.back();
    for (std::size_t i = 0; i < k; ++i) c[i] = c[i] - by * T[i];
    sizes = sizes + cln::abs(by);
  }
  c.resize(first);
  return sizes;
}

/// The coefficient of z^k; terms alternate and fall in size where they are used.
cl_RA term(const std::string& name, int k) {
  const cl_RA sign = k % 2 == 0 ? 1 : -1;
  if (name == "arc_tangent") return sign / (2 * k + 1);
  return sign / cln::factorial(uintL(name.ends_with("cosine") ? 2 * k : 2 * k + 1));
}
Series series(const std::string& name) {
  Series s;
  for (int k = 0; k < terms(name); ++k) s.push_back(term(name, k));
  return s;
}

struct Shape {
  int degree, pairs;
};
struct Range {
  const char* name;
  double top, centre, least;
};
Polynomial make(const Range& range, Shape shape) {
  const cl_RA half = exact(range.top) / 2;
  Series all = series(range.name);
  // About 0, f(0) = 1 exactly, and what is economised is (f - 1)/z.
  if (range.centre == 0) all.erase(all.begin());
  Series p = substituted(all, half, half);
  taken_off(p, std::size_t(shape.degree) + (range.centre == 0 ? 0 : 1));
  p = substituted(p, exact(range.centre) / half - 1, 1 / half);
  if (range.centre == 0) p.insert(p.begin(), 1);
  Polynomial r{range.name, {}, {}, range.centre, range.top, range.least, 0};
  for (int k = 0; k <= shape.degree; ++k) {
    const cl_RA& c = p[std::size_t(k)];
    r.high.push_back(nearest(c));
    if (k < shape.pairs) r.low.push_back(nearest(c - exact(r.high.back())));
  }
  r.error = proved_error(r);
  return r;
}
std::vector<Tier> make_tiers() {
  // (pi/4)^2 and (pi/6)^2 and a little more: room for an angle that is rounded.
  constexpr double quarter = 0.6168510, sixth = 0.2741560, third = 0x1.5555555555556p-2;
  const Range ranges[] = {{"arc_tangent", third, third / 2, 0.9},
                          {"sine", quarter, 0, 0.9},
                          {"cosine", quarter, 0, 0.707},
                          {"small_sine", sixth, 0, 0.954},
                          {"small_cosine", sixth, 0, 0.866}};
  const struct {
    const char* name;
    bool is_tested;
    Shape shapes[5];
  } all[] = {{"Fast", false, {{14, 1}, {7, 1}, {8, 2}, {6, 1}, {7, 2}}},
             {"Accurate", true, {{20, 8}, {10, 5}, {10, 5}, {9, 4}, {9, 5}}},
             {"Slow", true, {{27, 18}, {13, 9}, {14, 10}, {12, 8}, {12, 8}}}};
  std::vector<Tier> made;
  for (const auto& tier : all) {
    made.push_back({tier.name, tier.is_tested, {}});
    for (int k = 0; k < 5; ++k) made.back().polynomials.push_back(make(ranges[k], tier.shapes[k]));
  }
  return made;
}
}  // namespace

double proved_error(const Polynomial& p) {
  const cl_RA top = exact(p.top);
  const int next = terms(p.name);
  // So many times what is summed is whole: that needs no gcd.
  const cl_RA times = cln::ash(cln::factorial(uintL(2 * next)), 160 * next);
  Series off;
  for (std::size_t k = 0; k < p.high.size(); ++k)
    off.push_back(times * (exact(p.high[k]) + (k < p.low.size() ? exact(p.low[k]) : cl_RA(0))));
  off = substituted(off, -exact(p.centre), 1);
  const Series f = series(p.name);
  off.resize(f.size(), 0);
  for (std::size_t k = 0; k < f.size(); ++k) off[k] = off[k] - times * f[k];
  const cl_RA remainder = cln::abs(term(p.name, next)) * cln::expt(top, next);
  off = substituted(off, top / 2, top / 2);
  return upper((taken_off(off, 0) / times + remainder) / exact(p.least));
}

const Polynomial& Tier::operator[](const std::string& polynomial) const {
  for (const Polynomial& p : polynomials)
    if (p.name == polynomial) return p;
  throw Refused(name + " has no polynomial " + polynomial);
}
const std::vector<Tier>& tiers() {
  static const std::vector<Tier> made = make_tiers();
  return made;
}

std::string emit_polynomials() {
  const auto list = [](const std::vector<double>& numbers) {
    Words words;
    for (double x : numbers) words.push_back(hex(x));
    return "{" + joined(words, ", ") + "}";
  };
  auto begin_tier = [number = 0](const std::string& name, bool is_tested) mutable {
    return "struct " + name + " {\n  static constexpr int number = " + std::to_string(number++) +
           ";\n  static constexpr bool is_tested = " + (is_tested ? "true" : "false") + ";\n";
  };
  std::string s =
      "// Generated by `magicmass generate` from series; do not edit. SPDX-License-Identifier: "
      "MIT\n"
      "// What all evaluators take. Each polynomial's error is proved in exact rationals, relative "
      "to its function.\n#pragma once\n\n"
      "#include \"magicmass/arithmetic/functions.hpp\"\n"
      "#include \"magicmass/arithmetic/rounding_test.hpp\"\n\n"
      "namespace magicmass::generated {\n"
      "using arithmetic::load, arithmetic::rounded_by, arithmetic::Simd, arithmetic::SimdMask, "
      "arithmetic::size_of, arithmetic::store, arithmetic::to_real, arithmetic::to_whole;\n"
      "/// Only for rows whose inputs are in a case and whose doubt is 0; others are left to the "
      "caller. visit<is_wide>(in, f) is f.operator()<Case>() of the inputs' case, or 1: a doubt. "
      "Wide: without over- and underflow, as MPFR's numbers are. Main is the case of arrays: set() "
      "takes a register's rows, or one, load_inputs() says which are in the case. Bounds: a row a "
      "tier, by its number.\n"
      "template <class I, class O, class C = void> struct Evaluator {\n"
      "  using Inputs = I;\n  using Outputs = O;\n  using Columns = C;\n};\n"
      "/// Of z - centre: its first coefficients in two parts, the others in one.\n"
      "template <int the_size, int the_pairs>\nstruct Polynomial {\n"
      "  static constexpr int size = the_size, pairs = the_pairs;\n"
      "  double centre, high[the_size], low[the_pairs];\n};\n";
  for (const Tier& tier : tiers()) {
    s += begin_tier(tier.name, tier.is_tested);
    std::string lines;
    for (const Polynomial& p : tier.polynomials) {
      s += (lines.empty() ? "  // off by at most " : ", ") + as_power_of_2(p.error);
      lines += "  static constexpr Polynomial<" + std::to_string(p.high.size()) + ", " +
               std::to_string(p.low.size()) + "> " + p.name + "{" + hex(p.centre) + ", " +
               list(p.high) + ", " + list(p.low) + "};\n";
    }
    s += "\n" + lines + "};\n";
  }
  return broken(s + "/// The tier of the last number type, of as many bits as are asked for.\n" +
                begin_tier("Ziv", true) + "};\n}  // namespace magicmass::generated\n");
}
}  // namespace codegen
