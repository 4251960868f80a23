// SPDX-License-Identifier: GPL-2.0-or-later
// The table, entry by entry: what is lost on random inputs, many near powers of two, as a share of
// what the entry allows, in exact rationals. Over 1 an entry is wrong; below the second number of a
// row half of the entry would do, so a halved entry fails here.
#include "codegen/operations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <cln/float.h>
#include <cln/real.h>

#include "catch.hpp"
#include "codegen/exact.hpp"
#include "magicmass/arithmetic/functions.hpp"
#include "magicmass/evaluators/polynomials.hpp"

namespace {
using cln::cl_RA;
using codegen::exact;
using codegen::NumberType;
using D = magicmass::arithmetic::DoubleDouble<double>;
namespace generated = magicmass::generated;
constexpr double u = 0x1p-53;

cl_RA value(const D& x) { return exact(x.high) + exact(x.low); }
double size(const cl_RA& x) { return std::fabs(cln::double_approx(x)); }
cl_RA by_float(cln::cl_F (*f)(const cln::cl_F&), const cl_RA& x) {
  return cln::rational(f(cln::cl_float(x, cln::float_format(75))));
}
cl_RA sine(const cl_RA& x) {
  return by_float([](const cln::cl_F& y) { return cln::cl_F(cln::sin(y)); }, x);
}
cl_RA cosine(const cl_RA& x) {
  return by_float([](const cln::cl_F& y) { return cln::cl_F(cln::cos(y)); }, x);
}
cl_RA arc_tangent(const cl_RA& x) {
  return by_float([](const cln::cl_F& y) { return cln::cl_F(cln::atan(y)); }, x);
}
cl_RA reciprocal_root(const cl_RA& x) {
  return by_float([](const cln::cl_F& y) { return cln::sqrt(y); }, 1 / x);
}

struct Entry {
  const char* name;
  double low, high;    // of the operands' high parts
  double x, y;         // of their low parts
  double loss, loose;  // allowed: relative; loss negative: -loss is absolute
  double least_share;  // of the loss that random inputs show
  std::function<D(D, D)> computed;
  std::function<cl_RA(const cl_RA&, const cl_RA&)> wanted;
};
class Drawer {
public:
  D draw(double low, double high, double loose) {
    double h = low + (high - low) * uniform();
    if (random() % 4 == 0) h = std::ldexp(1 + 0x1p-52 * double(random() % 4), std::ilogb(h));
    if (!(h >= low && h < high)) h = low;
    const double share = random() % 4 != 0 ? 1 : uniform();
    return {h, h * loose * share * (random() % 2 == 0 ? 1 : -1)};
  }

private:
  std::mt19937_64 random{7};
  double uniform() { return double(random() >> 11) * 0x1p-53; }
};
void check(const Entry& e, int rows) {
  INFO(e.name << ", low parts " << e.x << ", " << e.y);
  Drawer drawer;
  double loss = 0;
  double loose = 0;
  for (int row = 0; row < rows; ++row) {
    const D x = drawer.draw(e.low, e.high, e.x);
    const D y = drawer.draw(e.low, e.high, e.y);
    const D r = e.computed(x, y);
    const cl_RA w = e.wanted(value(x), value(y));
    const double allowed = e.loss < 0 ? -e.loss : e.loss * size(w);
    loss = std::max(loss, size(value(r) - w) / allowed);
    if (e.loose > 0) loose = std::max(loose, std::fabs(r.low) / (std::fabs(r.high) * e.loose));
  }
  CHECK(loss <= 1);
  CHECK(loss > e.least_share);
  CHECK(loose <= 1);
}
template <class Tier>
std::vector<Entry> functions(const codegen::Tier& tier, double l, double share) {
  const NumberType t{u, &tier};
  const NumberType::SineCosine small = t.small_sine_cosine(l);
  const NumberType::SineCosine turned = t.sine_cosine(l);
  const codegen::Loss square = t.product(l, l);
  const codegen::Loss atan = t.arc_tangent(l, square.loose, square.loss);
  const double of_cosine = turned.cosine.loss + turned.absolute + 2.1 * turned.angle;
  return {{"sine, small", 0.01, 0.5235, l, l, small.sine.loss, small.sine.loose, share,
           [](D x, D) { return sine_cosine_small<Tier>(x).sine; },
           [](const cl_RA& x, const cl_RA&) { return sine(x); }},
          {"cosine, small", 0.01, 0.5235, l, l, small.cosine.loss, small.cosine.loose, share,
           [](D x, D) { return sine_cosine_small<Tier>(x).cosine; },
           [](const cl_RA& x, const cl_RA&) { return cosine(x); }},
          {"sine", 0.01, 1.57, l, l, turned.sine.loss + 2 * turned.angle, turned.sine.loose, share,
           [](D x, D) { return magicmass::arithmetic::sine_cosine<Tier>(x).sine; },
           [](const cl_RA& x, const cl_RA&) { return sine(x); }},
          {"cosine", 0.01, 2.09, l, l, -of_cosine, 0, share,
           [](D x, D) { return magicmass::arithmetic::sine_cosine<Tier>(x).cosine; },
           [](const cl_RA& x, const cl_RA&) { return cosine(x); }},
          {"arctangent", 0.001, 0.577, l, l, atan.loss, atan.loose, share,
           [](D x, D) { return arc_tangent<Tier>(x, x * x); },
           [](const cl_RA& x, const cl_RA&) { return arc_tangent(x); }}};
}
}  // namespace

TEST_CASE("sums, products, quotients and roots lose what the table allows, and not half of it") {
  for (double l : {u, 16 * u}) {
    const NumberType t{u, &codegen::tiers()[1]};
    const NumberType::Cancelling c = t.cancelling_sum(l, l);
    const double cancelling = 2 * (c.of_x + c.of_y) + 2 * c.of_result;
    const codegen::Loss sum = t.sum(l, l);
    const codegen::Loss product = t.product(l, l);
    const codegen::Loss by_exact = t.product(l);
    const codegen::Loss of_quotient = t.quotient(l, l);
    const codegen::Loss root = t.reciprocal_root(l);
    const std::vector<Entry> entries{
        {"sum", 1, 4, l, l, sum.loss, sum.loose, 0.5, [](D x, D y) { return x + y; },
         [](const cl_RA& x, const cl_RA& y) { return x + y; }},
        {"product", 1, 4, l, l, product.loss, product.loose, 0.5, [](D x, D y) { return x * y; },
         [](const cl_RA& x, const cl_RA& y) { return x * y; }},
        {"product by an exact number", 1, 4, l, 0, by_exact.loss, by_exact.loose, 0.5,
         [](D x, D y) { return times(x, y.high); },
         [](const cl_RA& x, const cl_RA& y) { return x * y; }},
        {"quotient", 1, 4, l, l, of_quotient.loss, of_quotient.loose, 0.5,
         [](D x, D y) { return quotient(x, y); },
         [](const cl_RA& x, const cl_RA& y) { return x / y; }},
        {"reciprocal root", 1, 4, l, l, root.loss, root.loose, 0.5,
         [](D x, D) { return reciprocal_root(x); },
         [](const cl_RA& x, const cl_RA&) { return reciprocal_root(x); }},
        {"sum that cancels", 1, 2, l, l, -cancelling, c.loose, 0.12,
         [](D x, D y) { return cancelling_sum(x, -y); },
         [](const cl_RA& x, const cl_RA& y) { return x - y; }},
    };
    for (const Entry& e : entries) check(e, 20000);
  }
}
TEST_CASE("functions of each tier lose what the table allows") {
  const auto all = [](const std::vector<Entry>& entries) {
    for (const Entry& e : entries) check(e, 1500);
  };
  // Fast's loss is its polynomials', whose proofs are wider than what is seen; Slow's bounds add
  // what a turned angle's low part may do at its worst.
  all(functions<generated::Fast>(codegen::tiers()[0], 4 * u, 0.1));
  all(functions<generated::Accurate>(codegen::tiers()[1], 4 * u, 0.25));
  all(functions<generated::Slow>(codegen::tiers()[2], 4 * u, 0.08));
}
TEST_CASE("a polynomial with a spoiled coefficient is seen by its own proof and by the table") {
  for (const codegen::Tier& tier : codegen::tiers()) {
    for (const codegen::Polynomial& p : tier.polynomials) {
      CHECK(codegen::proved_error(p) == p.error);
      for (std::size_t k = 0; k < p.low.size(); ++k) {
        codegen::Polynomial spoiled = p;
        spoiled.high[k] = std::nextafter(spoiled.high[k], 10);
        CHECK(codegen::proved_error(spoiled) > p.error);
      }
    }
  }
}
