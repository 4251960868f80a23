// Gappa proves the table's entries from each operation's sequence of roundings, what is lost and
// how large a low part is left, and refuses half of each. High parts are scaled to 1, low parts are
// x and y of them; d1, d2, ... are the roundings of the operations in their order, at most u. Said,
// not proved: two_sum and two_product are exact; 1/sqrt(1 - e) - 1 - e/2 is at most 3/8 e^2 and a
// little; how large a low part a sum of any signs leaves; a polynomial's slope; the digits of pi.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <regex>
#include <sstream>

#include "catch.hpp"
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
/// What relative errors come to that follow each other.
double together(double a, double b, double c = 0) {
  return largest("e", "e = (1 + a) * (1 + b) * (1 + c) - 1;",
                 "a + b + c + a * b + (a + b + a * b) * c", {{"a", a}, {"b", b}, {"c", c}});
}
/// An entry is no less, and hardly more, than what is proved.
void check_entry(double entry, double proved) {
  CHECK(proved <= entry);
  CHECK(proved > 0.99 * entry);
}
}  // namespace

TEST_CASE("Gappa proves what each operation loses and leaves, and not half of it") {
  for (const double l : {u, 16 * u})
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
TEST_CASE("Gappa proves what polynomials lose and leave, step by step") {
  for (const codegen::Tier& tier : codegen::tiers()) {
    const NumberType t{u, &tier};
    for (const codegen::Polynomial& p : tier.polynomials) {
      INFO(tier.name << ", " << p.name);
      const double size = p.centre > 0 ? p.centre : p.top;
      const Pair proved = polynomial(p, size, 2 * u * size);
      const NumberType::OfPolynomial entry = t.polynomial(p, size, 2 * u * size);
      check_entry(entry.loss, proved.g / p.least + p.error);
      check_entry(entry.loose, proved.l / p.least);
    }
  }
}
TEST_CASE("Gappa proves what functions and powers lose, from what their operations do") {
  for (const codegen::Tier& tier : codegen::tiers()) {
    INFO(tier.name);
    const NumberType t{u, &tier};
    constexpr double l = 4 * u, of_pi = 0x1.1bp-54, off = 0x1p-104;
    const codegen::Polynomial &atan = tier["arc_tangent"], &s = tier["small_sine"],
                              &c = tier["small_cosine"], &sine = tier["sine"],
                              &cosine = tier["cosine"];
    const auto of = [&](const codegen::Polynomial& p, double size, double low, double argument,
                        double factor = 0) {
      const NumberType::OfPolynomial q = t.polynomial(p, size, low);
      return together(q.slope * argument, q.loss, factor > 0 ? t.product(factor, q.loose).loss : 0);
    };
    // Low parts of a difference are rounded once.
    const auto difference = [&](double x, double y, double q) {
      return largest("e", "e = (x + y) * (1 + d1) - (x + y) + q;", "(x + y) * d1 + q",
                     {{"x", x}, {"y", y}, {"q", q}});
    };
    const double low = l * atan.top + u * atan.centre;
    check_entry(
        t.arc_tangent(l, l, off).loss,
        of(atan, atan.centre, low, difference(l * atan.top, u * atan.centre, off * atan.top), l));
    const codegen::Loss square = t.product(l, l);
    const auto small = t.small_sine_cosine(l);
    check_entry(small.sine.loss, of(s, s.top, square.loose * s.top, square.loss * s.top, l));
    check_entry(small.cosine.loss, of(c, c.top, square.loose * c.top, square.loss * c.top));

    const auto turned = t.sine_cosine(l);
    check_entry(turned.angle, difference(l, of_pi / 0.785, 0x1p-107 / 0.785));
    const double y = std::sqrt(sine.top), spill = turned.spill, rounded = u * sine.top;
    check_entry(spill, l * 2.3562 + of_pi);
    const double of_square = largest(
        "e",
        "v = (x * h + c) * (1 + d1); w = (x * h + v) * (1 + d2); e = w - (2 * x * h + c) - x * x;",
        "(x * h + c) * d1 + d2 * (x * h + (x * h + c) * (1 + d1)) - x * x",
        {{"x", spill}, {"h", y}, {"c", rounded}});
    const double low_square = 2 * y * spill + rounded;
    check_entry(turned.sine.loss, std::max(of(sine, sine.top, low_square, of_square, l),
                                           of(cosine, cosine.top, low_square, of_square)));
    const double loose = t.polynomial(sine, sine.top, low_square).loose;
    check_entry(turned.absolute,
                largest("e", "e = x * (1 + d1) * (1 + d2) - x * (1 + y);",
                        "x * (d1 + d2 + d1 * d2 - y)", {{"x", spill}, {"y", loose}}));
  }
  const double product = NumberType{u, &codegen::tiers()[1]}.product(u, u).loss;
  double square = 0x1p-100, power = square;  // x^(2^k) and x^(2^(k + 1) - 1)
  for (int k = 1; k < 20; ++k) {
    square = together(square, square, product);
    power = together(power, square, product);
  }
  check_entry(NumberType{u, &codegen::tiers()[1]}.power(0x1p-100, 0xfffff).loss, power);
}
TEST_CASE("each entry of the table is proved here") {
  std::set<std::string> known{"polynomial", "arc_tangent", "small_sine_cosine", "sine_cosine",
                              "power"},
      entries;
  for (const Operation& o : operations(u)) known.insert(o.name.substr(0, o.name.find(',')));
  std::ifstream table(MAGICMASS_TABLE);
  const std::regex entry("  [A-Z]?[A-Za-z]+ (\\w+)\\(.*\\) const;.*");
  std::smatch found;
  for (std::string line; std::getline(table, line);)
    if (std::regex_match(line, found, entry)) entries.insert(found[1]);
  CHECK(entries == known);
}
