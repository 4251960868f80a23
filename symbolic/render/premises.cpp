// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/premises.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "render/formula.hpp"

namespace magicmass::render {
namespace {

using proof::Step;

void collect_names(const Formula& formula, std::set<std::string>& names) {
  if (formula.kind == Formula::Kind::name || formula.kind == Formula::Kind::call)
    names.insert(formula.text);
  for (const Formula& part : formula.parts) collect_names(part, names);
}

/// The names in both sides and in what the kernel compared.
std::set<std::string> names_in(const Step& step) {
  std::set<std::string> names;
  for (const std::string& side : {step.from, step.to}) collect_names(formula(side), names);
  if (const auto statement = read_relation(step.statement)) collect_names(*statement, names);
  return names;
}

class Tree {
public:
  explicit Tree(const std::vector<Step>& all) : all_(all) {
    for (const Step& step : all) by_id_.emplace(step.id, &step);
  }

  void add(const Step& step, std::size_t depth, bool last, const std::vector<bool>& open_above) {
    const std::vector<std::string> below = foundations(step, all_);
    const bool again = !shown_.insert(step.id).second;
    lines_.push_back({step, depth, last, again, !again && !below.empty(), open_above});
    if (again) return;
    std::vector<bool> open = open_above;
    if (depth > 0) open.push_back(!last);
    for (const std::string& id : below) add(*by_id_.at(id), depth + 1, id == below.back(), open);
  }

  std::vector<TreeLine> lines() { return std::move(lines_); }

private:
  const std::vector<Step>& all_;
  std::map<std::string, const Step*> by_id_;
  std::set<std::string> shown_;
  std::vector<TreeLine> lines_;
};

}  // namespace

std::vector<std::string> foundations(const Step& step, const std::vector<Step>& all) {
  const std::set<std::string> names = names_in(step);
  std::vector<std::string> ids;
  for (const Step& earlier : all) {
    if (earlier.id == step.id) break;
    const bool premise =
        std::find(step.premises.begin(), step.premises.end(), earlier.id) != step.premises.end();
    const bool defines =
        earlier.verdict == "definition" && names.contains(formula(earlier.from).text);
    if (premise || defines) ids.push_back(earlier.id);
  }
  return ids;
}

std::vector<TreeLine> premise_tree(const std::vector<Step>& roots, const std::vector<Step>& all) {
  Tree tree(all);
  for (const Step& root : roots) tree.add(root, 0, true, {});
  return tree.lines();
}

std::vector<Step> steps_of_tree(const std::vector<TreeLine>& tree, const std::vector<Step>& all) {
  std::set<std::string> ids;
  for (const TreeLine& line : tree) ids.insert(line.step.id);
  std::vector<Step> steps;
  std::copy_if(all.begin(), all.end(), std::back_inserter(steps),
               [&](const Step& step) { return ids.contains(step.id); });
  return steps;
}

}  // namespace magicmass::render
