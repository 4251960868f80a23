// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "render/chapter_words.hpp"
#include "render/derivation_pages.hpp"
#include "render/formula_latex.hpp"
#include "render/formula_mathml.hpp"
#include "render/html_frame.hpp"
#include "render/markdown.hpp"
#include "render/step_names.hpp"
#include "render/steps.hpp"
#include "render/theorem_index.hpp"
#include "render/wrapping.hpp"

namespace magicmass::render {
namespace {

using proof::Step;

constexpr const char* theorems_title = "Theorems";
constexpr const char* equations_title = "The paper's equations";
constexpr const char* text_title = "What the paper says in its text";
constexpr const char* beyond_title = "Beyond the paper";

std::string joined(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string title(const std::string& words, const TextStyle& style) {
  std::string text = words + "\n";
  for (std::size_t i = 0; i < words.size(); ++i) text += style.unicode ? "═" : "=";
  return text + "\n";
}

/// A name and what belongs to it, side by side; below it where the name is long.
std::string entry(const std::string& name, const std::string& words) {
  constexpr std::size_t room = 34;
  if (words.empty()) return name + "\n";
  if (name.size() + 2 > room) return name + "\n" + wrapped(words, std::string().append(room, ' '));
  return wrapped(words, name + std::string().append(room - name.size(), ' '));
}

/// What the theorem is to the paper: its labels, else nothing; and its verdict where that is not "proved".
std::string standing(const Step& step) {
  const std::string verdict = step.verdict == "proved" ? "" : "(" + step.verdict + ")";
  const std::string labels = joined(labels_of(step));
  return labels + (labels.empty() || verdict.empty() ? "" : " ") + verdict;
}

std::string proof_of(const IndexedEquation& indexed) {
  const std::string theorems = joined(indexed.theorems);
  const std::string more = remark(indexed);
  return theorems + (theorems.empty() || more.empty() ? "" : "; ") + more;
}

std::string statement(const Step& step) {
  return latex(equation(step.from, step.relation, step.to));
}

std::string codes(const std::vector<std::string>& names) {
  return names.empty() ? "" : fmt::format("`{}`", fmt::join(names, "`, `"));
}

std::string html_codes(const std::vector<std::string>& names, bool links) {
  std::string text;
  for (const std::string& name : names) {
    const std::string code = "<code>" + html_escaped(name) + "</code>";
    text += text.empty() ? "" : ", ";
    text += links ? fmt::format("<a href=\"#{}\">{}</a>", html_escaped(name), code) : code;
  }
  return text;
}

}  // namespace

std::string index_text(const TheoremIndex& index, const TextStyle& style) {
  std::string text = title(theorems_title, style);
  std::string chapter;
  for (const Step& step : index.steps) {
    if (chapter_of(step) != chapter) {
      chapter = chapter_of(step);
      text += "\n" + chapter_words(chapter).title + "\n";
    }
    text += entry("  " + step.id, standing(step));
  }
  text += "\n" + title(equations_title, style);
  std::string place;
  for (const IndexedEquation& indexed : index.equations) {
    if (indexed.equation.place != place) {
      place = indexed.equation.place;
      text += "\n" + place + "\n";
    }
    text += entry("  " + std::string(indexed.equation.label), proof_of(indexed));
  }
  if (!index.in_the_text.empty()) text += "\n" + title(text_title, style) + "\n";
  for (const IndexedRemark& remark : index.in_the_text)
    text += entry("  " + remark.label, joined(remark.theorems));
  text += "\n" + title(beyond_title, style) + "\n";
  for (const IndexedResult& indexed : index.beyond) {
    const std::string name(indexed.result.name);
    text += entry("  " + name, prose_text(std::string(indexed.result.words), style));
    if (indexed.theorems != std::vector<std::string>{name})
      text += wrapped(joined(indexed.theorems), std::string().append(34, ' '));
  }
  return text;
}

std::string index_markdown(const TheoremIndex& index) {
  std::string text = fmt::format("# Theorem index\n\n## {}\n", theorems_title);
  std::string chapter;
  for (const Step& step : index.steps) {
    if (chapter_of(step) != chapter) {
      chapter = chapter_of(step);
      text += fmt::format("\n### {}\n\n| theorem | states | paper | verdict |\n|---|---|---|---|\n",
                          markdown_escaped(chapter_words(chapter).title));
    }
    text += fmt::format("| `{}` | ${}$ | {} | {} |\n", step.id, statement(step),
                        codes(labels_of(step)), step.verdict);
  }
  text += fmt::format("\n## {}\n\n| equation | where | theorems | remark |\n|---|---|---|---|\n",
                      equations_title);
  for (const IndexedEquation& indexed : index.equations)
    text += fmt::format("| `{}` | {} | {} | {} |\n", indexed.equation.label, indexed.equation.place,
                        codes(indexed.theorems), markdown_escaped(remark(indexed)));
  for (const IndexedRemark& remark : index.in_the_text)
    text += fmt::format("| `{}` | {}, in the text | {} | |\n", remark.label, remark.place,
                        codes(remark.theorems));
  text += fmt::format("\n## {}\n\n", beyond_title);
  for (const IndexedResult& indexed : index.beyond)
    text += fmt::format("- {}: {}\n", markdown_prose(std::string(indexed.result.words)),
                        codes(indexed.theorems));
  return text;
}

std::string index_html(const TheoremIndex& index) {
  std::string body = fmt::format("<section id=\"theorems\">\n<h2>{}</h2>\n", theorems_title);
  std::string chapter;
  for (const Step& step : index.steps) {
    if (chapter_of(step) != chapter) {
      if (!chapter.empty()) body += "</table></div>\n";
      chapter = chapter_of(step);
      body += fmt::format(
          "<h3>{}</h3>\n<div "
          "class=\"scroll\"><table>\n<tr><th>theorem</th><th>states</th><th>paper</th></tr>\n",
          html_escaped(chapter_words(chapter).title));
    }
    std::string labels = html_codes(labels_of(step), false);
    if (step.verdict != "proved")
      labels += (labels.empty() ? "" : " ") + ("(" + html_escaped(step.verdict) + ")");
    body += fmt::format("<tr id=\"{0}\"><td><code>{0}</code></td><td>{1}</td><td>{2}</td></tr>\n",
                        html_escaped(step.id), mathml(equation(step.from, step.relation, step.to)),
                        labels);
  }
  if (!chapter.empty()) body += "</table></div>\n";
  body += fmt::format(
      "</section>\n<section id=\"equations\">\n<h2>{}</h2>\n<div class=\"scroll\"><table>\n"
      "<tr><th>equation</th><th>where</th><th>theorems</th></tr>\n",
      equations_title);
  for (const IndexedEquation& indexed : index.equations) {
    const std::string ids = html_codes(indexed.theorems, true);
    const std::string more = html_escaped(remark(indexed));
    body += fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}</td></tr>\n",
                        html_escaped(indexed.equation.label), html_escaped(indexed.equation.place),
                        ids + (ids.empty() || more.empty() ? "" : "; ") + more);
  }
  for (const IndexedRemark& remark : index.in_the_text)
    body += fmt::format("<tr><td><code>{}</code></td><td>{}, in the text</td><td>{}</td></tr>\n",
                        html_escaped(remark.label), html_escaped(remark.place),
                        html_codes(remark.theorems, true));
  body += fmt::format("</table></div>\n</section>\n<section id=\"beyond\">\n<h2>{}</h2>\n<ul>\n",
                      beyond_title);
  for (const IndexedResult& indexed : index.beyond)
    body += fmt::format("<li>{}: {}</li>\n", html_prose(std::string(indexed.result.words)),
                        html_codes(indexed.theorems, true));
  body += "</ul>\n</section>\n";
  return html_page(
      "Magic mass ratios: the theorems",
      {{"theorems", theorems_title}, {"equations", equations_title}, {"beyond", beyond_title}},
      body);
}

std::string index_json(const TheoremIndex& index) {
  nlohmann::ordered_json theorems = nlohmann::json::array();
  for (const Step& step : index.steps)
    theorems.push_back({{"id", step.id}, {"verdict", step.verdict}, {"labels", labels_of(step)}});
  nlohmann::ordered_json equations = nlohmann::json::array();
  for (const IndexedEquation& indexed : index.equations)
    equations.push_back({{"label", indexed.equation.label},
                         {"place", indexed.equation.place},
                         {"theorems", indexed.theorems},
                         {"remark", remark(indexed)}});
  for (const IndexedRemark& remark : index.in_the_text)
    equations.push_back({{"label", remark.label},
                         {"place", remark.place + ", in the text"},
                         {"theorems", remark.theorems},
                         {"remark", ""}});
  nlohmann::ordered_json beyond = nlohmann::json::array();
  for (const IndexedResult& indexed : index.beyond)
    beyond.push_back({{"name", indexed.result.name},
                      {"words", indexed.result.words},
                      {"theorems", indexed.theorems}});
  const nlohmann::ordered_json all{
      {"theorems", theorems}, {"equations", equations}, {"beyond", beyond}};
  return all.dump(1) + "\n";
}

std::string index_csv(const TheoremIndex& index) {
  const auto quoted = [](const std::string& text) {
    std::string result = "\"";
    for (const char character : text)
      result += character == '"' ? "\"\"" : std::string(1, character);
    return result + "\"";
  };
  std::string text = "label,place,theorems,remark\n";
  for (const IndexedEquation& indexed : index.equations)
    text += fmt::format("{},{},{},{}\n", quoted(std::string(indexed.equation.label)),
                        quoted(std::string(indexed.equation.place)),
                        quoted(fmt::format("{}", fmt::join(indexed.theorems, " "))),
                        quoted(remark(indexed)));
  for (const IndexedRemark& remark : index.in_the_text)
    text += fmt::format("{},{},{},\n", quoted(remark.label), quoted(remark.place + ", in the text"),
                        quoted(fmt::format("{}", fmt::join(remark.theorems, " "))));
  return text;
}

}  // namespace magicmass::render
