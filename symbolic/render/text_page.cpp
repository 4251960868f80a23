// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "render/chapter_words.hpp"
#include "render/derivation_pages.hpp"
#include "render/prose.hpp"
#include "render/rule_words.hpp"
#include "render/steps.hpp"
#include "render/wrapping.hpp"

namespace magicmass::render {
namespace {

std::string chapter_text(const std::string& chapter, const TextStyle& style) {
  const ChapterWords words = chapter_words(chapter);
  const std::string heading = words.title == chapter ? chapter : chapter + ": " + words.title;
  std::string text = heading + "\n";
  for (std::size_t i = 0; i < columns(heading); ++i) text += style.unicode ? "═" : "=";
  text += "\n";
  if (!words.introduction.empty())
    text += "\n" + wrapped(prose_text(words.introduction, style), "");
  return text;
}

std::string step_text(const proof::Step& step, const TextStyle& style) {
  const std::size_t used = step.id.size() + step.verdict.size();
  std::string text = step.id + std::string(used < page_width ? page_width - used : 1, ' ') +
                     verdict_text(step.verdict, style.colourful) + "\n";
  if (!step.words.empty()) text += wrapped(prose_text(step.words, style), "  ");
  text += "\n" + display_text(equation(step.from, step.relation, step.to), style, 4) + "\n";
  std::string conditions;
  for (const std::string& condition : step.conditions)
    conditions += (conditions.empty() ? "" : "; ") + prose_text(condition, style);
  if (!conditions.empty()) text += wrapped(conditions, "  if ");
  if (!step.label.empty()) text += wrapped(step.label, "  paper: ");
  text += wrapped(prose_text(rule_words(step.rule), style), "  by: ");
  if (!step.premises.empty())
    text += wrapped(fmt::format("{}", fmt::join(step.premises, ", ")), "  from: ");
  return text;
}

/// ├─ and └─ before a step, │ below them.
struct Branches {
  std::string first;
  std::string rest;
};

/// `narrow`: a column less a level, for trees that are very deep.
Branches branches(const TreeLine& line, const TextStyle& style, bool narrow) {
  const std::string gap = narrow ? "" : " ";
  const std::string bar = style.unicode ? "│" : "|";
  const std::string dash = narrow ? "" : style.unicode ? "─" : "-";
  Branches result;
  for (const bool open : line.open_above) result.first += (open ? bar : " ") + gap + " ";
  result.rest = result.first;
  if (line.depth > 0) {
    result.first +=
        (line.last ? (style.unicode ? "└" : "`") : (style.unicode ? "├" : "|")) + dash + " ";
    result.rest += (line.last ? " " : bar) + gap + " ";
  }
  if (line.has_below) result.rest += bar;
  return result;
}

/// Lines that all begin with the same, at least 30 columns to the words.
std::string below(const std::string& words, const std::string& prefix) {
  const std::size_t used = columns(prefix);
  std::string text;
  std::string lines = wrapped(words, "", used + 30 < page_width ? page_width - used : 30);
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    text += prefix + lines.substr(begin, end + 1 - begin);
    begin = end + 1;
  }
  return text;
}

}  // namespace

std::string prose_text(const std::string& words, const TextStyle& style) {
  std::string text;
  for (const Run& run : prose(words)) {
    std::string shown =
        run.is_formula && style.unicode ? inline_text(run.formula, style) : run.words;
    if (run.is_formula && columns(shown) <= page_width / 2)
      std::replace(shown.begin(), shown.end(), ' ', held_blank);
    text += shown;
  }
  return text;
}

std::string verdict_text(const std::string& verdict, bool colourful) {
  if (!colourful) return verdict;
  const char* colour = verdict == "proved" ? "32" : verdict == "refused" ? "31" : "36";
  return fmt::format("\x1b[{}m{}\x1b[0m", colour, verdict);
}

std::string derivation_text(const std::vector<proof::Step>& steps, const TextStyle& style) {
  std::string text;
  std::string chapter;
  for (const proof::Step& step : steps) {
    if (chapter_of(step) != chapter) {
      chapter = chapter_of(step);
      text += (text.empty() ? "" : "\n\n") + chapter_text(chapter, style);
    }
    text += "\n" + step_text(step, style);
  }
  return text;
}

std::string tree_text(const std::vector<TreeLine>& tree, const TextStyle& style) {
  std::string text;
  const bool narrow =
      std::any_of(tree.begin(), tree.end(), [](const TreeLine& line) { return line.depth > 14; });
  for (const TreeLine& line : tree) {
    const Branches around = branches(line, style, narrow);
    std::string head = line.step.id;
    if (line.step.verdict != "proved") head += " (" + line.step.verdict + ")";
    if (line.seen) head += ", see above";
    text += around.first + head + "\n";
    if (line.seen) continue;
    const std::string shown =
        inline_text(equation(line.step.from, line.step.relation, line.step.to), style);
    text += below(shown, around.rest + (line.has_below ? "    " : "     "));
  }
  return text;
}

}  // namespace magicmass::render
