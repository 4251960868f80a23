// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/sampling.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <vector>

#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

constexpr long working_digits = 70;
constexpr long agreeing_digits = 50;

class PrecisionGuard {  // GiNaC's precision is global: put it back
public:
  PrecisionGuard() : before_(GiNaC::Digits) { GiNaC::Digits = working_digits; }
  ~PrecisionGuard() { GiNaC::Digits = before_; }
  PrecisionGuard(const PrecisionGuard&) = delete;
  PrecisionGuard(PrecisionGuard&&) = delete;
  PrecisionGuard& operator=(const PrecisionGuard&) = delete;
  PrecisionGuard& operator=(PrecisionGuard&&) = delete;

private:
  long before_;
};

// What an expression is about, gathered once for all points.
struct Contents {
  std::vector<ex> symbols;  // in the order in which they get their values
  bool sequences = false;

  explicit Contents(const std::vector<ex>& expressions) {
    for (const ex& e : expressions) collect(e);
  }

private:
  std::set<std::string> names_;

  void collect(const ex& e) {
    if (is_a<GiNaC::symbol>(e)) {
      if (!e.is_equal(summation_index()) &&
          names_.insert(ex_to<GiNaC::symbol>(e).get_name()).second)
        symbols.push_back(e);
    } else if (is_a<GiNaC::function>(e)) {
      sequences = sequences || is_sequence(e) || is_family(e);
    }
    for (const ex& part : e) collect(part);
  }
};

class Point {
public:
  Point(const Domain& domain, std::mt19937_64& random) : domain_(domain), random_(random) {}

  void assign(const Contents& contents) {
    for (const ex& symbol : contents.symbols) assign_symbol(symbol);
    has_sequences_ = has_sequences_ || contents.sequences;
  }

  ex value(const ex& e) {
    const ex at_point = e.subs(values_, GiNaC::subs_options::no_pattern);
    if (!has_sequences_) return at_point.evalf();
    GiNaC::exmap sequence_values;
    assign_sequences(at_point, sequence_values);
    return at_point.subs(sequence_values, GiNaC::subs_options::no_pattern).evalf();
  }

  bool holds(const ex& surplus, Relation relation) {
    const ex at_point = value(surplus);
    if (!is_a<numeric>(at_point) || !ex_to<numeric>(at_point).is_real()) return false;
    const bool greater = ex_to<numeric>(at_point).is_positive();
    return relation == Relation::greater ? greater : !greater;
  }

  std::string shown() const {
    std::string result;
    for (const auto& [name, value] : shown_)
      result.append(result.empty() ? "" : ", ").append(name).append(" = ").append(value);
    return result;
  }

private:
  long between(long low, long high) {
    return low + static_cast<long>(random_() % static_cast<unsigned long>(high - low + 1));
  }

  void assign_symbol(const ex& symbol) {
    const std::string name = ex_to<GiNaC::symbol>(symbol).get_name();
    if (shown_.contains(name)) return;
    // Odd over even: never a whole number, so psi is never a rational multiple of pi and no sine in a
    // denominator vanishes by accident (alpha = 1 is the one rational mass ratio where it would).
    numeric value = numeric(2 * between(0, 60) + 1, 2 * between(1, 20));
    if (const auto integer = domain_.integer.find(name); integer != domain_.integer.end())
      value = between(integer->second, integer->second + 9);
    else if (!domain_.positive.contains(name) && between(0, 1) == 1)
      value = -value;
    values_[symbol] = value;
    shown_[name] = to_text(value);
  }

  void assign_sequences(const ex& e, GiNaC::exmap& replacements) {
    if (is_sequence(e) || is_family(e)) {
      const std::string key = to_text(e);
      if (!sequences_.contains(key)) {
        sequences_[key] = numeric(between(-90, 90), between(1, 40));
        shown_[key] = to_text(sequences_[key]);
      }
      replacements[e] = sequences_[key];
    }
    for (const ex& part : e) assign_sequences(part, replacements);
  }

  const Domain& domain_;
  std::mt19937_64& random_;
  GiNaC::exmap values_;
  bool has_sequences_ = false;
  std::map<std::string, ex> sequences_;
  std::map<std::string, std::string> shown_;
};

std::uint64_t hash(const std::string& seed) {  // FNV-1a: the same on every machine
  std::uint64_t value = 14695981039346656037u;
  for (const char character : seed)
    value = (value ^ static_cast<unsigned char>(character)) * 1099511628211u;
  return value;
}

bool agree(const ex& left, const ex& right) {
  if (!is_a<numeric>(left) || !is_a<numeric>(right)) return false;
  const numeric l = ex_to<numeric>(left);
  const numeric r = ex_to<numeric>(right);
  const numeric scale = GiNaC::abs(l) + GiNaC::abs(r) + 1;
  return GiNaC::abs(l - r) <= scale * GiNaC::pow(numeric(10), numeric(-agreeing_digits));
}

std::string shortened(const ex& value) {
  GiNaC::Digits = 20;
  std::ostringstream out;
  out << value.evalf();
  GiNaC::Digits = working_digits;
  return out.str();
}

}  // namespace

std::optional<std::string> counterexample(const ex& lhs, const ex& rhs, const Domain& domain,
                                          const Definitions& definitions, const std::string& seed,
                                          int points) {
  if (is_a<GiNaC::matrix>(lhs) && is_a<GiNaC::matrix>(rhs)) {
    const auto& left = ex_to<GiNaC::matrix>(lhs);
    const auto& right = ex_to<GiNaC::matrix>(rhs);
    if (left.rows() != right.rows() || left.cols() != right.cols())
      return "matrices of different shapes";
    for (unsigned row = 0; row < left.rows(); ++row)
      for (unsigned column = 0; column < left.cols(); ++column)
        if (auto found = counterexample(left(row, column), right(row, column), domain, definitions,
                                        seed, points))
          return "row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1) +
                 ": " + *found;
    return std::nullopt;
  }
  const PrecisionGuard guard;
  std::mt19937_64 random(hash(seed));
  const ex left = definitions.expand_all(lhs);
  const ex right = definitions.expand_all(rhs);
  const Contents sides({left, right});
  struct Assumed {
    ex surplus;
    Contents contents;
    Relation relation;
  };
  std::vector<Assumed> assumed;
  for (const Statement& assumption : domain.assumed) {
    const ex surplus = definitions.expand_all(assumption.lhs() - assumption.rhs());
    assumed.push_back({surplus, Contents({surplus}), assumption.relation()});
  }
  int compared = 0;
  const int tries = domain.assumed.empty() ? 8 * points : 100 * points;
  for (int i = 0; i < tries && compared < points; ++i) {
    Point point(domain, random);
    point.assign(sides);
    try {
      if (!std::all_of(assumed.begin(), assumed.end(), [&](const Assumed& each) {
            point.assign(each.contents);
            return point.holds(each.surplus, each.relation);
          }))
        continue;
      const ex left_value = point.value(left);
      const ex right_value = point.value(right);
      ++compared;
      if (agree(left_value, right_value)) continue;
      const std::string where = point.shown();
      return (where.empty() ? "" : "at " + where + " ") + "the left side is " +
             shortened(left_value) + " and the right side is " + shortened(right_value);
    } catch (const GiNaC::pole_error&) {
      continue;  // a point where a side is not defined says nothing
    } catch (const std::runtime_error&) {
      continue;  // division by zero, likewise
    }
  }
  if (compared == 0) return "no point was found where both sides are defined";
  return std::nullopt;
}

std::optional<std::string> not_small(const ex& function, const ex& terms, const ex& s, int last) {
  const PrecisionGuard guard;
  GiNaC::Digits = 40 * (std::abs(last) + 4);  // the terms cancel
  for (const numeric& point : {numeric(1, 1000000), numeric(1, 100000000)}) {
    const ex rest = ((function - terms) / pow(s, last)).subs(s == point).evalf();
    if (!is_a<numeric>(rest) || GiNaC::abs(ex_to<numeric>(rest)) > numeric(1, 1000))
      return "at sqrt(alpha) = " + to_text(point) + " the sides differ by " + shortened(rest) +
             " sqrt(alpha)^" + std::to_string(last);
  }
  return std::nullopt;
}

}  // namespace magicmass::proof
