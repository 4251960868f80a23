// SPDX-License-Identifier: GPL-2.0-or-later
// Markdown as GitHub and pandoc read it: formulas as LaTeX between dollars.
#include <algorithm>

#include <fmt/format.h>

#include "render/chapter_words.hpp"
#include "render/derivation_pages.hpp"
#include "render/formula_latex.hpp"
#include "render/markdown.hpp"
#include "render/prose.hpp"
#include "render/rule_words.hpp"
#include "render/steps.hpp"

namespace magicmass::render {
namespace {

constexpr double page_room = 44;  // em

/// Without dots, as GitHub makes anchors of headings: power.a_product as powera_product.
std::string anchor(const std::string& id) {
  std::string result = id;
  result.erase(std::remove(result.begin(), result.end(), '.'), result.end());
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char character) {
    return static_cast<char>(std::tolower(character));
  });
  return result;
}

std::string link(const std::string& id, const std::vector<proof::Step>& page) {
  const bool here =
      std::any_of(page.begin(), page.end(), [&](const proof::Step& step) { return step.id == id; });
  return here ? fmt::format("[`{}`](#{})", id, anchor(id)) : "`" + id + "`";
}

std::string step_markdown(const proof::Step& step, const std::vector<proof::Step>& page) {
  std::string text = fmt::format("### {}\n\n", step.id);
  if (!step.words.empty()) text += markdown_prose(step.words) + "\n\n";
  text += fmt::format("$$\n{}\n$$\n\n",
                      latex_display(equation(step.from, step.relation, step.to), page_room));
  if (!step.conditions.empty()) {
    std::string conditions;
    for (const std::string& condition : step.conditions)
      conditions += (conditions.empty() ? "" : "; ") + markdown_prose(condition);
    text += "- if " + conditions + "\n";
  }
  if (!step.label.empty()) text += fmt::format("- paper: `{}`\n", step.label);
  text += fmt::format("- by: {}\n", markdown_prose(rule_words(step.rule)));
  if (!step.premises.empty()) {
    std::string links;
    for (const std::string& id : step.premises)
      links += (links.empty() ? "" : ", ") + link(id, page);
    text += "- from: " + links + "\n";
  }
  return text + fmt::format("- {}\n", step.verdict);
}

std::string tree_markdown(const std::vector<TreeLine>& tree, const std::vector<proof::Step>& page) {
  std::string text = "\n## What it rests on\n\n";
  for (const TreeLine& line : tree) {
    text += std::string().append(2 * line.depth, ' ') + "- " + link(line.step.id, page);
    if (line.step.verdict != "proved") text += " (" + line.step.verdict + ")";
    if (line.seen)
      text += ", see above";
    else
      text += ": $" + latex(equation(line.step.from, line.step.relation, line.step.to)) + "$";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string markdown_escaped(std::string_view text) {
  std::string result;
  for (const char character : text) {
    if (std::string_view("\\`*_[]<>$|#&~").find(character) != std::string_view::npos)
      result += '\\';
    result += character;
  }
  return result;
}

std::string markdown_prose(const std::string& words) {
  std::string text;
  for (const Run& run : prose(words))
    text += run.is_formula ? "$" + latex(run.formula) + "$" : markdown_escaped(run.words);
  return text;
}

std::string derivation_markdown(const std::vector<proof::Step>& steps,
                                const std::vector<TreeLine>& tree) {
  std::string text = "# Derivation\n";
  if (!tree.empty()) text += tree_markdown(tree, steps);
  std::string chapter;
  for (const proof::Step& step : steps) {
    if (chapter_of(step) != chapter) {
      chapter = chapter_of(step);
      const ChapterWords words = chapter_words(chapter);
      text += "\n## " + markdown_escaped(words.title) + "\n";
      if (!words.introduction.empty()) text += "\n" + markdown_prose(words.introduction) + "\n";
    }
    text += "\n" + step_markdown(step, steps);
  }
  return text;
}

}  // namespace magicmass::render
