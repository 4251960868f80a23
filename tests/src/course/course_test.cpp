// SPDX-License-Identifier: GPL-2.0-or-later
// A chapter becomes a page; what would drift from the program or the proofs is refused.
#include "answers/derivation.hpp"
#include "answers/errors.hpp"
#include "catch.hpp"
#include "course/chapter.hpp"
#include "course/page.hpp"
#include "learn/judge.hpp"
#include "refusal.hpp"

using course::Chapter;

namespace {

Chapter small_chapter() {
  return {.name = "01_small",
          .source = "small.md",
          .text =
              "# A *small* chapter\n"
              "## Goal\n"
              "The speed $c'_n$, of $A$. See {{chapter:02_next}}.\n"
              "1. `n = 7` is code\n"
              "## Derivation\n"
              "{{theorem:power.a}}\n\n"
              "{{right:power.a}}\n\n"
              "and {{left:power.a}}, in a line.\n"
              "## Check it yourself\n"
              "It is {{speed}} at last.\n\n"
              "{{table}}\n\n"
              "{{run:magicmass count --alpha 1}}\n\n"
              "{{program}}\n"
              "{{figure:setup}} Three bodies,\n"
              "in a *line*.\n"
              "\n"
              "## Exercises\n"
              "{{exercises}}\n"
              "## Possibilities for extensions\n"
              "<script>alert()</script>\n",
          .program = "int main() { return 1 < 2; }\n",
          .printed =
              "# for the terminal\n"
              "speed: -2e-05\n"
              "table:\n"
              "  a_t | words\n"
              "  1 | two words\n",
          .session = "$ magicmass count --alpha 1\nN_A = 1 & more\n",
          .exercises = {{.id = "x",
                         .title = "How many?",
                         .prompt = "Count *them*, <all> M_1*u_1 of it.\n    double *x;\n\nHow?",
                         .choices = {"so", "not so"}}}};
}
std::string html(const Chapter& chapter) {
  static const course::Surroundings around{answers::derivation_sections(),
                                           {{"02_next", "The next & last"}},
                                           {{"setup", "three \"bodies\""}}};
  return chapter_html(chapter, around);
}
std::string refused(const Chapter& chapter) {
  return refusal<answers::InvalidInput>([&] { html(chapter); });
}
/// With something replaced in its text.
Chapter spoiled(const std::string& what, const std::string& by) {
  Chapter chapter = small_chapter();
  learn::replace_all(chapter.text, what, by);
  return chapter;
}

}  // namespace

TEST_CASE("a chapter becomes HTML in which all that is computed is marked") {
  const std::string page = html(small_chapter());
  for (const std::string part :
       {"<div class=\"theorem\" data-theorem=\"power.a\"><div class=\"equation\"",
        "<a href=\"derivation.html#power.a\">power.a</a>",
        "<math><msubsup><mi>c</mi><mrow><mi>n</mi></mrow><mo>′</mo></msubsup></math>&#x2060;,",
        "of <math><mi>A</mi></math>&#x2060;.", "<a href=\"02_next.html\">The next &amp; last</a>",
        "data-value=\"speed\">−2·10<sup>−5</sup></span>",
        "<th scope=\"col\"><math><msub><mrow><mi>a</mi></mrow>",
        "<td class=\"words\">two words</td>",
        "data-run=\"magicmass count --alpha 1\"><code>$ magicmass count --alpha 1\nN_A = 1 &amp; "
        "more",
        "return 1 &lt; 2;", "<img src=\"figures/setup.svg\" alt=\"three &quot;bodies&quot;\"/>",
        "in a <em>line</em>",
        "<details data-exercise=\"x\"><summary>How many?</summary><p>Count *them*, &lt;all&gt; "
        "M_1*u_1 of it.\n</p>\n"
        "<pre tabindex=\"0\"><code>double *x;\n</code></pre><p>How?\n</p>\n<p>a) so</p>\n<p>b) not "
        "so</p>\n<pre"}) {
    CAPTURE(part);
    CHECK_THAT(page, ContainsSubstring(part));
  }
  CHECK_THAT(page, !ContainsSubstring("<script>") && !ContainsSubstring("{{") &&
                       !ContainsSubstring("\x01"));
  CHECK(title_of(small_chapter()) == "A *small* chapter");
}

TEST_CASE("a text that would drift is refused, with its place") {
  const std::vector<std::vector<std::string>> cases{
      {"at last", "at last, 3 times", "small.md:12: a number is typed: 3 times.; print it"},
      {"{{theorem:power.a}}", "{{theorem:power.b_n}}",
       "small.md:6: no theorem is called power.b_n"},
      {"at last", "some fourteen times", "small.md:12: a number is typed: fourteen tim"},
      {"at last", "twenty-six", "small.md:12: a number is typed: twenty-six"},
      {"at last", "a hundred and six", "small.md:12: a number is typed: hundred and"},
      {"$c'_n$", "$c'_n = a_n$", "small.md:3: $c'_n = a_n$ claims something"},
      {"$c'_n$", "$c'_n +$", "is not in the derivation's notation"},
      {"$A$", "$A", "$ without $"},
      {"{{right:power.a}}", "{{right:contact.law}}", "is no equation"},
      {"{{speed}}", "{{sped}}", "no printed value is called sped"},
      {"{{speed}}", "{{table}}", "{{table}} needs a line of its own"},
      {"{{speed}}", "nothing", "never shown, though printed: speed"},
      {"{{speed}}", "{{sped", "{{ without }}"},
      {"It is {{speed}}", "<!-- {{speed}} -->", "small.md: {{...}} in HTML, which is left out"},
      {"{{speed}}", "{{plot:speed}}", "is of no known kind"},
      {"{{run:magicmass count --alpha 1}}", "", "never shown, though printed: magicmass count"},
      {"--alpha 1}}", "--alpha 2}}",
       "no command of session.txt is called magicmass count --alpha 2"},
      {"figure:setup", "figure:setpu", "no figure is called setpu"},
      {"02_next", "03_next", "no chapter is called 03_next"},
      {"## Exercises", "## Exercise", "its sections (##) must be: Goal, "}};
  for (const auto& one : cases) {
    CAPTURE(one[0], one[1]);
    CHECK_THAT(refused(spoiled(one[0], one[1])), ContainsSubstring(one[2]));
  }
  CHECK(refused(small_chapter()) == "not refused");
  Chapter chapter = spoiled("# A", "A");
  CHECK_THROWS_AS(title_of(chapter), answers::InvalidInput);
  for (const std::string printed : {"words\n", "  indented\n", "a: 1\na: 2\n"}) {
    chapter.printed = printed;
    CHECK_THAT(refused(chapter), ContainsSubstring("small.md:1: the program prints"));
  }
}

TEST_CASE("pages lead to each other") {
  const auto files = course::files_of({{"01_a", "A & B", "<p>a</p>"}, {"02_c", "C", "<p>c</p>"}},
                                      "<p>Begin.</p>", "<p>Proofs.</p>");
  CHECK(files.size() == 5);
  const auto contains = [&](const std::string& name, const std::string& part) {
    return files.at(name).find(part) != std::string::npos;
  };
  CHECK(contains("01_a.html", "<a href=\"02_c.html\" rel=\"next\" class=\"next\">→ C</a>"));
  CHECK_FALSE(contains("01_a.html", "rel=\"prev\""));
  CHECK(contains("02_c.html", "<a href=\"01_a.html\" rel=\"prev\">← A &amp; B</a>"));
  CHECK_FALSE(contains("02_c.html", "rel=\"next\""));
  CHECK(contains("index.html", "<p>Begin.</p>"));
  CHECK(contains("index.html", "<a href=\"02_c.html\">C</a>"));
  CHECK(contains("course.html", "<h1 id=\"02_c\">C</h1>\n<p>c</p>"));
  CHECK(contains("derivation.html", "<p>Proofs.</p>"));
}
