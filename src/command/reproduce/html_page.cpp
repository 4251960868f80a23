// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/reproduce/pages.hpp"
#include "render/formula_mathml.hpp"
#include "render/html_frame.hpp"

namespace magicmass::command {
namespace {

using render::html_escaped;

std::string anchor(std::size_t section) { return fmt::format("numbers-{}", section + 1); }

/// Differences are marked by weight, not by colour alone.
std::string verdict_cell(const Comparison& row) {
  const std::string text = html_escaped(verdict(row));
  return match(row) == Match::differs ? "<strong>" + text + "</strong>" : text;
}

std::string table(const ComparisonSection& section, std::size_t index) {
  std::string text = fmt::format(
      "<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n<div class=\"scroll\" role=\"region\" "
      "aria-label=\"{}\" tabindex=\"0\"><table>\n<thead><tr><th scope=\"col\">quantity</th>"
      "<th scope=\"col\">paper</th><th scope=\"col\">ours</th><th scope=\"col\">verdict</th>"
      "<th scope=\"col\">label</th></tr></thead>\n<tbody>\n",
      anchor(index), html_escaped(section.title), html_escaped(section.words),
      html_escaped(section.title));
  for (const Comparison& row : section.rows) {
    const std::string why = reason(row);
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}{}</td><td style=\"white-space: "
        "nowrap\"><code>{}</code></td></tr>\n",
        html_escaped(row.quantity), row.paper.empty() ? "–" : html_escaped(row.paper),
        html_escaped(row.ours), verdict_cell(row), why.empty() ? "" : ": " + html_escaped(why),
        html_escaped(row.place));
  }
  return text + "</tbody></table></div>\n</section>\n";
}

std::string figure(const ShownFigure& shown) {
  return fmt::format(
      "<figure id=\"{0}\" style=\"margin: 2rem 0\">\n<img src=\"{0}.svg\" alt=\"{2}\" "
      "style=\"max-width: 100%; height: auto; background: #ffffff\"/>\n<figcaption>{1}: "
      "<a href=\"{0}.svg\">SVG</a>, <a href=\"{0}.png\">PNG</a>, <a href=\"{0}.pdf\">PDF</a>, "
      "<a href=\"{0}.csv\">data</a>{3}</figcaption>\n</figure>\n",
      shown.name, html_escaped(shown.title), html_escaped(shown.description),
      shown.name == "cradle" ? ", <a href=\"cradle.html\">in motion</a>" : "");
}

}  // namespace

std::string reproduction_html(const std::vector<ComparisonSection>& sections,
                              const std::vector<ShownFigure>& figures) {
  std::vector<render::PageChapter> chapters;
  std::string body =
      "<p>Quoted numbers are those of Ee and Lee, "
      "<cite>Magic mass ratios of complete energy-momentum transfer in one-dimensional elastic "
      "three-body collisions</cite>, under the labels of its source; ours come from the "
      "evaluators, "
      "exact counts and the event engine.</p>\n<p>" +
      html_escaped(tally_text(tally(sections))) +
      ".</p>\n<p>As one table: <a href=\"comparison.csv\">comparison.csv</a>.</p>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    chapters.push_back({anchor(i), sections[i].title});
    body += table(sections[i], i);
  }
  chapters.push_back({"figures", "Figures"});
  body += "<h2 id=\"figures\">Figures</h2>\n";
  for (const ShownFigure& shown : figures) body += figure(shown);
  return render::html_page("The paper's numbers and figures, reproduced", chapters, body);
}

}  // namespace magicmass::command
