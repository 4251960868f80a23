// SPDX-License-Identifier: MIT
// A number type for many numbers at once, whose results are rounded two or three times where a Pair's are hardly more than
// once: each of its operations keeps what the next one needs, and no more.
#pragma once

#include "magicmass/arithmetic/error_free.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A result.
template <class T>
struct Rounded {
  T value;

  friend Rounded operator-(Rounded x) { return {-x.value}; }
  friend Rounded scaled(Rounded x, double power_of_two) { return {x.value * T(power_of_two)}; }
  friend T rounded(Rounded x) { return x.value; }
  template <class Condition>
  friend Rounded select(Condition condition, Rounded yes, Rounded no) {
    return {select(condition, yes.value, no.value)};
  }
  /// 1 - x - factor y. What is taken off 1 is added up first: where it is small, so is what its roundings do.
  friend Rounded rest_of_one(Rounded x, T factor, Rounded y) {
    return {T(1.0) - (x.value + factor * y.value)};
  }
};

/// high + low, a product. Sums are rounded twice: that of the highs, and the whole.
template <class T>
struct Wide {
  T high;
  T low;

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

  NearOne() = default;
  explicit NearOne(T exact) : below(T(1.0) - exact) {}

  friend NearOne squared(NearOne x) {
    NearOne square;
    square.below = x.below * (T(2.0) - x.below);
    return square;
  }
  template <class Condition>
  friend NearOne select(Condition condition, NearOne yes, NearOne no) {
    NearOne chosen;
    chosen.below = select(condition, yes.below, no.below);
    return chosen;
  }
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
  friend Wide<T> squared(Cut x) { return {x.lead * x.lead, x.rest * (x.lead + (x.lead + x.rest))}; }
  friend Cut operator*(Cut x, NearOne<T> y) {
    return {x.lead, x.rest - (x.lead + x.rest) * y.below};
  }
  friend Cut operator*(NearOne<T> x, Cut y) { return y * x; }
  /// Leads subtract exactly where they are within a factor of 2^26. That one has 26 bits and one for each halving from the larger to
  /// the smaller: times 24 bits it is exact down to an eighth, and rounded once below.
  friend Cut operator-(Cut x, Cut y) { return {x.lead - y.lead, x.rest - y.rest}; }
  template <class Condition>
  friend Cut select(Condition condition, Cut yes, Cut no) {
    return {select(condition, yes.lead, no.lead), select(condition, yes.rest, no.rest)};
  }
};

/// pi - x, exactly but for a rounding of the low, and not added up.
template <class T>
struct FromPi {
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
    const T lead = leading_half(x.high);
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

/// Added up, without error even where the low is the larger: the high is a multiple of 2^-53.
template <class T>
[[gnu::always_inline]] inline Rough<T> magnitude(FromPi<T> x) {
  const Sum<T> sum = ordered_sum(x.high, x.low);
  return {magnitude(sum.high), times_sign_of(sum.low, sum.high)};
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
  const T lead = leading_half(y);
  return Rough<T>::in_order(x.lead * lead, x.lead * (y - lead) + x.rest * y);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
