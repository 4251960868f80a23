// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/domain.hpp"

#include <algorithm>

#include <cln/integer.h>

#include "equality/paper_names.hpp"

namespace magicmass::equality {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::string> separated(const std::string& text) {  // at commas outside parentheses
  std::vector<std::string> parts{""};
  int depth = 0;
  for (const char character : text) {
    depth += character == '(' ? 1 : character == ')' ? -1 : 0;
    if (character == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += character;
  }
  return parts;
}

// "n integer" and "x real": (name, kind).
std::optional<std::pair<std::string, std::string>> kind_of_symbol(const std::string& condition,
                                                                  const Limits& limits) {
  for (const char* kind : {" integer", " real"}) {
    if (!condition.ends_with(kind)) continue;
    const std::string name = condition.substr(0, condition.size() - std::string(kind).size());
    const Tree tree = parse(name, limits);
    if (tree->kind != Kind::symbol)
      throw NotAnExpression("\"" + condition + "\": a symbol is expected before" + kind);
    return std::pair{tree->name, std::string(kind + 1)};
  }
  return std::nullopt;
}

std::string turned_round(const std::string& relation) {
  if (relation == "<") return ">";
  if (relation == ">") return "<";
  if (relation == "<=") return ">=";
  if (relation == ">=") return "<=";
  return relation;
}

void set_bound(Range& range, const std::string& relation, const cln::cl_RA& value) {
  if (relation == "<" || relation == "<=") {
    range.high = value;
    range.has_high = relation == "<=";
  } else {
    range.low = value;
    range.has_low = relation == ">=";
  }
}

// A bound from the command line, or false where the comparison is no bound of one symbol.
bool bound(Comparison comparison, Domain& domain, Domain& given) {
  if (comparison.right->kind == Kind::symbol) {
    std::swap(comparison.left, comparison.right);
    comparison.relation = turned_round(comparison.relation);
  }
  const auto& [left, relation, right] = comparison;
  if (left->kind != Kind::symbol || !is_number(right)) return false;
  if (relation == "=" || relation == "!=") return false;
  const bool is_high = relation[0] == '<';
  Range& seen = given.ranges[left->name];
  std::optional<cln::cl_RA>& before = is_high ? seen.high : seen.low;
  const bool closed = relation.size() == 2;
  const bool had = is_high ? seen.has_high : seen.has_low;
  // of several bounds on one side the strictest counts
  if (before && (is_high ? *before < right->value : *before > right->value)) return true;
  if (before && *before == right->value && !had) return true;
  before = right->value;
  (is_high ? seen.has_high : seen.has_low) = closed;
  set_bound(domain.ranges.at(left->name), relation, right->value);
  return true;
}

void apply_usual(const std::string& name, Domain& domain, const Limits& limits) {
  Range range;
  for (const std::string& part : separated(usual_condition(name))) {
    const std::string condition = trimmed(part);
    if (condition.empty()) continue;
    if (const auto kind = kind_of_symbol(condition, limits)) {
      range.is_integer = kind->second == "integer";
      continue;
    }
    for (const Comparison& comparison : parse_comparisons(condition, limits)) {
      if (comparison.left->kind == Kind::symbol)
        set_bound(range, comparison.relation, comparison.right->value);
      else
        set_bound(range, turned_round(comparison.relation), comparison.left->value);
    }
  }
  domain.ranges[name] = range;
}

void require_symbol(const std::string& name, const std::string& condition, const Domain& domain) {
  if (meaning(name))
    throw NotAnExpression("\"" + condition + "\": " + name +
                          " is defined by other symbols; set those");
  if (!domain.ranges.contains(name))
    throw NotAnExpression("\"" + condition + "\": " + name + " is in neither expression");
}

}  // namespace

bool Range::contains(const cln::cl_RA& value) const {
  if (is_integer && !equality::is_integer(value)) return false;
  if (low && (value < *low || (value == *low && !has_low))) return false;
  return !(high && (value > *high || (value == *high && !has_high)));
}

bool Range::is_empty() const {
  if (!low || !high) return false;
  if (!is_integer) return *low > *high || (*low == *high && !(has_low && has_high));
  cln::cl_I first = cln::ceiling1(*low);
  if (first == *low && !has_low) first = first + 1;
  return !contains(first);
}

std::string to_text(const std::string& name, const Range& range) {
  const auto shown = [](const cln::cl_RA& value) { return equality::to_text(number(value)); };
  std::string bounds;
  if (range.low && range.high)
    bounds = shown(*range.low) + (range.has_low ? " <= " : " < ") + name +
             (range.has_high ? " <= " : " < ") + shown(*range.high);
  else if (range.low)
    bounds = name + (range.has_low ? " >= " : " > ") + shown(*range.low);
  else if (range.high)
    bounds = name + (range.has_high ? " <= " : " < ") + shown(*range.high);
  if (range.is_integer) return name + " integer" + (bounds.empty() ? "" : ", " + bounds);
  return bounds.empty() ? name + " real" : bounds;
}

Domain parse_domain(const std::vector<std::string>& conditions,
                    const std::set<std::string>& symbols, const Limits& limits) {
  Domain domain;
  Domain given;
  for (const std::string& name : symbols) apply_usual(name, domain, limits);
  std::vector<std::string> all;
  for (const std::string& list : conditions)
    for (const std::string& part : separated(list)) all.push_back(trimmed(part));
  if (all.size() > 50) throw NotAnExpression("more than 50 conditions");
  std::vector<std::pair<std::string, Comparison>> comparisons;
  for (const std::string& condition : all) {
    if (condition.empty()) throw NotAnExpression("an empty condition; write for example 0 < alpha");
    try {
      if (const auto kind = kind_of_symbol(condition, limits)) {
        require_symbol(kind->first, condition, domain);
        Range all_of_them;
        all_of_them.is_integer = kind->second == "integer";
        domain.ranges[kind->first] = all_of_them;
        continue;
      }
      for (const Comparison& comparison : parse_comparisons(condition, limits))
        comparisons.emplace_back(condition, comparison);
    } catch (const NotAnExpression& error) {
      if (std::string(error.what()).starts_with('"')) throw;
      throw NotAnExpression("\"" + condition.substr(0, 60) + "\": " + error.what());
    }
  }
  for (const auto& [condition, comparison] : comparisons) {
    for (const Tree& side : {comparison.left, comparison.right})
      for (const std::string& name : symbols_of(side)) require_symbol(name, condition, domain);
    if (!bound(comparison, domain, given)) domain.further.push_back(comparison);
  }
  for (const auto& [name, range] : domain.ranges)
    if (range.is_empty())
      throw NotAnExpression("no value of " + name + " satisfies " + to_text(name, range));
  return domain;
}

std::vector<std::string> to_texts(const Domain& domain) {
  std::vector<std::string> result;
  for (const auto& [name, range] : domain.ranges) result.push_back(to_text(name, range));
  for (const Comparison& comparison : domain.further)
    result.push_back(to_text(comparison.left) + " " + comparison.relation + " " +
                     to_text(comparison.right));
  return result;
}

std::vector<cln::cl_RA> simple_values(const Range& range, std::size_t count) {
  std::vector<cln::cl_RA> values;
  const auto add = [&](const cln::cl_RA& value) {
    if (values.size() < count && range.contains(value) &&
        std::find(values.begin(), values.end(), value) == values.end())
      values.push_back(value);
  };
  const std::vector<cln::cl_RA> small{1, 2, 0, 3};
  for (const cln::cl_RA& value : small) {
    add(value);
    add(-value);
  }
  if (!range.is_integer) {
    for (const long below : {2L, 3L, 4L, 5L})
      for (long above = 1; above < 2 * below; ++above) {
        const cln::cl_RA fraction = cln::cl_RA(above) / below;
        add(fraction);
        add(-fraction);
        if (range.low && range.high && above < below)
          add(*range.low + (*range.high - *range.low) * fraction);
        if (range.low) add(*range.low + fraction);
        if (range.high) add(*range.high - fraction);
      }
  }
  const cln::cl_RA start = range.low    ? cln::cl_RA(cln::ceiling1(*range.low))
                           : range.high ? cln::cl_RA(cln::floor1(*range.high))
                                        : cln::cl_RA(0);
  for (const long step : {0L, 1L, 2L, 3L, 4L, 5L, 6L, 7L, 9L, 11L, 15L, 29L, 99L, 100L, 1000L}) {
    add(start + step);
    add(start - step);
  }
  if (!range.is_integer)
    for (const long below : {10L, 100L, 1000L}) {
      add(cln::cl_RA(1) / below);
      add(cln::cl_RA(-1) / below);
      if (range.low) add(*range.low + cln::cl_RA(1) / below);
      if (range.high) add(*range.high - cln::cl_RA(1) / below);
    }
  return values;
}

}  // namespace magicmass::equality
