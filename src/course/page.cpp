// SPDX-License-Identifier: GPL-2.0-or-later
// A frame around what chapters say.
#include "course/chapter.hpp"

namespace course {
namespace {

using render::html_text;

std::string link(const std::string& to, const std::string& words,
                 const std::string& attributes = "") {
  return "<a href=\"" + to + "\"" + attributes + ">" + words + "</a> ";
}
std::string frame(const std::string& title, const std::string& top, const std::string& main,
                  const std::string& bottom = "") {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
         html_text(title) +
         "</title>\n<link rel=\"stylesheet\" href=\"course.css\">\n</head>\n<body>\n" +
         link("#main", "To the text", " class=\"skip\"") + "\n<header><nav aria-label=\"Course\">" +
         top + "</nav></header>\n<main id=\"main\">\n" + main + "</main>\n" + bottom +
         "</body>\n</html>\n";
}

}  // namespace

Texts files_of(const std::vector<Page>& chapters, const std::string& welcome,
               const std::string& proofs) {
  const std::string title = "Magic mass ratios";
  const std::string contents = link("index.html", title);
  const std::string all_proofs = link("derivation.html", "All proofs");
  Texts files;
  std::string list, list_on_paper, all;
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    const Page& page = chapters[i];
    const std::string name = html_text(page.title);
    const std::string text = "<p class=\"place\">Chapter " + std::to_string(i + 1) + " of " +
                             std::to_string(chapters.size()) + "</p>\n<h1 id=\"" + page.name +
                             "\">" + name + "</h1>\n" + page.body;
    const auto turn = [&](std::size_t to, const std::string& words, const std::string& attributes) {
      return to >= chapters.size() ? ""
                                   : link(chapters[to].name + ".html",
                                          words + html_text(chapters[to].title), attributes);
    };
    files[page.name + ".html"] =
        frame(page.title, contents + all_proofs, text,
              "<nav class=\"turn\" aria-label=\"Previous and next\">" +
                  turn(i - 1, "← ", " rel=\"prev\"") +
                  turn(i + 1, "→ ", " rel=\"next\" class=\"next\"") + "</nav>\n");
    list += "<li>" + link(page.name + ".html", name) + "</li>\n";
    list_on_paper += "<li>" + link("#" + page.name, name) + "</li>\n";
    all += "<section class=\"chapter\">\n" + text + "</section>\n";
  }
  const std::string first = "<h1>" + title + "</h1>\n" + welcome + "<h2>Chapters</h2>\n<ol>\n";
  files["index.html"] = frame(title, all_proofs, first + list + "</ol>\n");
  files["course.html"] = frame(title, "", first + list_on_paper + "</ol>\n" + all);
  files["derivation.html"] = frame("All proofs", contents, "<h1>All proofs</h1>\n" + proofs);
  return files;
}

}  // namespace course
