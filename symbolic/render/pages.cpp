// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/pages.hpp"

#include <algorithm>

#include "kernel/print.hpp"
#include "render/latex.hpp"

namespace render {
namespace {
using kernel::Expr;
using kernel::Exprs;
using kernel::Op;
using Lines = std::vector<std::string>;

std::string joined(const Lines& parts, const std::string& between) {
  std::string out;
  for (const std::string& p : parts) out += (out.empty() ? "" : between) + p;
  return out;
}
template <class Print>
std::string listed(const Exprs& formulas, const Print& print, const std::string& between) {
  Lines parts;
  for (const Expr& f : formulas) parts.push_back(print(f));
  return joined(parts, between);
}
/// Broken at blanks where a line would be longer than 80 columns; an overlong word stays whole.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::string out;
  std::string line = indent;
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = text.substr(start, end - start);
    if (line.size() > indent.size() && line.size() + 1 + word.size() > 80) {
      out += line + "\n";
      line = indent + "  ";
    }
    line += (line.find_first_not_of(' ') == std::string::npos ? "" : " ") + word;
    start = end + 1;
  }
  return out + line + "\n";
}
/// A conjunction is shown a line a part.
Exprs lines_of(Expr f) { return f.op() == Op::And ? f.args() : Exprs{f}; }

std::string because(const Step& s) {
  return s.rule + (s.premises.empty() ? "" : " from " + joined(s.premises, ", "));
}
}  // namespace

std::string text_page(const std::vector<Section>& sections) {
  const auto print = [](Expr e) { return kernel::text(e); };
  std::string out;
  for (const Section& section : sections) {
    out += (out.empty() ? "" : "\n\n") + section.title + "\n" +
           std::string(section.title.size(), '=') + "\n";
    if (!section.assumptions.empty())
      out += wrapped("Throughout: " + listed(section.assumptions, print, ", ") + ".", "");
    for (const Step& s : section.steps) {
      out += "\n" + wrapped(s.words, "");
      if (!s.conditions.empty()) out += wrapped("if " + listed(s.conditions, print, " and "), "  ");
      for (const Expr& line : lines_of(s.formula)) out += wrapped(print(line), "    ");
      out += wrapped(
          "[" + s.id + "]" + (s.label.empty() ? "" : " (" + s.label + ")") + " by " + because(s),
          "  ");
    }
  }
  return out;
}
std::string markdown_page(const std::vector<Section>& sections) {
  std::string out;
  for (const Section& section : sections) {
    out += (out.empty() ? "## " : "\n## ") + section.title + "\n";
    const auto inline_math = [](Expr e) { return "$" + latex(e) + "$"; };
    if (!section.assumptions.empty())
      out += "\nThroughout: " + listed(section.assumptions, inline_math, ", ") + ".\n";
    for (const Step& s : section.steps) {
      out += "\n" + s.words + "\n";
      if (!s.conditions.empty()) out += "If " + listed(s.conditions, inline_math, " and ") + ":\n";
      for (const Expr& line : lines_of(s.formula)) out += "\n$$" + latex(line) + "$$\n";
      out += "\n`" + s.id + "`" + (s.label.empty() ? "" : " (" + s.label + ")") + ": " +
             because(s) + "\n";
    }
  }
  return out;
}
}  // namespace render
