// SPDX-License-Identifier: MIT
// A number type for many numbers at once, whose results are rounded two or three times where a Pair's are hardly more than
// once: each of its operations keeps what the next one needs, and no more.
#pragma once

#include "magicmass/arithmetic/error_free.hpp"
#include "magicmass/arithmetic/tangent_estimate.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A result.
template <class T>
struct Rounded {
  T value;

  friend Rounded operator+(Rounded x, T y) { return {x.value + y}; }
  friend Rounded operator/(Rounded x, T y) { return {x.value / y}; }
  friend Rounded scaled(Rounded x, double power_of_two) { return {x.value * T(power_of_two)}; }
  friend T rounded(Rounded x) { return x.value; }
};

/// high + low, a product. Sums are rounded twice: that of the highs, and the whole.
template <class T>
struct Wide {
  T high;
  T low;

  operator Rounded<T>() const { return {high + low}; }
  friend Rounded<T> operator-(Wide x) { return {-(x.high + x.low)}; }
  friend Rounded<T> operator-(Wide x, Rounded<T> y) { return {(x.high + x.low) - y.value}; }
  friend Rounded<T> operator+(Wide x, Wide y) { return {(x.high + y.high) + (x.low + y.low)}; }
  friend Rounded<T> operator-(Wide x, Wide y) { return {(x.high - y.high) + (x.low - y.low)}; }
  friend Rounded<T> scaled(Wide x, double power_of_two) {
    return {(x.high + x.low) * T(power_of_two)};
  }
  friend Wide operator*(Wide x, T y) {
    const Sum<T> p = two_product(x.high, y);
    return {p.high, p.low + x.low * y};
  }
};

/// 1 - below: a cosine, whose error matters beside 1.
template <class T>
struct NearOne {
  T below;
};

/// lead + rest, where lead has 26 bits at most: products of two leads are exact without fused operations. What rounds is the
/// rest, which may be a third of it all, in units of 2^-53 of itself.
template <class T>
struct Cut {
  T lead;
  T rest;

  Cut() = default;
  Cut(T leading_part, T the_rest) : lead(leading_part), rest(the_rest) {}

  friend Wide<T> operator*(Cut x, Cut y) {
    return {x.lead * y.lead, x.rest * y.lead + (x.lead + x.rest) * y.rest};
  }
  friend Cut operator*(Cut x, NearOne<T> y) {
    return {x.lead, x.rest - (x.lead + x.rest) * y.below};
  }
  operator Rounded<T>() const { return {lead + rest}; }
  friend Rounded<T> operator+(Cut x, Wide<T> y) { return {(x.lead + y.high) + (x.rest + y.low)}; }
  friend Cut operator-(T x, Cut y) { return {x - y.lead, -y.rest}; }
  friend Cut operator-(Cut x) { return {-x.lead, -x.rest}; }
  friend Cut scaled(Cut x, double power_of_two) {
    return {x.lead * T(power_of_two), x.rest * T(power_of_two)};
  }
  /// Leads subtract exactly where they are within a factor of 2^26. That one has 26 bits and one for each halving from the larger to
  /// the smaller: times 24 bits it is exact down to an eighth, and rounded once below.
  friend Cut operator-(Cut x, Cut y) { return {x.lead - y.lead, x.rest - y.rest}; }
  friend Cut operator+(Cut x, Cut y) { return {x.lead + y.lead, x.rest + y.rest}; }
};

/// pi - x, exactly but for a rounding of the low, and not added up.
template <class T>
struct FromPi {
  T high;
  T low;
};

/// |high + low|: of its sign only a sine wants to know, in the end.
template <class T>
struct Magnitude {
  T high;
  T low;
};

/// high + low, which only whole numbers multiply.
template <class T>
struct Angle {
  T high;
  T low;
};

/// high + low, where low may be 2^-5 of high: a product's error is 4 2^-53 of what its lows contribute.
template <class T>
struct Rough {
  using Real = T;
  using Root = Cut<T>;
  using ArcTangent = Angle<T>;
  using SmallSine = Cut<T>;
  using SmallCosine = NearOne<T>;
  using Result = Rounded<T>;

  T high;
  T low;

  Rough() = default;
  explicit Rough(T exact) : high(exact), low(0.0) {}
  Rough(T high_part, T low_part) : high(high_part), low(low_part) {}
  explicit Rough(Cut<T> x) : high(x.lead), low(x.rest) {}

  /// x + y exactly, where |x| >= |y|.
  static Rough in_order(T x, T y) {
    const Sum<T> s = ordered_sum(x, y);
    return {s.high, s.low};
  }

  /// Pi times a power of two.
  struct Pi {
    double scale;

    friend Pi scaled(Pi x, double power_of_two) { return {x.scale * power_of_two}; }
    /// For y.high from half of it to twice it, where the high parts subtract exactly (Sterbenz).
    friend FromPi<T> operator-(Pi x, Rough y) {
      return {T(x.scale * 0x1.921fb54442d18p+1) - y.high,
              T(x.scale * 0x1.1a62633145c07p-53) - y.low};
    }
  };
  static Pi pi() { return {1.0}; }

  static Rough sum(T x, T y) {
    const Sum<T> s = two_sum(x, y);
    return {s.high, s.low};
  }
  /// sqrt(x/(2 + x)) for 2^-120 <= x < 1, within 2^-59 of itself; its lead has 24 bits, its rest is at most 2^-22 of it.
  static Cut<T> half_arcsecant_tangent(T x) {
    // With t the estimate and e = 1 - t^2 (2 + x)/x, at most 2^-21.6, the root is t/sqrt(1 - e) = t (1 + e/2 + 3/8 e^2), less than
    // 2^-66 left out. t^2 has 48 bits: x - 2 t^2 is exact (Sterbenz), and so is t^2 times the leading 5 bits of x; the rest of x, at most
    // 2^-4 of it, times t^2 is rounded once, 2^-57 x t^2, of which the root has 2^-58 t^2, t^2 <= 1/3. The reciprocal is off by as
    // much as a float, which its error h mends: e/2 is half (1 + 2 h) within 2^-66, too.
    const TangentEstimate<T> estimate = tangent_estimate(x);
    const T t = estimate.tangent, square = t * t, lead = leading<5>(x);
    const T rest = less_exact(less_exact(x, T(2.0), square), lead, square) - (x - lead) * square;
    const T half = rest * estimate.half_reciprocal;
    const T h = T(0.5) - x * estimate.half_reciprocal;
    const T first = t * half;
    return {t, first + first * ((h + h) + T(1.5) * half)};
  }
  /// (2 + alpha) alpha, or (1 + alpha)^2 where `is_beyond`, which is from alpha = 1 on: within 2^-100.
  template <class Condition>
  static Rough root_argument(T alpha, Condition is_beyond) {
    const Sum<T> s = ordered_sum(select(is_beyond, alpha, T(2.0)), smaller(alpha, T(1.0)));
    const T factor = alpha + where(is_beyond, T(1.0));  // rounded like s.high
    const Sum<T> product = two_product(s.high, factor);
    return {product.high, product.low + s.low * (factor + where(is_beyond, s.high))};
  }

  friend Wide<T> operator*(Rough x, Rough y) {
    const Sum<T> p = two_product(x.high, y.high);
    return {p.high, p.low + (x.high * y.low + x.low * (y.high + y.low))};
  }
  friend Wide<T> squared(Rough x) {
    const Sum<T> p = two_product(x.high, x.high);
    return {p.high, p.low + x.low * (x.high + (x.high + x.low))};
  }
  friend Rough operator*(Rough x, T y) {
    const Sum<T> p = two_product(x.high, y);
    return {p.high, p.low + x.low * y};
  }

  friend Cut<T> parts(Rough x) {
    const T lead = leading<26>(x.high);
    return {lead, (x.high - lead) + x.low};
  }
  template <class Condition>
  friend Rough select(Condition condition, Rough yes, Rough no) {
    return {select(condition, yes.high, no.high), select(condition, yes.low, no.low)};
  }
};

/// y being whole.
template <class T>
[[gnu::always_inline]] inline Rough<T> operator*(Angle<T> x, T y) {
  const T product = x.high * y;
  return {product, product_error_by_whole(x.high, y, product) + x.low * y};
}

template <class T>
[[gnu::always_inline]] inline Magnitude<T> magnitude(FromPi<T> x) {
  return {x.high, x.low};
}

/// As of two Roughs, added up no more than its factors.
template <class T>
[[gnu::always_inline]] inline Rough<T> operator*(Cut<T> x, Rough<T> y) {
  const Wide<T> product = Rough<T>(x) * y;
  return {product.high, product.low};
}

/// Added up, within 2^-73 where the rest of x is 2^-22 of it: all products of leads are exact.
template <class T>
[[gnu::always_inline]] inline Rough<T> operator*(Cut<T> x, T y) {
  const T lead = leading<26>(y);
  return Rough<T>::in_order(x.lead * lead, x.lead * (y - lead) + x.rest * y);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
