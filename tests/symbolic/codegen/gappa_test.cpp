// SPDX-License-Identifier: GPL-2.0-or-later
// Gappa proves the table's entries from each operation's sequence of roundings, what is lost and
// how large a low part is left, and refuses half of each. High parts are scaled to 1, low parts are
// x and y of them; d1, d2, ... are the roundings of the operations in their order, at most u. That
// two_sum and two_product are exact, and that 1/sqrt(1 - e) - 1 - e/2 is at most 3/8 e^2 and a
// little, is said, not proved; likewise how large a low part a sum of any signs leaves (Sterbenz).
// Functions, which are sequences of these operations, are left to the other tests.
#include <cstdio>
#include <sstream>

#include "catch.hpp"
#include "codegen/exact.hpp"
#include "codegen/operations.hpp"

namespace {
using codegen::NumberType;
constexpr double u = 0x1p-53;

struct Operation {
  const char* name;
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
      {"sum", t.sum(l, l),  // x: of both low parts, against the sum of the high parts
       "v = x * (1 + d1); w = (c + v) * (1 + d2); e = (1 - c + w) - (1 + x); off = e / (1 + x);"
       "low = w / (1 - c);",
       "x * d1 + d2 * (c + x * (1 + d1))"},
      // Each of the three parts of the error by itself: of a low part, and of the high parts' sum.
      {"sum of any signs, of a low part",
       {any.of_x, 0},
       "e = d1 + d2 + d3; off = x * ((1 + d1) * (1 + d2) * (1 + d3) - 1); low = x * 0;",
       "d1 + d2 + d3"},
      {"sum of any signs, of the result",
       {any.of_result, 0},
       "e = d2 + d3; off = c * ((1 + d2) * (1 + d3) - 1); low = x * 0;",
       "d2 + d3"},
      {"product", t.product(l, l),
       "v = (x + c) * (1 + d1); w = (y + v) * (1 + d2); e = (1 - c + w) - (1 + x) * (1 + y);"
       "off = e / ((1 + x) * (1 + y)); low = w / (1 - c);",
       "(x + c) * d1 + d2 * (y + (x + c) * (1 + d1)) - x * y"},
      {"product by an exact number", t.product(l),
       "w = (x + c) * (1 + d1); e = (1 - c + w) - (1 + x); off = e / (1 + x); low = w / (1 - c);",
       "(x + c) * d1"},
      {"quotient", t.quotient(l, l),
       "g = (1 + d1) * (1 + d2) - 1; D = (1 + d6) * (1 + d7) * (1 + d1) - 1;"
       "m = (x - g * (1 + d3)) * (1 + d4) - (1 + g) * y * (1 + d5);"
       "e = (1 + g + m * (1 + D)) * (1 + y) - (1 + x); off = e / (1 + x);"
       "low = m * (1 + D) / (1 + g);",
       "(x - g) * d4 - g * d3 * (1 + d4) - y * d5 - g * y * d5 + m * D + m * (1 + D) * y"},
      {"reciprocal root", t.reciprocal_root(l),
       "g = (1 + d6) * (1 + d7) * (1 + d8) - 1; A = -2 * g - g * g - c * (1 + g);"
       "B = (1 + g) * (y * (1 + g) - c); k = -2 * g - g * g - y * (1 + g) * (1 + g);"
       "D = (1 + d4) * (1 + d5) - 1;"
       "e = ((A * (1 + d1) - B * (1 + d2) * (1 + d3)) * (1 + D) - k) / 2; off = e + q * k * k;"
       "low = e + k / 2;",
       "((A * d1 - B * (d2 + d3 + d2 * d3)) * (1 + D) + k * D) / 2"}};
}
/// Gappa says nothing where all is proved, hints included.
bool is_proved(const Operation& o, double l, const std::string& what, double bound) {
  std::ostringstream script;
  script << o.steps << "\n{ ";
  for (int k = 1; k <= 8; ++k) script << "|d" << k << "| <= " << codegen::hex(u) << " /\\ ";
  script << "|c| <= " << codegen::hex(u) << " /\\ |x| <= " << codegen::hex(l)
         << " /\\ |y| <= " << codegen::hex(l) << " /\\ |q| <= 0x1.80001p-2 -> |" << what
         << "| <= " << codegen::hex(bound) << " }\ne -> " << o.expanded << ";\n";
  std::FILE* gappa = popen("test -z \"$(" MAGICMASS_GAPPA " -Eprecision=200 2>&1)\"", "w");
  REQUIRE(gappa != nullptr);
  std::fputs(script.str().c_str(), gappa);
  INFO(script.str());
  return pclose(gappa) == 0;
}
}  // namespace

TEST_CASE("Gappa proves what each operation loses and leaves, and not half of it") {
  for (const double l : {u, 16 * u}) {
    for (const Operation& o : operations(l)) {
      INFO(o.name << ", low parts " << l);
      for (const auto& [what, bound] : {std::pair("off", o.entry.loss), {"low", o.entry.loose}}) {
        INFO(what);
        CHECK(is_proved(o, l, what, bound));
        if (bound > 0) CHECK_FALSE(is_proved(o, l, what, bound / 2));
      }
    }
  }
}
