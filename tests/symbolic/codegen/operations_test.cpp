// The table, entry by entry, against the runtime's own operations on traced numbers: all roundings
// at their most, and what is dropped as it is, in exact rationals. Over what an entry allows it is
// wrong; at half of it or less, a halved entry would do, and fails here.
#include "codegen/operations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <cln/real.h>

#include "catch.hpp"
#include "magicmass/evaluators/polynomials.hpp"

// A double that knows which roundings it has come through: how much each counts in it, to first
// order. The runtime's own operations run on it, so their roundings are counted by nobody.
namespace test {
struct Rounding {
  double most;
  double here;  // what it is with these operands
};
std::vector<Rounding> roundings;

struct Traced {
  double value = 0;
  std::vector<long double> slopes = {};  // by rounding

  Traced() = default;
  Traced(double x) : value(x) {}
  /// The sum of what roundings from `from` on may do, each at its most; `here`: what they do here.
  /// Slopes that a step of Newton's makes small are of second order.
  double worst(std::size_t from = 0) const {
    long double sum = 0;
    for (std::size_t k = from; k < slopes.size(); ++k)
      sum += std::fabs(slope(k)) * roundings[k].most;
    return double(sum);
  }
  double here(std::size_t from) const {
    long double sum = 0;
    for (std::size_t k = from; k < slopes.size(); ++k) sum += slope(k) * roundings[k].here;
    return double(sum);
  }
  long double slope(std::size_t k) const { return std::fabs(slopes[k]) < 0x1p-45 ? 0 : slopes[k]; }
  void add(const Traced& x, long double by) {
    slopes.resize(std::max(slopes.size(), x.slopes.size()));
    for (std::size_t k = 0; k < x.slopes.size(); ++k) slopes[k] += by * x.slopes[k];
  }
  void add_rounding(double most, double here) {
    roundings.push_back({most, here});
    slopes.resize(roundings.size());
    slopes.back() = 1;
  }
  /// `value` has just been rounded from `exact`; what is not rounded here never is.
  Traced& rounded_from(const cln::cl_RA& exact) {
    const cln::cl_RA off = codegen::exact(value) - exact;
    const double most = 0x1p-53 * std::max(std::fabs(value), worst());
    if (!cln::zerop(off)) add_rounding(most, cln::double_approx(off));
    return *this;
  }
};
cln::cl_RA exact(const Traced& x) { return codegen::exact(x.value); }
Traced fused(const Traced& x, const Traced& y, const Traced& z) {
  Traced r(std::fma(x.value, y.value, z.value));
  r.add(x, y.value);
  r.add(y, x.value);
  r.add(z, 1);
  return r.rounded_from(exact(x) * exact(y) + exact(z));
}
Traced operator*(const Traced& x, const Traced& y) { return fused(x, y, 0); }
Traced operator-(const Traced& x) { return fused(x, -1, 0); }
Traced operator+(const Traced& x, const Traced& y) { return fused(x, 1, y); }
Traced operator-(const Traced& x, const Traced& y) { return fused(y, -1, x); }
Traced operator/(const Traced& x, const Traced& y) {
  Traced r(x.value / y.value);
  r.add(x, 1 / static_cast<long double>(y.value));
  r.add(y, -static_cast<long double>(x.value) / y.value / y.value);
  return r.rounded_from(exact(x) / exact(y));
}
Traced square_root(const Traced& x) {
  Traced r(std::sqrt(x.value));
  r.add(x, 0.5L / std::sqrt(static_cast<long double>(x.value)));
  const cln::cl_RA root = exact(r);
  return r.rounded_from(root + (exact(x) - root * root) / (2 * root));
}
magicmass::arithmetic::DoubleDouble<Traced> two_product(const Traced& x, const Traced& y) {
  const Traced product = x * y;
  return {product, fused(x, y, -product)};
}
bool is_above(const Traced& x, const Traced& y) { return x.value > y.value; }
Traced select(bool c, const Traced& x, const Traced& y) { return c ? x : y; }
}  // namespace test

namespace {
using cln::cl_RA;
using codegen::NumberType;
using test::Traced;
using D = magicmass::arithmetic::DoubleDouble<Traced>;
namespace generated = magicmass::generated;
constexpr double u = 0x1p-53;

/// f(x) from CLN, to a few units of 2^-249 of it.
using RealFunction = const cln::cl_R (*)(const cln::cl_R&);
cl_RA by_float(RealFunction f, const cl_RA& x) {
  return cln::rational(f(cln::cl_float(x, cln::float_format(75))));
}
cl_RA value(const D& x) { return exact(x.high) + exact(x.low); }
double size(const cl_RA& x) { return std::fabs(cln::double_approx(x)); }

struct Allowed {
  double loss, low;  // absolute: of the result, and its low part
};
struct Entry {
  const char* name;
  double low, high;                                        // of the operands' high parts
  double x, y;                                             // of their low parts
  std::function<Allowed(double, double, double)> allowed;  // from sizes of operands and result
  std::function<D(D, D)> computed;
  std::function<cl_RA(const cl_RA&, const cl_RA&)> wanted;
  bool cancels = false;  // what is left is no larger than low parts
};
class Drawer {
public:
  D draw(double low, double high, double loose) {
    double h = low + (high - low) * uniform();
    if (random() % 4 == 0) h = std::ldexp(1 + 0x1p-52 * double(random() % 4), std::ilogb(h));
    if (!(h >= low && h < high)) h = low;
    const double share = random() % 4 != 0 ? 1 : uniform();
    D r{h, h * loose * share * (random() % 2 == 0 ? 1 : -1)};
    r.low.add_rounding(h * loose, r.low.value);
    return r;
  }

private:
  std::mt19937_64 random{7};
  double uniform() { return double(random() >> 11) * 0x1p-53; }
};
struct Shares {
  double loss = 0, low = 0;
};
/// Of what entries allow, the largest shares are at most 1, and more than where one is halved.
void check(const std::vector<Entry>& entries, int rows, Shares halved = {0.5, 0.5}) {
  Shares most;
  for (const Entry& e : entries) {
    Drawer drawer;
    for (int row = 0; row < rows; ++row) {
      test::roundings.clear();
      const D x = drawer.draw(e.low, e.high, e.x), y = drawer.draw(e.low, e.high, e.y);
      const std::size_t operands = test::roundings.size();
      const D r = e.computed(x, y);
      const cl_RA w = e.wanted(value(x), value(y));
      Traced both = r.high;
      both.add(r.low, 1);
      const double dropped = size(value(r) - w - codegen::exact(both.here(operands)));
      const Allowed allowed = e.allowed(x.high.value, y.high.value, size(w));
      most.loss = std::max(most.loss, (dropped + both.worst(operands)) / allowed.loss);
      const double low = e.cancels ? 0 : r.low.worst();
      most.low = std::max(most.low, std::max(low, std::fabs(r.low.value)) / allowed.low);
    }
    INFO(e.name << ", low parts " << e.x << ", " << e.y);
    CHECK(most.loss <= 1);
    CHECK(most.low <= 1);
  }
  INFO(entries[0].name);
  std::printf("%s: of what is allowed at most %.3f is lost, low parts %.3f\n", entries[0].name,
              most.loss, most.low);
  CHECK(most.loss > halved.loss);
  CHECK(most.low > halved.low);
}
std::function<Allowed(double, double, double)> relative(codegen::Loss l) {
  return [l](double, double, double w) { return Allowed{l.loss * w, l.loose * w}; };
}
/// Of functions, with their polynomials' errors. Half of an entry is seen for Slow, whose errors
/// are below all roundings: all tiers have it from the same lines. Of the arctangent 0.43 is seen.
template <class Tier>
void check_functions(const codegen::Tier& tier) {
  const double l = 64 * u, half = tier.name == "Slow" ? 0.5 : 0;
  const NumberType t{u, &tier};
  const NumberType::SineCosine small = t.small_sine_cosine(l), turned = t.sine_cosine(l);
  const codegen::Loss square = t.product(l, l);
  const auto entry = [l](const char* name, double low, double high, auto allowed, auto computed,
                         RealFunction f) {
    const auto wanted = [f](const cl_RA& x, const cl_RA&) { return by_float(f, x); };
    return Entry{name, low, high, l, l, allowed, [=](D x, D) { return computed(x); }, wanted};
  };
  const auto small_sine = [](D x) { return sine_cosine_small<Tier>(x).sine; };
  const auto small_cosine = [](D x) { return sine_cosine_small<Tier>(x).cosine; };
  const auto tangent = [](D x) { return arc_tangent<Tier>(x, x * x); };
  check({entry("sine, small", 0.01, 0.5235, relative(small.sine), small_sine, cln::sin)}, 100,
        {half, half});
  check({entry("cosine, small", 0.01, 0.5235, relative(small.cosine), small_cosine, cln::cos)}, 100,
        {half, half});
  check({entry("arctangent", 0.001, 0.577, relative(t.arc_tangent(l, square.loose, square.loss)),
               tangent, cln::atan)},
        100, {0.8 * half, half});
  const auto of_sine = [=](double x, double, double w) {
    return Allowed{turned.sine.loss * w + turned.angle * x, turned.sine.loose * w};
  };
  const auto of_cosine = [=](double x, double, double w) {
    return Allowed{turned.cosine.loss * w + turned.absolute + turned.angle * x,
                   turned.cosine.loose * w + turned.spill};
  };
  const auto sine = [](D x) { return magicmass::arithmetic::sine_cosine<Tier>(x).sine; };
  const auto cosine = [](D x) { return magicmass::arithmetic::sine_cosine<Tier>(x).cosine; };
  check({entry("sine", 0.01, 0.785, of_sine, sine, cln::sin),
         entry("cosine", 0.01, 0.785, of_cosine, cosine, cln::cos),
         entry("sine, turned", 0.786, 2.355, of_sine, sine, cln::sin),
         entry("cosine, turned", 0.786, 2.355, of_cosine, cosine, cln::cos),
         entry("cosine, near 0", 1.5707, 1.5709, of_cosine, cosine, cln::cos)},
        100, {half, half});
}
}  // namespace

TEST_CASE("sums, products, quotients and roots lose what the table allows, and not half of it") {
  for (double l : {u, 16 * u}) {
    const NumberType t{u, &codegen::tiers()[1]};
    const auto cancelling = [t](double of_x, double of_y) {
      const NumberType::Cancelling c = t.cancelling_sum(of_x, of_y);
      return [c](double x, double y, double w) {
        return Allowed{c.of_x * x + c.of_y * y + c.of_result * w, c.loose * w};
      };
    };
    const std::vector<Entry> entries{
        {"sum", 1, 4, l, l, relative(t.sum(l, l)), std::plus<>(), std::plus<>()},
        {"product", 1, 4, l, l, relative(t.product(l, l)), std::multiplies<>(),
         std::multiplies<>()},
        {"product by an exact number", 1, 4, l, 0, relative(t.product(l)),
         [](D x, D y) { return times(x, y.high); }, std::multiplies<>()},
        {"quotient", 1, 4, l, l, relative(t.quotient(l, l)),
         [](D x, D y) { return quotient(x, y); }, std::divides<>()},
        {"reciprocal root", 1, 4, l, l, relative(t.reciprocal_root(l)),
         [](D x, D) { return reciprocal_root(x); },
         [](const cl_RA& x, const cl_RA&) { return by_float(cln::sqrt, 1 / x); }},
    };
    for (const Entry& e : entries) check({e}, 500);
    if (l > u) continue;
    const auto x_less_y = [](D x, D y) { return cancelling_sum(x, scaled(-y, 0.25)); };
    const auto rest = [](const cl_RA& x, const cl_RA& y) { return x - y / 4; };
    // Of low parts that are large, or so small that the high parts' sum alone is rounded.
    const std::vector<Entry> less{
        {"x less y", 3, 4, 64 * l, l, cancelling(64 * l, l), x_less_y, rest},
        {"x less y, high", 3, 4, l * l, l * l, cancelling(l * l, l * l), x_less_y, rest},
        {"y less x", 3, 4, l, 64 * l, cancelling(l, 64 * l),
         [=](D x, D y) { return x_less_y(y, x); },
         [=](const cl_RA& x, const cl_RA& y) { return rest(y, x); }}};
    for (const Entry& e : less) check({e}, 500, {0.5, 0.3});
    check({{"what cancels", 1, 1 + 128 * u, 64 * l, l, cancelling(64 * l, l),
            [](D x, D y) { return cancelling_sum(x, -y); }, std::minus<>(), true}},
          2000, {0.3, 0.3});
    // A tie that goes up, and what is left of it another: the low part is twice a rounding.
    const D low_above_high{u, 1 + 2 * u};
    const auto allowed = cancelling(1 / u + 2, 0);
    check({{"a low part above a high one", 1, 1, 0, 0,
            [=](double, double, double w) { return allowed(u, 0, w); },
            [=](D, D) { return cancelling_sum(low_above_high, D{}); },
            [=](const cl_RA&, const cl_RA&) { return value(low_above_high); }}},
          1, {0.3, 0.5});
  }
}
TEST_CASE("functions of each tier lose what the table allows, and not half of it") {
  check_functions<generated::Fast>(codegen::tiers()[0]);
  check_functions<generated::Accurate>(codegen::tiers()[1]);
  check_functions<generated::Slow>(codegen::tiers()[2]);
}
TEST_CASE("a polynomial with a spoiled coefficient is seen by its own proof and by the table") {
  for (const codegen::Tier& tier : codegen::tiers())
    for (const codegen::Polynomial& p : tier.polynomials) {
      CHECK(codegen::proved_error(p) == p.error);
      for (std::size_t k = 0; k < p.low.size(); ++k) {
        codegen::Polynomial spoiled = p;
        spoiled.high[k] = std::nextafter(spoiled.high[k], 10);
        CHECK(codegen::proved_error(spoiled) > p.error);
      }
    }
}

TEST_CASE("powers lose what the table allows, are cut off at 2^-200, and end where it does not") {
  using Pair = magicmass::arithmetic::DoubleDouble<double>;
  const NumberType t{u, &codegen::tiers()[1]};
  for (const double x : {0.9, 0.999, 0x1.fffffffffffffp-1})
    for (const int n : {1, 2, 7, 100, 1023}) {
      const Pair p = magicmass::arithmetic::power(Pair{x, 0}, n);
      const cl_RA wanted = cln::expt(codegen::exact(x), n);
      const cl_RA off = codegen::exact(p.high) + codegen::exact(p.low) - wanted;
      CHECK(size(off) <= t.power(0, n).loss * size(wanted));
    }
  CHECK(magicmass::arithmetic::power(Pair{0.5, 0}, 1e6).high == 0x1p-200);
  CHECK_THROWS_WITH(t.power(0x1p-60, 0x1p40), "a power of too high an exponent");
}
