// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/derivation_pages.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "render/steps.hpp"
#include "render/wrapping.hpp"

namespace magicmass::render {
namespace {

std::string chapter_title(const std::string& chapter) {
  return fmt::format("{}\n{}\n", chapter, std::string(chapter.size(), '='));
}

std::string step_text(const proof::Step& step, bool colourful) {
  const std::size_t used = step.id.size() + step.verdict.size();
  std::string text = step.id + std::string(used < page_width ? page_width - used : 1, ' ') +
                     verdict_text(step.verdict, colourful) + "\n";
  text += wrapped(step.words, "  ");
  text += wrapped_equation(step.from, step.relation, step.to, 4);
  if (!step.conditions.empty())
    text += wrapped(fmt::format("{}", fmt::join(step.conditions, "; ")), "  if ");
  if (!step.label.empty()) text += wrapped(step.label, "  paper: ");
  if (!step.premises.empty())
    text += wrapped(fmt::format("{}, from {}", step.rule, fmt::join(step.premises, ", ")), "  by ");
  return text;
}

std::string step_markdown(const proof::Step& step) {
  std::string text =
      fmt::format("### `{}` ({})\n\n{}\n\n```text\n{}```\n", step.id, step.verdict, step.words,
                  wrapped_equation(step.from, step.relation, step.to, 0));
  if (!step.conditions.empty())
    text += fmt::format("\n- if `{}`\n", fmt::join(step.conditions, "`, `"));
  if (!step.label.empty())
    text += fmt::format("{}- paper: `{}`\n", step.conditions.empty() ? "\n" : "", step.label);
  if (!step.premises.empty())
    text += fmt::format("{}- by {}, from `{}`\n",
                        step.conditions.empty() && step.label.empty() ? "\n" : "", step.rule,
                        fmt::join(step.premises, "`, `"));
  return text;
}

}  // namespace

std::string verdict_text(const std::string& verdict, bool colourful) {
  if (!colourful) return verdict;
  const char* colour = verdict == "proved" ? "32" : verdict == "refused" ? "31" : "36";
  return fmt::format("\x1b[{}m{}\x1b[0m", colour, verdict);
}

std::string derivation_text(const std::vector<proof::Step>& steps, bool colourful) {
  std::string text;
  std::string chapter;
  for (const proof::Step& step : steps) {
    if (chapter_of(step) != chapter) {
      chapter = chapter_of(step);
      text += (text.empty() ? "" : "\n") + chapter_title(chapter);
    }
    text += "\n" + step_text(step, colourful);
  }
  return text;
}

std::string derivation_markdown(const std::vector<proof::Step>& steps) {
  std::string text = "# Derivation\n";
  std::string chapter;
  for (const proof::Step& step : steps) {
    if (chapter_of(step) != chapter) {
      chapter = chapter_of(step);
      text += "\n## " + chapter + "\n";
    }
    text += "\n" + step_markdown(step);
  }
  return text;
}

std::string derivation_json(const std::vector<proof::Step>& steps) {
  std::string text;
  for (const proof::Step& step : steps) {
    const nlohmann::ordered_json object{{"id", step.id},
                                        {"rule", step.rule},
                                        {"from", step.from},
                                        {"relation", step.relation},
                                        {"to", step.to},
                                        {"conditions", step.conditions},
                                        {"label", step.label},
                                        {"words", step.words},
                                        {"verdict", step.verdict},
                                        {"premises", step.premises},
                                        {"statement", step.statement}};
    text += (text.empty() ? "[\n" : ",\n") + object.dump();
  }
  return text.empty() ? "[]\n" : text + "\n]\n";
}

}  // namespace magicmass::render
