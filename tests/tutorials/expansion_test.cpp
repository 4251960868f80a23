// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/expansion.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "course/refusal.hpp"

using namespace magicmass::course;
using Catch::Matchers::Contains;

namespace {

Chapter chapter(const std::string& text) {
  Chapter result;
  result.folder = "01_small";
  result.name = "01_small";
  result.title = "Small";
  result.text = text;
  result.program = "int main() {}\n";
  result.printed = {{.name = "answer", .value = "-7"},
                    {.name = "rows", .lines = {"n | a(n)", "1 | 3/4"}, .is_block = true}};
  return result;
}

Surroundings surroundings() {
  magicmass::proof::Step step{.id = "contact.relative",
                              .rule = "",
                              .from = "a(n)",
                              .relation = "=",
                              .to = "b(n) + 1",
                              .conditions = {},
                              .label = "",
                              .words = "",
                              .verdict = "proved",
                              .premises = {}};
  magicmass::proof::Step unreadable = step;
  unreadable.id = "contact.unreadable";
  unreadable.from = "([";
  return {by_id({step, unreadable}),
          {{"02_next", "The next one"}},
          "/bin/true",
          [](const Chapter&, const std::string&, const std::string& name) {
            return "<img alt=\"" + name + "\"/>";
          }};
}

const std::string uses_all = "\n{{answer}}\n{{rows}}\n";

std::string text_of(const std::string& text) {
  return expanded(chapter(text + uses_all), surroundings());
}

std::string refusal_of(const std::string& text) {
  try {
    return "accepted: " + expanded(chapter(text), surroundings());
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
}

}  // namespace

TEST_CASE("values, tables, theorems, terms and links come from elsewhere", "[exam]") {
  CHECK_THAT(text_of(""), Contains("<span class=\"value\">−7</span>"));
  CHECK_THAT(text_of(""), Contains("<td>3/4</td>"));
  CHECK_THAT(text_of("{{theorem:contact.relative}}"), Contains("derivation.html#contact.relative"));
  CHECK_THAT(text_of("so {{right:contact.relative}} it is"), Contains("<mn>1</mn>"));
  CHECK_THAT(text_of("the velocity $a(n)$."), Contains("<msub>") && Contains(".</span>"));
  CHECK_THAT(text_of("see {{chapter:02_next}}"), Contains("[The next one](02_next.html)"));
  CHECK_THAT(text_of("{{program}}"), Contains("int main() {}"));
  CHECK_THAT(text_of("{{figure:counts}} A\nstaircase.\n"),
             Contains("<figcaption>") && Contains("A staircase."));
}

TEST_CASE("numbers may stand in code, in links, in terms and before the items of a list",
          "[exam]") {
  CHECK_THAT(text_of("1. `count --alpha 0.5`, [here](02_next.html), $n + 1$"),
             Contains("count --alpha 0.5"));
  CHECK_THAT(text_of("```\nmagicmass count --alpha 0.5\n```"), Contains("--alpha 0.5"));
}

TEST_CASE("a text that drifted from its program is refused", "[exam]") {
  CHECK(refusal_of("\n{{anser}}" + uses_all) ==
        "01_small/intro.md:3: the program prints nothing called anser");
  CHECK(refusal_of("{{rows}}") ==
        "01_small/intro.md: does not use {{answer}}, which the program prints");
  CHECK_THAT(refusal_of("it is 0.236" + uses_all),
             Contains("intro.md:2: a number is typed: \"0.236"));
  CHECK_THAT(refusal_of("## The 3 bodies" + uses_all), Contains("a number is typed"));
  CHECK_THAT(refusal_of("inline {{rows}}" + uses_all), Contains("put it on a line of its own"));
}

TEST_CASE("a formula that nothing proves is refused", "[exam]") {
  CHECK_THAT(refusal_of("{{theorem:contact.relativ}}"),
             Contains("no theorem is called contact.relativ"));
  CHECK_THAT(refusal_of("$a(n) = b(n)$"), Contains("claims something"));
  CHECK_THAT(refusal_of("$a(n$"), Contains("not in the derivation's notation"));
  CHECK_THAT(refusal_of("{{theorem:contact.unreadable}}"),
             Contains("cannot be shown as a formula"));
}

TEST_CASE("references that lead nowhere are refused", "[exam]") {
  CHECK_THAT(refusal_of("{{chapter:03_none}}"), Contains("no chapter is called 03_none"));
  CHECK_THAT(refusal_of("{{sound:bang}}"), Contains("of no known kind"));
  CHECK_THAT(refusal_of("{{run:rm -r x}}"), Contains("must begin with"));
  CHECK_THAT(refusal_of("{{answer"), Contains("without }}"));
  CHECK_THAT(refusal_of("so $a(n) it is"), Contains("$ without $"));
}
