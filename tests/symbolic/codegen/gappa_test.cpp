// Gappa proves the table's entries from each operation's sequence of roundings, what is lost and
// how large a low part is left, and refuses half of each. High parts are scaled to 1, low parts are
// x and y of them; d1, d2, ... are the roundings of the operations in their order, at most u. That
// two_sum and two_product are exact, and that 1/sqrt(1 - e) - 1 - e/2 is at most 3/8 e^2 and a
// little, is said, not proved; likewise how large a low part a sum of any signs leaves, and what
// then counts. A polynomial is proved step by step; functions are sequences of these operations.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <regex>
#include <sstream>

#include "catch.hpp"
#include "codegen/exact.hpp"
#include "codegen/operations.hpp"

namespace {
using codegen::NumberType;
constexpr double u = 0x1p-53;

struct Operation {
  std::string name;  // the entry's; behind a comma, which part of it
  codegen::Loss entry;
  /// Steps; among them `off`, the error relative to the result, `low`, the low part relative to the
  /// high one, and e, which Gappa needs in another form.
  const char* steps;
  const char* expanded;  // e, without what cancels
};
std::vector<Operation> operations(double l) {
  const NumberType t{u, &codegen::tiers()[1]};
  const NumberType::Cancelling any = t.cancelling_sum(l, l);
  return {
      // z is from 1 to 2, that is of any binade, and `nearest` is Gappa's own rounding.
      {"exact_sum", t.exact_sum(),
       "z = 1.5 + h; s = nearest(z); e = s + (z - s) - z; off = e / z; low = (z - s) / s;", "0"},
      {"constant", t.constant(0x1p-107 * codegen::and_more),  // at most, for any number
       "low = nearest(c); e = low - c; off = e / (1 + c);", "nearest(c) - c"},
      {"sum", t.sum(l, l),  // x: of both low parts, against the sum of the high parts
       "v = x * (1 + d1); w = (c + v) * (1 + d2); e = (1 - c + w) - (1 + x); off = e / (1 + x);"
       "low = w / (1 - c);",
       "x * d1 + d2 * (c + x * (1 + d1))"},
      // Each of the three parts of the error by itself: of a low part, and of the high parts' sum.
      {"cancelling_sum, of a low part",
       {any.of_x, 0},
       "e = d1 + d2 + d3; off = x * ((1 + d1) * (1 + d2) * (1 + d3) - 1); low = x * 0;",
       "d1 + d2 + d3"},
      {"cancelling_sum, of the result",
       {any.of_result, 0},
       "e = d2 * c; off = 1 * e; low = x * 0;",
       "d2 * c"},
      {"product", t.product(l, l),
       "v = (x + c) * (1 + d1); w = (y + v) * (1 + d2); e = (1 - c + w) - (1 + x) * (1 + y);"
       "off = e / ((1 + x) * (1 + y)); low = w / (1 - c);",
       "(x + c) * d1 + d2 * (y + (x + c) * (1 + d1)) - x * y"},
      {"product, by an exact number", t.product(l),
       "w = (x + c) * (1 + d1); e = (1 - c + w) - (1 + x); off = e / (1 + x); low = w / (1 - c);",
       "(x + c) * d1"},
      {"quotient", t.quotient(l, l),
       "g = (1 + d1) * (1 + d2) - 1; D = (1 + d6) * (1 + d7) * (1 + d1) - 1;"
       "m = (x - g * (1 + d3)) * (1 + d4) - (1 + g) * y * (1 + d5);"
       "e = (1 + g + m * (1 + D)) * (1 + y) - (1 + x); off = e / (1 + x);"
       "low = m * (1 + D) / (1 + g);",
       "(x - g) * d4 - g * d3 * (1 + d4) - y * d5 - g * y * d5 + m * D + m * (1 + D) * y"},
      {"reciprocal_root", t.reciprocal_root(l),
       "g = (1 + d6) * (1 + d7) * (1 + d8) - 1; A = -2 * g - g * g - c * (1 + g);"
       "B = (1 + g) * (y * (1 + g) - c); k = -2 * g - g * g - y * (1 + g) * (1 + g);"
       "D = (1 + d4) * (1 + d5) - 1;"
       "e = ((A * (1 + d1) - B * (1 + d2) * (1 + d3)) * (1 + D) - k) / 2; off = e + q * k * k;"
       "low = e + k / 2;",
       "((A * d1 - B * (d2 + d3 + d2 * d3)) * (1 + D) + k * D) / 2"},
      // y is the low part, beside which what is tested is small.
      {"rounding_test",
       {t.rounding_test(l), 0},
       "g = y + x * 1b-21; e = g * (1 + d1) - g; off = 1 * e; low = x * 0;",
       "g * d1"}};
}
/// Entries that are made of others, which are proved here.
const std::map<std::string, std::string> composed{
    {"arc_tangent", "a sum of low parts, the polynomial, a product"},
    {"small_sine_cosine", "a product, the polynomials, a product"},
    {"sine_cosine", "as the small ones; a difference of pi/2, whose digits Gappa does not know"},
    {"power", "as many products as it may take, which no script of one length states"}};
using Bounds = std::vector<std::pair<std::string, double>>;
/// The least bound that Gappa proves: "|e| in [0, 3b-1 {1.5, 2^(0.58)}]"; hints are identities.
double largest(const std::string& what, const std::string& steps, const std::string& expanded,
               const Bounds& bounds) {
  std::ostringstream script;
  script << MAGICMASS_GAPPA " -Eprecision=200 2>&1 <<end\n@nearest = float<ieee_64, ne>;\n"
         << steps << "\n{ ";
  for (int k = 1; k <= 8; ++k) script << "|d" << k << "| <= " << codegen::hex(u) << " /\\ ";
  for (const auto& [name, bound] : bounds)
    script << "|" << name << "| <= " << codegen::hex(bound) << " /\\ ";
  script << "0 <= 1 -> |" << what << "| in ? }\ne -> " << expanded << ";\nend";
  std::FILE* gappa = popen(script.str().c_str(), "r");
  REQUIRE(gappa != nullptr);
  std::string said;
  for (int c = std::fgetc(gappa); c != EOF; c = std::fgetc(gappa)) said += char(c);
  pclose(gappa);
  INFO(steps << said);
  REQUIRE(said.find("Warning") == said.npos);
  if (said.ends_with("[0, 0]\n")) return 0;
  const std::size_t number = said.find(", ") + 2, power = said.find('b', number) + 1;
  REQUIRE(power > number);
  const double digits = std::stod(said.substr(number));  // exact where they are few
  const double bound = std::ldexp(digits, std::stoi(said.substr(power)));
  return digits < 0x1p53 ? bound : std::nextafter(bound, 1e300);
}

/// The exact value, and how far the computed one may be from it.
struct Plain {
  double size, off;
};
/// As the runtime's plain_polynomial: p is z^half, off by G; a, b are the errors of both halves.
Plain plain_polynomial(const double* c, int n, double z) {
  if (n == 1) return {std::fabs(c[0]), 0};
  static const std::map<int, std::string> powers{
      {1, "1"},
      {2, "(1 + d2)"},
      {4, "(1 + d2) * (1 + d2) * (1 + d3)"},
      {8, "(1 + d2) * (1 + d2) * (1 + d2) * (1 + d2) * (1 + d3) * (1 + d3) * (1 + d4)"}};
  const int half = n == 2 ? 1 : n > 8 ? 8 : n > 4 ? 4 : 2;
  const Plain above = plain_polynomial(c + half, n - half, z);
  const Plain below = plain_polynomial(c, half, z);
  const double power = std::pow(z, half) * (1 + 0x1p-40);
  const double off = largest(
      "e",
      "G = " + powers.at(half) +
          " - 1; e = ((A + a) * p * (1 + G) + B + b) * (1 + d1) - (A * p + B);",
      "a * p + (A + a) * p * G + b + d1 * ((A + a) * p * (1 + G) + B + b)",
      {{"A", above.size}, {"a", above.off}, {"p", power}, {"B", below.size}, {"b", below.off}});
  return {above.size * power + below.size, off};
}
/// Of the runtime's polynomial: s + l is off by g from the exact value. That what is called exact
/// there is exact, and what the tail at z.high is off from that at z, w, is said.
struct Pair {
  double s, l, g;
};
Pair polynomial(const codegen::Polynomial& p, double size, double low) {
  const int n = int(p.high.size()), m = int(p.low.size());
  const auto c = [&](int k) { return std::fabs(p.high[std::size_t(k)]); };
  double of_low = 0;
  for (int k = m + 1; k < n; ++k) of_low += (k - m + 1) * c(k) * std::pow(size, k - m);
  const Plain tail = plain_polynomial(p.high.data() + m, n - m, size);
  const auto step = [&](const std::string& steps, const std::string& expanded, Bounds where) {
    where.insert(where.end(), {{"x", size}, {"y", low}});
    return Pair{largest("S", steps, expanded, where), largest("L", steps, expanded, where),
                largest("e", steps, expanded, where)};
  };
  Pair sum = step(
      "t = x * (A + a) * (1 + d4); h = c + t; r = -h * d1; S = h + h * d1; v = (r + f) * (1 + d2);"
      "L = (v + y * b) * (1 + d3); e = S + L - (c + f + x * A + y * b + w);",
      "x * a + d4 * x * (A + a) - w + d2 * (r + f) + d3 * (v + y * b)",
      {{"A", tail.size},
       {"a", tail.off},
       {"c", c(m - 1)},
       {"f", u * c(m - 1)},
       {"b", c(m)},
       {"w", low * of_low}});
  for (int k = m - 2; k >= 0; --k)
    sum = step(
        "h = c + x * s; r = -h * d1; S = h + h * d1; v = r * (1 + d2); i = (y * s + f) * (1 + d3);"
        "t = (v + i) * (1 + d4); L = (x * l + t) * (1 + d5);"
        "e = S + L - (c + f + (x + y) * (s + l - g));",
        "r * d2 + d3 * (y * s + f) + d4 * (v + i) + d5 * (x * l + t) - y * l + (x + y) * g",
        {{"c", c(k)}, {"f", u * c(k)}, {"s", sum.s}, {"l", sum.l}, {"g", sum.g}});
  return sum;
}
}  // namespace

TEST_CASE("Gappa proves what each operation loses and leaves, and not half of it") {
  for (const double l : {u, 16 * u}) {
    for (const Operation& o : operations(l)) {
      INFO(o.name << ", low parts " << l);
      const Bounds parts{{"c", u}, {"x", l}, {"y", l}, {"q", 0x1.80001p-2}, {"h", 0.5}};
      for (const auto& [what, bound] : {std::pair("off", o.entry.loss), {"low", o.entry.loose}}) {
        INFO(what);
        const double proved = largest(what, o.steps, o.expanded, parts);
        CHECK(proved <= bound);
        if (bound > 0) CHECK(proved > bound / 2);
      }
    }
  }
}
TEST_CASE("Gappa proves what polynomials lose and leave, step by step") {
  for (const codegen::Tier& tier : codegen::tiers()) {
    const NumberType t{u, &tier};
    for (const codegen::Polynomial& p : tier.polynomials) {
      INFO(tier.name << ", " << p.name);
      const double size = p.centre > 0 ? p.centre : p.top;
      const Pair proved = polynomial(p, size, 2 * u * size);
      const NumberType::OfPolynomial entry = t.polynomial(p, size, 2 * u * size);
      const double loss = proved.g / p.least + p.error;
      CHECK(loss <= entry.loss);
      CHECK(loss > 0.99 * entry.loss);
      CHECK(proved.l / p.least <= entry.loose);
      CHECK(proved.l / p.least > 0.99 * entry.loose);
    }
  }
}
TEST_CASE("each entry of the table is proved here, or it is said what it is made of") {
  std::set<std::string> known{"polynomial"}, entries;
  for (const Operation& o : operations(u)) known.insert(o.name.substr(0, o.name.find(',')));
  for (const auto& [name, of] : composed) known.insert(name);
  std::ifstream table(MAGICMASS_TABLE);
  const std::regex entry("  [A-Z]?[A-Za-z]+ (\\w+)\\(.*\\) const;.*");
  std::smatch found;
  for (std::string line; std::getline(table, line);)
    if (std::regex_match(line, found, entry)) entries.insert(found[1]);
  CHECK(entries == known);
}
