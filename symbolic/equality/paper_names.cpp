// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/paper_names.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include <ginac/ginac.h>

#include "derivation/paper.hpp"
#include "equality/from_ginac.hpp"
#include "proof/text.hpp"

namespace magicmass::equality {
namespace {

const std::map<std::string, std::string>& usual_conditions() {
  static const std::map<std::string, std::string> table{
      {"alpha", "alpha > 0"},
      {"V", "V > 0"},
      {"L", "L > 0"},
      {"M", "M > 0"},
      {"m", "m > 0"},
      {"M_A", "M_A > 0"},
      {"M_B", "M_B > 0"},
      {"e", "0 < e <= 1"},
      {"n", "n integer, n >= 1"},
      {"k", "k integer, k >= 1"},
      {"j", "j integer, j >= 0"},
  };
  return table;
}

const proof::Statement* equation_for(const std::string& name) {
  static const derivation::Paper paper = derivation::paper();
  for (const auto& [defined, label] : defined_names())
    if (defined == name) return &paper.at(label);
  return nullptr;
}

/// Letters to insert, delete or replace to make one word the other.
std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

const std::vector<std::pair<std::string, std::string>>& defined_names() {
  static const std::vector<std::pair<std::string, std::string>> names{
      {"psi", "def:psi"},      {"theta", "def:theta"}, {"V_CM", "sec:result, V_CM"},
      {"alpha_k", "exact:ak"}, {"beta_k", "exact:bk"}, {"a_n", "eq:a-final"},
      {"b_n", "eq:b-final"},   {"c_n", "eq:c-final"},  {"c_prime_n", "eq:c'-final"},
  };
  return names;
}

bool is_paper_name(const std::string& name) {
  return usual_conditions().contains(name) ||
         std::any_of(defined_names().begin(), defined_names().end(),
                     [&](const auto& defined) { return defined.first == name; });
}

std::optional<Tree> meaning(const std::string& name) {
  const proof::Statement* equation = equation_for(name);
  if (equation == nullptr) return std::nullopt;
  Tree tree = from_ginac(equation->rhs());
  for (const std::string& inner : symbols_of(tree))  // ends: definitions do not go round in circles
    if (const auto value = meaning(inner)) tree = substituted(tree, inner, *value);
  return tree;
}

std::string meaning_as_printed(const std::string& name) {
  const proof::Statement* equation = equation_for(name);
  return equation == nullptr ? "" : proof::to_text(equation->rhs());
}

std::string usual_condition(const std::string& name) {
  const auto found = usual_conditions().find(name);
  return found == usual_conditions().end() ? "" : found->second;
}

std::string nearest_paper_name(const std::string& name) {
  if (name.size() < 3 || is_paper_name(name)) return {};
  std::vector<std::string> names;
  for (const auto& [known, condition] : usual_conditions()) names.push_back(known);
  for (const auto& [known, label] : defined_names()) names.push_back(known);
  for (const std::string& known : names)
    if (known.size() >= 3 && edit_distance(name, known) <= (known.size() > 4 ? 2U : 1U))
      return known;
  return {};
}

}  // namespace magicmass::equality
