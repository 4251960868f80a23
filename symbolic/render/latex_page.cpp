// SPDX-License-Identifier: GPL-2.0-or-later
// A document for pdflatex with nothing but texlive-latex-base and texlive-latex-recommended.
#include <algorithm>

#include <fmt/format.h>

#include "render/chapter_words.hpp"
#include "render/derivation_pages.hpp"
#include "render/formula_latex.hpp"
#include "render/prose.hpp"
#include "render/rule_words.hpp"
#include "render/steps.hpp"

namespace magicmass::render {
namespace {

constexpr double page_room = 38;  // em: 160 mm at 11 pt are 41

// \fit shrinks what is wider than the line after all: the widths that lines are broken by are estimates.
constexpr const char* preamble = R"(\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage{textcomp}
\usepackage{amsmath,amssymb}
\usepackage{graphicx}
\usepackage[margin=25mm]{geometry}
\usepackage{xcolor}
\definecolor{linkcolor}{rgb}{0.05,0.25,0.55}
\IfFileExists{hyperref.sty}{\usepackage[colorlinks,linkcolor=linkcolor]{hyperref}}{%
  \newcommand{\hypertarget}[2]{#2}\newcommand{\hyperlink}[2]{#2}}
\newsavebox{\formula}
\newcommand{\fit}[1]{\sbox{\formula}{$\displaystyle #1$}%
  \ifdim\wd\formula>\linewidth\resizebox{\linewidth}{!}{\usebox{\formula}}\else\usebox{\formula}\fi}
\newcommand{\step}[2]{\par\bigskip\noindent
  \hypertarget{step:#1}{\textbf{\texttt{\detokenize{#1}}}}\hfill\textsf{#2}\par\nobreak}
\newcommand{\premise}[1]{\hyperlink{step:#1}{\texttt{\detokenize{#1}}}}
\newcommand{\said}[2]{\par\noindent{\small\textit{#1}\enspace #2\par}}
\setlength{\parindent}{0pt}
\setlength{\emergencystretch}{6em}
\raggedright
\allowdisplaybreaks
)";

std::string prose_latex(const std::string& words) {
  std::string text;
  for (const Run& run : prose(words))
    text += run.is_formula ? "$" + latex(run.formula) + "$" : latex_escaped(run.words);
  return text;
}

std::string premise(const std::string& id, const std::vector<proof::Step>& page) {
  const bool here =
      std::any_of(page.begin(), page.end(), [&](const proof::Step& step) { return step.id == id; });
  return here ? "\\premise{" + id + "}" : "\\texttt{" + latex_escaped(id) + "}";
}

std::string step_latex(const proof::Step& step, const std::vector<proof::Step>& page) {
  std::string text = fmt::format("\\step{{{}}}{{{}}}\n", step.id, latex_escaped(step.verdict));
  if (!step.words.empty()) text += prose_latex(step.words) + "\n";
  text += fmt::format("\\[\n\\fit{{{}}}\n\\]\n",
                      latex_display(equation(step.from, step.relation, step.to), page_room));
  std::string conditions;
  for (const std::string& condition : step.conditions)
    conditions += (conditions.empty() ? "" : "; ") + prose_latex(condition);
  if (!conditions.empty()) text += fmt::format("\\said{{if}}{{{}}}\n", conditions);
  if (!step.label.empty())
    text += fmt::format("\\said{{paper}}{{\\texttt{{{}}}}}\n", latex_escaped(step.label));
  text += fmt::format("\\said{{by}}{{{}}}\n", prose_latex(rule_words(step.rule)));
  std::string premises;
  for (const std::string& id : step.premises)
    premises += (premises.empty() ? "" : ", ") + premise(id, page);
  if (!premises.empty()) text += fmt::format("\\said{{from}}{{{}}}\n", premises);
  return text;
}

std::string tree_latex(const std::vector<TreeLine>& tree, const std::vector<proof::Step>& page) {
  std::string text = "\\section*{What it rests on}\n";
  for (const TreeLine& line : tree) {
    const std::size_t indent = std::min<std::size_t>(line.depth, 12);
    text += fmt::format("{{\\leftskip={}em {}", indent, premise(line.step.id, page));
    if (line.step.verdict != "proved") text += " (" + latex_escaped(line.step.verdict) + ")";
    if (line.seen)
      text += ", see above";
    else
      text += fmt::format(
          "\\\\\n\\hspace*{{1em}}\\resizebox{{\\ifdim\\width>{0}em "
          "{0}em\\else\\width\\fi}}{{!}}{{${1}$}}",
          page_room - static_cast<double>(indent),
          latex(equation(line.step.from, line.step.relation, line.step.to)));
    text += "\\par}\\smallskip\n";
  }
  return text;
}

}  // namespace

std::string derivation_latex(const std::vector<proof::Step>& steps,
                             const std::vector<TreeLine>& tree) {
  std::string text = preamble;
  text +=
      "\\title{Magic mass ratios: the "
      "derivation}\n\\author{magicmass}\n\\date{}\n\\begin{document}\n\\maketitle\n";
  text += "\\tableofcontents\n";
  if (!tree.empty()) text += tree_latex(tree, steps);
  std::string chapter;
  for (const proof::Step& step : steps) {
    if (chapter_of(step) != chapter) {
      chapter = chapter_of(step);
      const ChapterWords words = chapter_words(chapter);
      text += fmt::format("\n\\section{{{}}}\n{}\n", latex_escaped(words.title),
                          prose_latex(words.introduction));
    }
    text += "\n" + step_latex(step, steps);
  }
  return text + "\n\\end{document}\n";
}

}  // namespace magicmass::render
