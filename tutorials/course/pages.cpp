// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/pages.hpp"

#include <cstdlib>
#include <filesystem>
#include <regex>

#include <fmt/format.h>
#include <unistd.h>

#include "course/refusal.hpp"
#include "course/shell.hpp"
#include "render/formula_mathml.hpp"

namespace magicmass::course {
namespace {

using render::html_escaped;

const char* const course_title = "Magic mass ratios: the course";

std::string frame(const std::string& title, const std::string& top,
                  const std::string& main, const std::string& bottom) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta "
      "charset=\"utf-8\"/>\n<meta "
      "name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/>\n<title>{}</title>\n"
      "<link rel=\"stylesheet\" href=\"course.css\"/>\n</head>\n<body>\n<a "
      "class=\"skip\" "
      "href=\"#text\">Skip to the text</a>\n<header>{}</header>\n<main "
      "id=\"text\">\n{}\n</main>\n{}"
      "</body>\n</html>\n",
      html_escaped(title), top, main, bottom);
}

std::string link(const Page& page, std::size_t number,
                 const std::string& attributes, const std::string& words) {
  return fmt::format("<a href=\"{}.html\"{}>{}{}. {}</a>", html_escaped(page.name),
                     attributes, words, number + 1, html_escaped(page.title));
}

std::string chapter_text(const std::vector<Page>& pages, std::size_t number) {
  const Page& page = pages[number];
  return fmt::format(
      "<p class=\"place\">Chapter {} of {} · about {} minutes</p>\n<h1 "
      "id=\"{}\">{}</h1>\n{}",
      number + 1, pages.size(), page.minutes, html_escaped(page.name),
      html_escaped(page.title), page.body);
}

std::string contents(const std::vector<Page>& pages, bool on_paper) {
  std::string list;
  for (std::size_t i = 0; i < pages.size(); ++i)
    list += fmt::format(
        "<li><a href=\"{}{}{}\">{}</a> <span class=\"place\">{} "
        "minutes</span></li>\n",
        on_paper ? "#" : "", html_escaped(pages[i].name), on_paper ? "" : ".html",
        html_escaped(pages[i].title), pages[i].minutes);
  return "<nav aria-label=\"Chapters\"><ol class=\"contents\">\n" + list +
         "</ol></nav>\n";
}

}  // namespace

std::string chapter_page(const std::vector<Page>& pages, std::size_t number) {
  std::string turn = "<nav class=\"turn\" aria-label=\"Previous and next\">";
  if (number > 0)
    turn += link(pages[number - 1], number - 1, " rel=\"prev\"", "← ");
  if (number + 1 < pages.size())
    turn +=
        link(pages[number + 1], number + 1, " rel=\"next\" class=\"next\"", "→ ");
  turn += "</nav>\n";
  const std::string top = fmt::format(
      "<nav aria-label=\"Course\"><a href=\"index.html\">{}</a> <a "
      "href=\"derivation.html\">All proofs</a></nav>",
      course_title);
  return frame(pages[number].title, top, chapter_text(pages, number), turn);
}

std::string index_page(const std::vector<Page>& pages, const std::string& body,
                       bool has_pdf) {
  return frame(
      course_title,
      "<nav aria-label=\"Course\"><a href=\"derivation.html\">All proofs</a>" +
          std::string(has_pdf ? " <a href=\"course.pdf\">The course as a PDF</a>"
                              : "") +
          "</nav>",
      fmt::format("<h1>{}</h1>\n{}\n<h2>Chapters</h2>\n{}", course_title, body,
                  contents(pages, false)),
      "");
}

std::string whole_page(const std::vector<Page>& pages, const std::string& body) {
  std::string text = fmt::format("<h1>{}</h1>\n{}\n<h2>Chapters</h2>\n{}",
                                 course_title, body, contents(pages, true));
  for (std::size_t i = 0; i < pages.size(); ++i)
    text +=
        "<section class=\"chapter\">\n" + chapter_text(pages, i) + "</section>\n";
  return frame(course_title, "", text, "");
}

std::string proofs_page(std::string derivation) {
  const std::string start = "<header>\n";
  const std::size_t at = derivation.find(start);
  if (at == std::string::npos)
    throw Refusal("the derivation's page has no place for a link to the course");
  return derivation.insert(
      at + start.size(),
      fmt::format(
          "<nav aria-label=\"Course\"><a href=\"index.html\">{}</a></nav>\n",
          course_title));
}

std::string html_of(const std::string& markdown, const std::string& id_prefix) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("magicmass_course_" + std::to_string(getpid()) + ".md");
  write(file, markdown);
  const Ran ran =
      run("pandoc --from markdown-smart --to html5 --wrap=preserve --id-prefix=" +
          quoted(id_prefix) + " " + quoted(file.string()));
  std::filesystem::remove(file);
  if (ran.status != 0) throw Refusal("pandoc could not turn Markdown into HTML");
  // what scrolls must be reached by the keyboard
  return std::regex_replace(ran.output, std::regex("<pre"), "<pre tabindex=\"0\"");
}

}  // namespace magicmass::course
