// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/step_names.hpp"

#include <algorithm>
#include <cctype>

#include "derivation/index/paper_labels.hpp"
#include "render/formula.hpp"

namespace magicmass::render {
namespace {

using proof::Step;

/// a_n, c'_n, t_P_n: how the paper spells a(n), c'(n), t_P(n).
std::string paper_spelling(const Formula& left) {
  if (!is_element(left) || left.parts[0].kind != Formula::Kind::name) return "";
  return left.text + "_" + left.parts[0].text;
}

bool has_element(const Formula& part) {
  return is_element(part) || std::any_of(part.parts.begin(), part.parts.end(), has_element);
}

std::string with_primes(std::string name) {
  const std::string word = "_prime";
  const std::size_t at = name.find(word);
  if (at != std::string::npos) name.replace(at, word.size(), "'");
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name;
}

bool is_called(const Step& step, const std::string& symbol) {
  if (step.relation != "=" || symbol.empty()) return false;
  std::string left = step.from;
  left.erase(std::remove(left.begin(), left.end(), ' '), left.end());
  return left == symbol || paper_spelling(formula(step.from)) == symbol;
}

}  // namespace

std::vector<std::string> labels_of(const Step& step) {
  return derivation::split_labels(step.label);
}

std::vector<Step> steps_called(const std::string& name, const std::vector<Step>& all) {
  std::vector<Step> found;
  for (const Step& step : all)
    if (step.id == name) found.push_back(step);
  if (!found.empty()) return found;
  for (const Step& step : all) {
    const auto labels = labels_of(step);
    if (std::find(labels.begin(), labels.end(), name) != labels.end()) found.push_back(step);
  }
  if (!found.empty()) return found;
  const std::string symbol = with_primes(name);
  for (const Step& step : all)
    if (is_called(step, symbol)) found.push_back(step);
  const auto better = [](const Step& x, const Step& y) {
    const auto grade = [](const Step& step) {
      const bool closed = !has_element(formula(step.to));
      return !step.label.empty() ? 0 : step.verdict == "definition" ? 1 : closed ? 2 : 3;
    };
    return grade(x) < grade(y);
  };
  if (found.size() > 1) found = {*std::min_element(found.begin(), found.end(), better)};
  return found;
}

std::vector<std::string> all_names(const std::vector<Step>& all) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  };
  for (const Step& step : all) {
    add(step.id);
    for (const std::string& label : labels_of(step)) add(label);
    const Formula left = formula(step.from);
    add(paper_spelling(left));
    if (left.kind == Formula::Kind::name) add(left.text);
  }
  return names;
}

}  // namespace magicmass::render
