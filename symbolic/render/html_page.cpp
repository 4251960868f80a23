// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "render/chapter_words.hpp"
#include "render/derivation_pages.hpp"
#include "render/formula_mathml.hpp"
#include "render/html_frame.hpp"
#include "render/rule_words.hpp"
#include "render/steps.hpp"

namespace magicmass::render {
namespace {

std::string link(const std::string& id, const std::vector<proof::Step>& page) {
  const bool here =
      std::any_of(page.begin(), page.end(), [&](const proof::Step& step) { return step.id == id; });
  const std::string code = "<code>" + html_escaped(id) + "</code>";
  return here ? fmt::format("<a href=\"#{}\">{}</a>", html_escaped(id), code) : code;
}

std::string fact(const std::string& name, const std::string& value) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, value);
}

std::string step_html(const proof::Step& step, const std::vector<proof::Step>& page) {
  const std::string id = html_escaped(step.id);
  const std::string verdict = html_escaped(step.verdict);
  std::string text = fmt::format(
      "<section class=\"step\" id=\"{0}\">\n<h3><a href=\"#{0}\">{0}</a> <span class=\"verdict "
      "{1}\">{1}</span></h3>\n",
      id, verdict);
  if (!step.words.empty()) text += "<p>" + html_prose(step.words) + "</p>\n";
  text += "<div class=\"equation\">" + mathml_display(equation(step.from, step.relation, step.to)) +
          "</div>\n<dl>\n";
  std::string conditions;
  for (const std::string& condition : step.conditions)
    conditions += (conditions.empty() ? "" : "; ") + html_prose(condition);
  if (!conditions.empty()) text += fact("if", conditions);
  if (!step.label.empty()) text += fact("paper", "<code>" + html_escaped(step.label) + "</code>");
  text += fact("by", html_prose(rule_words(step.rule)));
  std::string premises;
  for (const std::string& premise : step.premises)
    premises += (premises.empty() ? "" : ", ") + link(premise, page);
  if (!premises.empty()) text += fact("from", premises);
  return text + "</dl>\n</section>\n";
}

std::string tree_html(const std::vector<TreeLine>& tree, const std::vector<proof::Step>& page) {
  std::string text = "<section id=\"tree\">\n<h2>What it rests on</h2>\n<div class=\"scroll\">\n";
  std::size_t depth = 0;
  bool first = true;
  for (const TreeLine& line : tree) {
    if (first || line.depth > depth) {
      text += "<ul class=\"tree\">\n";
    } else {
      for (; depth > line.depth; --depth) text += "</li>\n</ul>\n";
      text += "</li>\n";
    }
    first = false;
    depth = line.depth;
    text += "<li>" + link(line.step.id, page);
    if (line.step.verdict != "proved") text += " (" + html_escaped(line.step.verdict) + ")";
    if (line.seen)
      text += ", see above";
    else
      text += ": " + mathml(equation(line.step.from, line.step.relation, line.step.to));
  }
  for (std::size_t level = 0; level <= depth && !tree.empty(); ++level) text += "</li>\n</ul>\n";
  return text + "</div>\n</section>\n";
}

}  // namespace

std::string derivation_html(const std::vector<proof::Step>& steps,
                            const std::vector<TreeLine>& tree) {
  std::vector<PageChapter> chapters;
  if (!tree.empty()) chapters.push_back({"tree", "What it rests on"});
  std::string body = tree.empty() ? "" : tree_html(tree, steps);
  std::string chapter;
  for (const proof::Step& step : steps) {
    if (chapter_of(step) != chapter) {
      if (!chapter.empty()) body += "</section>\n";
      chapter = chapter_of(step);
      const ChapterWords words = chapter_words(chapter);
      chapters.push_back({"chapter-" + chapter, words.title});
      body += fmt::format("<section class=\"chapter\" id=\"chapter-{}\">\n<h2>{}</h2>\n",
                          html_escaped(chapter), html_escaped(words.title));
      if (!words.introduction.empty()) body += "<p>" + html_prose(words.introduction) + "</p>\n";
    }
    body += step_html(step, steps);
  }
  if (!chapter.empty()) body += "</section>\n";
  return html_page("Magic mass ratios: the derivation", chapters, body);
}

}  // namespace magicmass::render
