// SPDX-License-Identifier: GPL-2.0-or-later
// Where two expressions are compared: a range for each symbol, and further conditions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <cln/rational.h>

#include "equality/constant.hpp"
#include "notation/typed.hpp"

namespace equality {
struct End {
  cln::cl_RA value;
  bool is_inside = false;  ///< it belongs to the range
};
/// The values that one symbol may take: an interval, all of it or the integers in it.
struct Range {
  bool is_integer = false;
  std::optional<End> low = {};   ///< none: minus infinity
  std::optional<End> high = {};  ///< none: infinity

  /// What is below the end, or above it, no longer belongs to it.
  void cut_below(const End& end);
  void cut_above(const End& end);
  bool contains(const cln::cl_RA& value) const;
  bool is_empty() const;
  bool is_point() const { return low && high && low->value == high->value && contains(low->value); }
};
/// Symbols by name: the order in which terms were made must not decide which point comes first.
struct ByName {
  bool operator()(Expr a, Expr b) const { return a.name() < b.name(); }
};
using Point = std::map<Expr, cln::cl_RA, ByName>;

struct Domain {
  std::map<Expr, Range, ByName> ranges;            ///< of every symbol
  std::vector<notation::Comparison> further = {};  ///< conditions that bound no one symbol
};

/// "0 < alpha <= 1, n integer, n >= 1, x real": with commas, each a comparison or a kind. What is
/// said of a symbol replaces what is usual: alpha, V, L, M, m, M_A, M_B > 0, 0 < e <= 1, n, k >= 1
/// and j >= 0 integers; other symbols are real. Refused (kernel::Refused): a condition on a symbol
/// that is not in `symbols` (but for those that `symbols` could have), one that is empty.
/// `unused`: what it says of absent symbols.
Domain read_domain(const std::string& text, const std::set<std::string>& symbols,
                   std::vector<std::string>& unused);
/// One line a symbol, as read_domain reads them.
std::vector<std::string> texts(const Domain& domain);

/// Points of the domain, the simplest first; fewer than `count` where few are found. After the
/// simple values come those of `terms`: their numbers and what is beside them, where |x - 5000|
/// turns. `is_inside`: fractions first, which lie inside of short intervals, then values far apart.
std::vector<Point> points(const Domain& domain, std::size_t count, const Exprs& terms,
                          bool is_inside = false);
/// Whether it is true of constants; nothing where that is not decided, or where symbols are left.
std::optional<bool> holds(const notation::Comparison& comparison);
/// The term with numbers for the symbols of the point.
Expr at(const Point& point, Expr term);
std::string text(const Point& point);  ///< "alpha = 1/2, n = 3"

/// What a term is at a point.
struct Value {
  std::optional<Ball> ball = {};  ///< nothing: no value, or not certain
  std::string why_none = {};      ///< where it is certain that there is none

  bool is_known() const;  ///< to fifty digits, or that there is none
};
Value value_at(const Point& point, Expr term, int bits = 192);
}  // namespace equality
