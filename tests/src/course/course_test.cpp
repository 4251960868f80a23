// A chapter becomes a page; what would drift from the program or the proofs is refused.
#include "answers/derivation.hpp"
#include "course/chapter.hpp"
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

TEST_CASE("a chapter becomes HTML in which all that is computed is marked; pages lead to others") {
  auto files = course::files_of({{"01_a", "A & B", "<p>a</p>"}, {"02_c", "C", "<p>c</p>"}},
                                "<p>Begin.</p>", "<p>Proofs.</p>");
  CHECK(files.size() == 5);
  CHECK((files["small"] = html(small)).find('\x01') == std::string::npos);
  for (learn::Texts& row : rows_of("src/course/parts.tsv", 3)) {
    learn::replace_all(row[2], "\\n", "\n");
    CAPTURE(row);
    const bool is_there = files.at(row[0]).find(row[2]) != std::string::npos;
    CHECK(is_there == (row[1] == "has"));
  }
}

TEST_CASE("a text that would drift is refused, with its place") {
  for (const learn::Texts& row : rows_of("src/course/spoilt.tsv", 3)) {
    Chapter chapter = small;
    for (std::string* t : {&chapter.text, &chapter.printed}) learn::replace_all(*t, row[0], row[1]);
    CAPTURE(row);
    CHECK_THAT(refusal<answers::InvalidInput>([&] { html(chapter); }), ContainsSubstring(row[2]));
  }
}
