// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "equality/parse.hpp"

namespace magicmass::equality {

/// The values that one symbol may take: an interval, all of it or the integers in it.
struct Range {
  bool is_integer = false;         ///< the integers in the interval alone
  std::optional<cln::cl_RA> low;   ///< none: minus infinity
  std::optional<cln::cl_RA> high;  ///< none: infinity
  bool has_low = false;            ///< the lower end belongs to it
  bool has_high = false;           ///< the upper end belongs to it

  /// Whether it has this value.
  bool contains(const cln::cl_RA& value) const;
  /// Whether it has none.
  bool is_empty() const;
};

std::string to_text(const std::string& name,
                    const Range& range);  ///< "0 < alpha <= 1", "n integer, n >= 1"

/// Where two expressions are compared: a range for each symbol, and what else was asked for ("alpha < beta").
struct Domain {
  std::map<std::string, Range> ranges;  ///< of every symbol
  std::vector<Comparison> further;      ///< conditions on more than one symbol
};

/// Conditions, each a list with commas: "0 < alpha", "alpha <= 1, n integer", "x real". A bound replaces the usual
/// one on its side; "x real" and "n integer" replace all that is usual for the symbol. Throws NotAnExpression.
Domain parse_domain(const std::vector<std::string>& conditions,
                    const std::set<std::string>& symbols, const Limits& limits = {});

/// One text a range and a condition, as parse_domain reads them.
std::vector<std::string> to_texts(const Domain& domain);

/// Values of a range to try, the simplest first.
std::vector<cln::cl_RA> simple_values(const Range& range, std::size_t count);

}  // namespace magicmass::equality
