// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <string>

namespace counted {

/// Operations made since the last reset, by the names of the headers' comments.
struct Operations {
  int additions = 0, multiplications = 0, divisions = 0, roots = 0, turns = 0, arctangents = 0;
  friend bool operator==(const Operations&, const Operations&) = default;
};
inline Operations made;

/// An exact input or constant.
struct Exact {
  double value;
  explicit Exact(double x) : value(x) {}
  friend Exact operator*(Exact x, Exact y) {
    ++made.multiplications;
    return Exact(x.value * y.value);
  }
  friend bool operator<(Exact x, Exact y) { return x.value < y.value; }
  friend bool operator>(Exact x, Exact y) { return x.value > y.value; }
};

/// A number type as those of magicmass/arithmetic are, that counts what is done with it.
struct Number {
  using Real = Exact;
  double value = 0;

  Number() = default;
  explicit Number(double x) : value(x) {}
  explicit Number(Exact x) : value(x.value) {}
  static Number sum(Exact x, Exact y) { return Number(x) + y; }
  static Number product(Exact x, Exact y) { return Number(x) * y; }
  static Number pi() { return Number(M_PI); }

  friend Number operator-(Number x) { return Number(-x.value); }
  friend Number operator+(Number x, Number y) { return added(x.value + y.value); }
  friend Number operator-(Number x, Number y) { return added(x.value - y.value); }
  friend Number operator+(Number x, Exact y) { return added(x.value + y.value); }
  friend Number operator*(Number x, Number y) { return multiplied(x.value * y.value); }
  friend Number operator*(Number x, Exact y) { return multiplied(x.value * y.value); }
  friend Number scaled(Number x, double scale) { return multiplied(x.value * scale); }
  friend Number reciprocal(Number x) {
    ++made.divisions;
    return Number(1 / x.value);
  }
  friend Number reciprocal_square_root(Number x) {
    ++made.roots;
    return Number(1 / std::sqrt(x.value));
  }
  friend Number arctangent(Number x) {
    ++made.arctangents;
    return Number(std::atan(x.value));
  }
  friend Number half_arcsecant(Exact, Number tangent) { return arctangent(tangent); }
  friend Number select(bool condition, Number yes, Number no) { return condition ? yes : no; }

private:
  static Number added(double x) {
    ++made.additions;
    return Number(x);
  }
  static Number multiplied(double x) {
    ++made.multiplications;
    return Number(x);
  }
};

struct Turned {
  Number sine, cosine;
};
inline Turned sine_cosine(Number x) {
  ++made.turns;
  return {Number(std::sin(x.value)), Number(std::cos(x.value))};
}

}  // namespace counted
