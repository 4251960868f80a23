// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/html_frame.hpp"

#include <fmt/format.h>

#include "render/formula_mathml.hpp"
#include "render/prose.hpp"

namespace magicmass::render {
namespace {

constexpr const char* page_style = R"(
:root { color-scheme: light dark; --ink: #1b1f24; --paper: #ffffff; --quiet: #57606a; --line: #d0d7de;
  --link: #0b4fa8; --box: #f6f8fa; --good: #116329; --bad: #a40e26; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6edf3; --paper: #0d1117; --quiet: #9da7b1; --line: #30363d; --link: #79b8ff; --box: #161b22;
    --good: #7ee787; --bad: #ff9492; }
}
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: var(--paper); font: 1rem/1.55 Georgia, "Times New Roman", serif; }
a { color: var(--link); }
code, .verdict, h3 { font-family: ui-monospace, "DejaVu Sans Mono", Consolas, monospace; }
code { font-size: 0.9em; overflow-wrap: anywhere; }
header, main { max-width: 50rem; margin: 0 auto; padding: 0 1rem; }
nav ol { columns: 16rem; padding-left: 1.5rem; }
h2 { margin-top: 3rem; border-bottom: 1px solid var(--line); }
.step { margin: 1.5rem 0; padding: 0.25rem 1rem 0.5rem; border: 1px solid var(--line); border-radius: 0.5rem; }
.step:target { outline: 2px solid var(--link); }
h3 { display: flex; flex-wrap: wrap; gap: 0.5rem; justify-content: space-between; font-size: 0.95rem; margin: 0.5rem 0; }
h3 a { color: inherit; text-decoration: none; overflow-wrap: anywhere; }
.verdict { font-weight: normal; color: var(--link); }
.verdict.proved { color: var(--good); }
.verdict.refused { color: var(--bad); }
.equation { display: flex; flex-wrap: wrap; align-items: center; gap: 0.5rem 0.4rem; overflow-x: auto;
  padding: 0.75rem; background: var(--box); border-radius: 0.25rem; }
math { font-size: 1.08em; }
.equation > math { max-width: 100%; flex: none; }
dl { margin: 0.75rem 0 0; font-size: 0.9rem; }
dl div { display: flex; gap: 0.75rem; }
dt { flex: 0 0 3rem; color: var(--quiet); font-style: italic; }
dd { margin: 0; min-width: 0; overflow-x: auto; overflow-y: hidden; }
.step p { overflow-x: auto; overflow-y: hidden; }
mtd { padding: 0.3em 0.6em; }
.scroll { overflow-x: auto; }
ul.tree { padding-left: 1.2rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: 0.4rem 0.6rem; border-bottom: 1px solid var(--line); }
td:first-child code { white-space: nowrap; }
@media print { .step { break-inside: avoid; } nav { display: none; } }
)";

}  // namespace

std::string html_prose(const std::string& words) {
  std::string text;
  for (const Run& run : prose(words))
    text += run.is_formula ? mathml(run.formula) : html_escaped(run.words);
  return text;
}

std::string html_page(const std::string& title, const std::vector<PageChapter>& chapters,
                      const std::string& body) {
  std::string contents;
  for (const PageChapter& chapter : chapters)
    contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", html_escaped(chapter.anchor),
                            html_escaped(chapter.title));
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/>\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<header>\n<h1>{0}</h1>\n<nav "
      "aria-label=\"Contents\">\n<ol>\n{2}</ol>\n"
      "</nav>\n</header>\n<main>\n{3}</main>\n</body>\n</html>\n",
      html_escaped(title), page_style, contents, body);
}

}  // namespace magicmass::render
