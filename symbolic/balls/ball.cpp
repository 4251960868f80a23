#include "balls/ball.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <cln/real.h>

#include "kernel/expr.hpp"

namespace balls {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// q scaled by 2^e.
cl_RA scaled(const cl_RA& q, int e) {
  return e >= 0 ? q * cln::ash(cl_I(1), e) : q / cln::ash(cl_I(1), -e);
}
/// e with 2^e <= q < 2^(e+1), for q > 0.
int exponent_of(const cl_RA& q) {
  const auto length = [](const cl_I& n) { return static_cast<int>(cln::integer_length(n)); };
  const int e = length(cln::numerator(q)) - length(cln::denominator(q));
  return scaled(q, -e) < 1 ? e - 1 : e;
}
double nearest(const cl_RA& q) {
  if (q == 0) return 0;
  const int e = std::max(exponent_of(cln::abs(q)), -1022) - 52;
  return std::ldexp(cln::double_approx(cln::round1(scaled(q, -e))), e);  // ties to even
}

std::size_t length(const cl_RA& q) {
  return cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
}

}  // namespace

int Ball::bits = 128;

Ball::Ball(const cl_RA& q)
    : middle(cln::floor1(scaled(q, bits))), radius(scaled(q, bits) == middle ? 0 : 1) {}
Ball operator+(const Ball& a, const Ball& b) { return {a.middle + b.middle, a.radius + b.radius}; }
Ball operator*(const Ball& a, const Ball& b) {
  if (a.is_zero() || b.is_zero()) return 0;
  const cl_I error = abs(a.middle) * b.radius + abs(b.middle) * a.radius + a.radius * b.radius;
  // One unit for the product's own rounding, one for that of its error.
  return {cln::ash(a.middle * b.middle, -Ball::bits), cln::ash(error, -Ball::bits) + 2};
}
Ball operator/(const Ball& a, const Ball& b) {
  const cl_I least = cln::abs(b.middle) - b.radius;
  if (least <= 0) throw NotCertain("a divisor is not certainly different from 0");
  if (a.is_zero()) return 0;
  // |a/b - m_a/m_b| <= (r_a |m_b| + r_b |m_a|)/(|m_b| least)
  const cl_I quotient = cln::floor1(cln::ash(a.middle, Ball::bits), b.middle);
  const cl_I error = ash(a.radius * abs(b.middle) + b.radius * abs(a.middle), Ball::bits);
  return {quotient, cln::floor1(error, cln::abs(b.middle) * least) + 2};
}
cl_RA Ball::low() const { return scaled(middle - radius, -bits); }
cl_RA Ball::high() const { return scaled(middle + radius, -bits); }
double Ball::size() const { return std::ldexp(double_approx(abs(middle) + radius), -bits); }

/// The sum of term, -term square/((first + 1)(first + 2)), ..., off by less than its last term:
/// where they alternate, once they fall, and else where |square| < 1.
Ball Ball::over_factorials(Ball term, const Ball& square, int first) {
  Ball sum = term;
  for (int k = first; cln::abs(term.middle) > term.radius || k < first + 16; k += 2) {
    term = -(term * square).over((k + 1) * (k + 2));
    sum = sum + term;
  }
  sum.radius = sum.radius + cln::abs(term.middle) + term.radius;
  return sum;
}
/// t + t square/3 + t square^2/5 + ...; what is left out is less than the last power.
Ball Ball::odd_powers(const Ball& t, const Ball& square) {
  Ball power = t, sum = t;
  for (int k = 1; cln::abs(power.middle) > power.radius; ++k) {
    power = power * square;
    sum = sum + power.over(2 * k + 1);
  }
  sum.radius = sum.radius + cln::abs(power.middle) + power.radius;
  return sum;
}
Ball cos(const Ball& x) { return Ball::over_factorials(1, x * x, 0); }
Ball sin(const Ball& x) { return Ball::over_factorials(x, x * x, 1); }
Ball power(const Ball& base, std::int64_t exponent) {
  const auto size = static_cast<std::int64_t>(cln::integer_length(base.middle)) - Ball::bits;
  if (size > 1 && exponent > 1000000 / size) throw NotCertain("a power of too many digits");
  Ball result = 1, square = base;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = result * square;
    if (exponent > 1) square = square * square;
  }
  return result;
}
Ball sqrt(const Ball& x) {
  if (x.middle < x.radius) throw NotCertain("a root of what may be negative");
  cl_I root;
  cln::isqrt(cln::ash(x.middle, Ball::bits), &root);
  // |sqrt(x) - sqrt(m)| <= r/sqrt(m), and <= sqrt(r)
  cl_I error;
  cln::isqrt(cln::ash(x.radius, Ball::bits), &error);
  if (root > 0) error = cln::min(error, cln::floor1(cln::ash(x.radius, Ball::bits), root));
  return {root, error + 2};
}
Ball nth_root(const Ball& x, int n) {
  if (x.middle <= x.radius) throw NotCertain("a root of what may not be positive");
  const cl_RA middle = scaled(x.middle, -Ball::bits);
  const int e = exponent_of(middle);
  const double start = std::exp2(std::log2(nearest(scaled(middle, -e))) / n + e % n / double(n));
  Ball y(scaled(exact(start), e / n));
  for (int right = 40; right < Ball::bits + std::abs(e); right *= 2) {  // Newton's iteration
    y = y - (power(y, n) - x) / (Ball(n) * power(y, n - 1));
    y.radius = 0;
  }
  // |x^(1/n) - y| <= |x - y^n|/y^(n-1)
  const Ball off = (x - power(y, n)) / power(y, n - 1);
  y.radius = cln::abs(off.middle) + off.radius;
  return y;
}
Ball atan(const Ball& x) {
  // atan(x) = 2 atan(x/(1 + sqrt(1 + x^2))), so that the series is short.
  constexpr int halvings = 6;
  Ball t = x;
  for (int k = 0; k < halvings; ++k) t = t / (Ball(1) + sqrt(Ball(1) + t * t));
  return Ball(1 << halvings) * Ball::odd_powers(t, -(t * t));
}
Ball Ball::pi() {  // Machin, once for these bits
  static std::map<int, Ball> known;
  if (const auto it = known.find(bits); it != known.end()) return it->second;
  const Ball half_turn = Ball(16) * atan(Ball(1) / 5) - Ball(4) * atan(Ball(1) / 239);
  return known.emplace(bits, half_turn).first->second;
}
Ball exp(const Ball& x) {
  if (x.high() > 100000) throw NotCertain("an exponential of what may be above 10^5");
  // exp(x) = exp(x/2^k)^(2^k), the middle alone: exp(m + r) <= exp(m) (1 + 2 r) for r <= 1.
  if (x.radius > cln::ash(cl_I(1), Ball::bits)) throw NotCertain("an exponential of a wide ball");
  const int halvings = 8 + static_cast<int>(cln::integer_length(cln::floor1(cln::abs(x.low()))));
  const Ball small{cln::ash(x.middle, -halvings), cl_I(1)};
  const Ball square = -(small * small);
  Ball sum = Ball::over_factorials(1, square, 0) + Ball::over_factorials(small, square, 1);
  for (int k = 0; k < halvings; ++k) sum = sum * sum;
  sum.radius =
      sum.radius + cln::ash(2 * x.radius * (cln::abs(sum.middle) + sum.radius), -Ball::bits) + 1;
  return sum;
}
Ball log(const Ball& x) {
  if (x.middle <= x.radius) throw NotCertain("a logarithm of what may not be positive");
  // x = 2^e y with y near 1; log y = 2 atanh((y - 1)/(y + 1)) = 2 (t + t^3/3 + ...)
  const auto area = [](const Ball& y) {
    const Ball t = (y - Ball(1)) / (y + Ball(1));
    return Ball(2) * Ball::odd_powers(t, t * t);
  };
  const int e = exponent_of(cln::max(x.low(), cl_RA(0)));
  const Ball y{cln::ash(x.middle, -e), cln::ash(x.radius, -e) + 1};
  return area(y) + Ball(e) * area(Ball(2));
}
Ball ceil(const Ball& x) {
  const cl_RA low = cln::ceiling1(x.low());
  if (low != cln::ceiling1(x.high())) throw NotCertain("a whole number is too close");
  return low;
}
bool operator<=(const Ball& a, const Ball& b) {
  if (a.middle + a.radius <= b.middle - b.radius) return true;
  if (a.middle - a.radius > b.middle + b.radius) return false;
  throw NotCertain("two numbers are too close");
}

std::optional<double> nearest_double(const cl_RA& low, const cl_RA& high) {
  const double value = nearest(low);
  if (value != nearest(high) || std::isinf(value)) return {};
  return value;
}
std::optional<std::string> decimal(const cl_RA& low, const cl_RA& high, int digits) {
  if (low == 0 && high == 0) return "0";
  if (low <= 0 && high >= 0) return {};
  const bool minus = high < 0;
  const cl_RA small = minus ? -high : low, large = minus ? -low : high;
  // The place of the first digit: 10^p <= small < 10^(p+1).
  int p = static_cast<int>(std::floor(exponent_of(small) * 0.30103));
  const auto power = [](int e) { return cln::expt(cl_RA(10), e); };
  while (power(p + 1) <= small) ++p;
  while (power(p) > small) --p;
  const cl_RA scale = power(digits - 1 - p);
  cl_I whole = cln::round1(small * scale);
  if (whole != cln::round1(large * scale)) return {};
  std::string text = kernel::digits(whole);
  if (static_cast<int>(text.size()) > digits) {  // 9.99... became 10.0
    text.pop_back();
    ++p;
  }
  std::string out = minus ? "-" : "";
  if (p >= 0 && p < digits - 1)
    out += text.substr(0, std::size_t(p) + 1) + "." + text.substr(std::size_t(p) + 1);
  else if (p < 0 && p >= -6)
    out += "0." + std::string(std::size_t(-p - 1), '0') + text;
  else
    out += text.substr(0, 1) + (digits > 1 ? "." + text.substr(1) : "") + "e" + std::to_string(p);
  return out;
}

cl_RA exact(double value) {
  int exponent = 0;
  const auto whole = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  return scaled(cl_I(static_cast<long long>(whole)), exponent - 53);
}

void Surd::add(const cl_I& d, const cl_RA& factor) {
  if (cln::zerop(factor)) return;
  cl_I root = d;
  const auto place = std::partition_point(roots_.begin(), roots_.end(),
                                          [&](const auto& r) { return r.first < d; });
  const bool is_there = place != roots_.end() && place->first == d;
  if (!is_there && cln::sqrtp(d, &root)) {
    rational_ = rational_ + factor * root;
    return;
  }
  const auto is_same = [&](const auto& r) { return cln::sqrtp(cl_I(d * r.first), &root); };
  auto same = is_there ? place : std::ranges::find_if(roots_, is_same);  // but for a fraction
  if (same == roots_.end()) std::tie(same, root) = std::pair(roots_.insert(place, {d, 0}), d);
  same->second = same->second + factor * root / same->first;
  if (cln::zerop(same->second)) roots_.erase(same);
}
Surd Surd::sqrt(const Surd& x) {
  if (!x.roots_.empty()) throw std::domain_error("a square root in a square root");
  if (cln::minusp(x.rational_)) throw std::domain_error("the square root of a negative number");
  cl_I rest = cln::numerator(x.rational_) * cln::denominator(x.rational_);
  cl_RA outside = cln::recip(cln::denominator(x.rational_));
  for (int p = 2; p < 1000 && !cln::zerop(rest); ++p)
    while (cln::zerop(cln::mod(rest, p * p))) {
      rest = cln::exquo(rest, p * p);
      outside = outside * p;
    }
  Surd root;
  root.add(rest, outside);
  return root;
}

Surd operator+(const Surd& x, const Surd& y) {
  Surd sum = x;
  sum.rational_ = x.rational_ + y.rational_;
  for (const auto& [d, factor] : y.roots_) sum.add(d, factor);
  return sum;
}
/// Over one denominator: sums of fractions take far longer.
Surd operator*(const Surd& x, const Surd& y) {
  const auto times = [](Surd product, const cl_RA& q) {
    product.rational_ = product.rational_ * q;
    for (auto& [d, factor] : product.roots_) factor = factor * q;
    return cln::zerop(q) ? Surd() : product;
  };
  if (x.roots_.empty()) return times(y, x.rational_);
  const auto whole = [&](const Surd& z, cl_I& below) {
    for (const auto& [d, factor] : z.roots_) below = cln::lcm(below, cln::denominator(factor));
    return times(z, below);
  };
  cl_I below_x = cln::denominator(x.rational_), below_y = cln::denominator(y.rational_);
  const Surd u = whole(x, below_x), v = whole(y, below_y);
  Surd product = times(v, u.rational_);
  for (const auto& [d, factor] : u.roots_) {
    product.add(d, factor * v.rational_);
    for (const auto& [e, by] : v.roots_) {
      const cl_I common = cln::gcd(d, e);
      product.add(cln::exquo(d, common) * cln::exquo(e, common), factor * by * common);
    }
  }
  return times(product, cln::recip(cl_RA(below_x * below_y)));
}
Surd operator/(const Surd& x, const Surd& y) {
  Surd above = x, below = y;
  for (int round = 0; !below.roots_.empty(); ++round) {  // (u + v)(u - v) has not the factor of v
    if (round == 64) throw std::domain_error("too many square roots");
    cl_I common = 0;
    for (const auto& [d, factor] : below.roots_)
      if (const cl_I both = cln::gcd(common, d); both > 1) common = both;
    Surd turned = below;
    for (auto& [d, factor] : turned.roots_)
      if (cln::gcd(common, d) > 1) factor = -factor;
    above = above * turned;
    below = below * turned;
  }
  if (cln::zerop(below.rational_)) throw std::domain_error("a division by 0");
  return above * Surd(cln::recip(below.rational_));
}

/// Off by less than 2^-80 of it.
cl_RA Surd::near() const {
  if (roots_.empty()) return rational_;
  for (int bits = 128;; bits *= 2) {
    cl_I sum = cln::floor1(scaled(rational_, bits)), off = 1, root;
    for (const auto& [d, factor] : roots_) {  // sums of fractions would be long
      cln::isqrt(cln::ash(d, 2 * bits), &root);
      sum = sum + cln::floor1(cln::numerator(factor) * root, cln::denominator(factor));
      off = off + cln::ceiling1(cln::abs(factor)) + 1;
    }
    if (cln::abs(sum) >= cln::ash(off, 80)) return scaled(sum, -bits);
  }
}
int Surd::compared(const Surd& x, const Surd& y) {
  const bool are_rational = x.roots_.empty() && y.roots_.empty();
  return are_rational ? cln::compare(x.rational_, y.rational_)  // needs no gcd
                      : cln::compare((x - y).near(), 0);
}

std::size_t Surd::bits() const {
  std::size_t sum = length(rational_);
  for (const auto& [d, factor] : roots_) sum += length(factor);
  return sum;
}
std::optional<double> Surd::to_double() const {
  const cl_RA x = near();
  const double value = nearest(x);
  return cln::zerop(x) || std::isnormal(value) ? std::optional(value) : std::nullopt;
}
std::string Surd::text() const {
  std::string all = cln::zerop(rational_) && !roots_.empty() ? "" : kernel::digits(rational_);
  for (const auto& [d, factor] : roots_) {
    const cl_RA size = cln::abs(factor);
    all += cln::minusp(factor) ? "-" : all.empty() ? "" : "+";
    all += (size == 1 ? "" : kernel::digits(size) + "*") + "sqrt(" + kernel::digits(d) + ")";
  }
  return all;
}
Ball ball_of(const Surd& x) {
  Ball sum(x.rational_);
  for (const auto& [d, factor] : x.roots_) sum = sum + Ball(factor) * sqrt(Ball(cl_RA(d)));
  return sum;
}

}  // namespace balls
