// SPDX-License-Identifier: GPL-2.0-or-later
// A chapter becomes a page; what would drift from the program or the proofs is refused.
#include "answers/derivation.hpp"
#include "answers/errors.hpp"
#include "catch.hpp"
#include "course/chapter.hpp"
#include "refusal.hpp"
#include "rows.hpp"

using course::Chapter;

namespace {

const Chapter small = course::read_chapter(MAGICMASS_SOURCE "/tests/src/course/small");

std::string html(const Chapter& chapter) {
  static const course::Surroundings around{answers::derivation_sections(),
                                           {{"02_next", "The next & last"}},
                                           {{"setup", "three \"bodies\""}}};
  return title_of(chapter) + chapter_html(chapter, around);
}

}  // namespace

TEST_CASE("a chapter becomes HTML in which all that is computed is marked") {
  const std::string page = html(small);
  CHECK(page.starts_with("A *small* chapter"));
  for (learn::Texts& part : rows_of("src/course/parts.tsv", 1)) {
    learn::replace_all(part[0], "\\n", "\n");
    CHECK_THAT(page, ContainsSubstring(part[0]));
  }
  CHECK_THAT(page, !ContainsSubstring("<script>") && !ContainsSubstring("{{") &&
                       !ContainsSubstring("\x01"));
}

TEST_CASE("a text that would drift is refused, with its place") {
  for (const learn::Texts& row : rows_of("src/course/spoilt.tsv", 3)) {
    Chapter chapter = small;
    for (std::string* text : {&chapter.text, &chapter.printed})
      learn::replace_all(*text, row[0], row[1]);
    CAPTURE(row);
    CHECK_THAT(refusal<answers::InvalidInput>([&] { html(chapter); }), ContainsSubstring(row[2]));
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
