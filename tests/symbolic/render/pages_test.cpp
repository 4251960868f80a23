// SPDX-License-Identifier: GPL-2.0-or-later
// Every page: all steps are on it, it is well-formed, it keeps its width, and foreign characters do no harm.
#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

#include "render/chapter_words.hpp"
#include "render/derivation_pages.hpp"
#include "render/formula_latex.hpp"
#include "render/formula_mathml.hpp"
#include "render/rule_words.hpp"
#include "render/steps.hpp"
#include "render/theorem_index.hpp"
#include "whole_derivation.hpp"
#include "xml_reader.hpp"

using namespace magicmass;
using namespace magicmass::render;

namespace {

const std::vector<proof::Step>& steps() {
  static const std::vector<proof::Step> all = steps_of(whole_derivation());
  return all;
}

proof::Step hostile() {
  proof::Step step;
  step.id = "new.step";
  step.rule = "a rule & that <nobody> knows_$";
  step.from = "<script>";
  step.relation = "=";
  step.to = "50% ${x}_^~\\";
  step.conditions = {"it's & <so> #1"};
  step.label = "eq:<a>&\"b'_$";
  step.words = "words with <b>, & and \\end{document} and 5 $ and a_\\b";
  step.verdict = "refused";
  step.premises = {"no.such_step"};
  return step;
}

std::size_t widest(const std::string& page) {
  std::size_t width = 0;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) width = std::max(width, columns(line));
  return width;
}

bool contains(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("every step, its label and its verdict are on every page", "[exam][shared]") {
  const std::string text = derivation_text(steps(), {.unicode = true});
  const std::string ascii = derivation_text(steps(), {});
  const std::string markdown = derivation_markdown(steps());
  const std::string latex_page = derivation_latex(steps());
  const std::string html = derivation_html(steps());
  const std::string json = derivation_json(steps());
  for (const proof::Step& step : steps()) {
    INFO(step.id);
    CHECK(contains("\n" + text, "\n" + step.id + " "));
    CHECK(contains("\n" + ascii, "\n" + step.id + " "));
    CHECK(contains(markdown, "\n### " + step.id + "\n"));
    CHECK(contains(latex_page, "\\step{" + step.id + "}{" + step.verdict + "}"));
    CHECK(contains(html, "<section class=\"step\" id=\"" + step.id + "\">"));
    CHECK(contains(json, "{\"id\":\"" + step.id + "\""));
    CHECK(rule_words(step.rule) != step.rule);
    CHECK_FALSE(chapter_words(chapter_of(step)).introduction.empty());
    for (const std::string& premise : step.premises)
      CHECK(contains(html, "<a href=\"#" + premise + "\">"));
  }
}

TEST_CASE("text keeps within 80 columns, ASCII within ASCII", "[exam][shared]") {
  for (const TextStyle& style : {TextStyle{.unicode = true}, TextStyle{}}) {
    CHECK(widest(derivation_text(steps(), style)) <= 80);
    CHECK(widest(derivation_summary(steps(), style)) <= 80);
    CHECK(widest(index_text(theorem_index(steps()), style)) <= 80);
    for (const char* id : {"times.s_rational", "ratios.deficient_only", "power.a"}) {
      const auto root = std::find_if(steps().begin(), steps().end(),
                                     [&](const auto& step) { return step.id == id; });
      CHECK(widest(tree_text(premise_tree({*root}, steps()), style)) <= 80);
    }
  }
  const std::string ascii = derivation_text(steps(), {}) + index_text(theorem_index(steps()), {});
  CHECK(std::all_of(ascii.begin(), ascii.end(), [](char character) {
    return character == '\n' || (character >= ' ' && character <= '~');
  }));
}

TEST_CASE("HTML is well-formed XML, small, and asks nothing of a network", "[exam][shared]") {
  const auto tree = premise_tree({steps().back(), steps()[40]}, steps());
  for (const std::string& page :
       {derivation_html(steps()), derivation_html(steps_of_tree(tree, steps()), tree),
        index_html(theorem_index(steps())), derivation_html({hostile()}), derivation_html({})}) {
    CHECK(xml_error(page) == "");
    CHECK(page.size() < 3'000'000);
    for (const char* foreign : {"http:", "https:", "src=", "<script", "@import", "url("})
      CHECK_FALSE(contains(page, foreign));
  }
  CHECK(xml_error("<p><b></p></b>") != "");
  CHECK(xml_error("<p>a & b</p>") != "");
  CHECK(xml_error("<p>a</p><p a=b></p>") != "");
  CHECK(xml_error("<p>open") != "");
}

TEST_CASE("what is not known is shown by its own name, escaped", "[exam]") {
  CHECK(rule_words("a new rule") == "a new rule");
  CHECK(chapter_words("wedge_of_tomorrow").title == "wedge_of_tomorrow");
  CHECK(contains(derivation_html({hostile()}), "a rule &amp; that &lt;nobody&gt; knows_$"));
  CHECK_FALSE(contains(derivation_latex({hostile()}), "and \\end{document}"));
  CHECK(contains(derivation_text({hostile()}, {}), "a rule & that <nobody> knows_$"));
}

TEST_CASE("pages of no steps are pages", "[exam]") {
  CHECK(derivation_text({}, {}).empty());
  CHECK(derivation_json({}) == "[]\n");
  CHECK(contains(derivation_latex({}), "\\end{document}"));
}
