// Formulas, and a derivation as a page: text of 80 columns if words fit, Markdown, LaTeX, HTML.
#pragma once

#include "kernel/expr.hpp"

namespace render {
/// For math mode, without its delimiters: \frac{...}{...}, \begin{pmatrix}, \psi, c'_{n}.
std::string latex(kernel::Expr e);
/// One <math> element, in a line of text or on a line of its own.
std::string mathml(kernel::Expr e, bool is_block);

struct Step {
  std::string id;
  std::string label;  ///< of the paper, or empty
  std::string words;
  kernel::Expr formula;
  kernel::Exprs conditions;  ///< beyond those said at the head of its section
  std::string rule;
  std::vector<std::string> premises;  ///< ids
};
struct Section {
  std::string title;
  kernel::Exprs assumptions;
  std::vector<Step> steps;
};
/// A line; broken at blanks where longer than 80 columns; an overlong word stays whole.
std::string wrapped(const std::string& text, const std::string& indent);
std::string text_page(const std::vector<Section>& sections);
std::string markdown_page(const std::vector<Section>& sections);
/// A document for pdflatex with amsmath.
std::string latex_page(const std::vector<Section>& sections);
/// A page of its own, formulas in MathML; premises are links.
std::string html_page(const std::vector<Section>& sections);
/// What stands between its <body> tags.
std::string html_body(const std::vector<Section>& sections);
/// Words as HTML has them: &amp; for &.
std::string html_text(const std::string& words);
std::string html_link(const std::string& to, const std::string& html, const std::string& more = "");
std::string html_code(const std::string& text, const std::string& more = "");
/// A line a part of a conjunction, and of what something holds if and only if it does.
std::string html_lines(kernel::Expr e);
/// `head`: what stands there besides the title.
std::string html_page(const std::string& title, const std::string& head, const std::string& body);
}  // namespace render
