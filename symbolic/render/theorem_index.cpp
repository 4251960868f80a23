// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/theorem_index.hpp"

#include <algorithm>

#include "render/step_names.hpp"
#include "render/steps.hpp"

namespace magicmass::render {
namespace {

using proof::Step;

std::vector<std::string> theorems_labelled(std::string_view listed,
                                           const std::vector<Step>& steps) {
  std::vector<std::string> ids;
  for (const Step& step : steps) {
    const auto labels = labels_of(step);
    if (std::any_of(labels.begin(), labels.end(),
                    [&](const std::string& label) { return derivation::speaks_of(label, listed); }))
      ids.push_back(step.id);
  }
  return ids;
}

bool is_displayed(std::string_view label) {
  const auto& all = derivation::paper_equations();
  return std::any_of(all.begin(), all.end(), [&](const auto& equation) {
    return derivation::speaks_of(label, equation.label);
  });
}

/// By section, in the paper's order; within one as the derivation comes to them.
std::vector<IndexedRemark> remarks_in_the_text(const std::vector<Step>& steps) {
  std::vector<IndexedRemark> remarks;
  for (const auto& section : derivation::paper_sections()) {
    const std::size_t first = remarks.size();
    for (const Step& step : steps)
      for (const std::string& label : labels_of(step)) {
        if (is_displayed(label) || !derivation::speaks_of(label, section.label)) continue;
        auto remark =
            std::find_if(remarks.begin() + static_cast<std::ptrdiff_t>(first), remarks.end(),
                         [&](const IndexedRemark& each) { return each.label == label; });
        if (remark == remarks.end())
          remark = remarks.insert(remarks.end(), {label, std::string(section.place), {}});
        remark->theorems.push_back(step.id);
      }
  }
  return remarks;
}

bool is_used(const std::string& id, const std::vector<Step>& chapter) {
  return std::any_of(chapter.begin(), chapter.end(), [&](const Step& step) {
    return std::find(step.premises.begin(), step.premises.end(), id) != step.premises.end();
  });
}

std::vector<std::string> theorems_called(std::string_view name, const std::vector<Step>& steps) {
  std::vector<std::string> ids;
  std::vector<Step> chapter;
  for (const Step& step : steps) {
    if (step.id == name) ids.push_back(step.id);
    if (chapter_of(step) == name) chapter.push_back(step);
  }
  for (const Step& step : chapter)
    if (step.verdict == "proved" && step.label.empty() && !is_used(step.id, chapter))
      ids.push_back(step.id);
  return ids;
}

}  // namespace

TheoremIndex theorem_index(const std::vector<Step>& steps) {
  TheoremIndex index{
      .steps = steps, .equations = {}, .in_the_text = remarks_in_the_text(steps), .beyond = {}};
  for (const auto& equation : derivation::paper_equations()) {
    auto theorems = theorems_labelled(equation.label, steps);
    if (theorems.empty() && !equation.same_as.empty())
      theorems = theorems_labelled(equation.same_as, steps);
    index.equations.push_back({equation, std::move(theorems)});
  }
  for (const auto& result : derivation::beyond_the_paper())
    index.beyond.push_back({result, theorems_called(result.name, steps)});
  return index;
}

std::string remark(const IndexedEquation& indexed) {
  if (!indexed.equation.same_as.empty())
    return "the same as " + std::string(indexed.equation.same_as);
  if (!indexed.equation.not_claimed.empty())
    return "not claimed: " + std::string(indexed.equation.not_claimed);
  return indexed.theorems.empty() ? "not proved yet" : "";
}

}  // namespace magicmass::render
